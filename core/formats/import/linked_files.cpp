// Finds and reads linked files, and counts what they take.
#include "linked_files.h"

#include <algorithm>
#include <filesystem>

#include "../files/atomic_file.h"
#include "../pictures/any_picture.h"
#include "../text/base64.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

// The number of pixels that a picture claims; 0 if it would be refused for its size.
std::size_t pixels_of_picture(std::string_view bytes) {
  const TileSize size = size_of_picture(bytes);
  const bool fits = size.width <= kMaxLinkedPictureSide && size.height <= kMaxLinkedPictureSide;
  return fits ? static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) : 0;
}

// names: null: nobody asks for them. A file may name a million others.
void add_once(const std::string& name, std::vector<std::string>* names) {
  constexpr std::size_t kMax = 1000;
  if (names == nullptr || names->size() == kMax) return;
  if (std::find(names->begin(), names->end(), name) == names->end()) names->push_back(name);
}

}  // namespace

tl::unexpected<FormatError> error_in(const std::string& file, const FormatError& error) {
  return tl::unexpected(error_within("file " + file, error));
}

std::string with_slashes(std::string path) {
  std::replace(path.begin(), path.end(), '\\', '/');
  return path;
}

LinkedFiles::LinkedFiles(const FormatContext& context, ImportDrops& drops)
    : context_(context), drops_(drops), folders_(context.choices.outside) {
  if (context.folder.empty()) return;
  if (auto own = real_path(context.folder)) folders_.push_back(*std::move(own));
}

// real: from real_path().
bool LinkedFiles::may_be_read(const std::string& real) const {
  return std::any_of(folders_.begin(), folders_.end(),
                     [&](const std::string& folder) { return is_within(real, folder); });
}

void LinkedFiles::refuse(const std::string& name) { add_once(name, context_.refused); }

void LinkedFiles::note_missing(const std::string& name) const { add_once(name, context_.missing); }

FormatResult<std::string> LinkedFiles::place_of(const std::string& name) {
  std::error_code failure;
  const fs::path path(name);
  const bool is_drive = name.size() > 1 && name[1] == ':';
  if (name.find('\0') != name.npos || path.is_absolute() || is_drive || name.find("://") != name.npos)
    return error_in(name, {"", "must be relative to the folder of the map"});
  const fs::path file = fs::path(context_.folder) / path;
  const auto real = real_path(file.string());
  if (!real) return error_in(name, real.error());
  if (!may_be_read(*real)) {
    refuse(name);
    return error_in(name, {"", "lies outside of the folder of the map, and was not read"});
  }
  if (fs::exists(file, failure) && !fs::is_regular_file(file, failure))
    return error_in(name, {"", "is not a file"});
  return file.string();
}

void LinkedFiles::note(const std::string& place) const {
  if (context_.linked != nullptr) context_.linked->push_back(place);
}

// The limit is for all files together: a thousand tilesets could name one large file each.
FormatResult<std::string> LinkedFiles::read(const std::string& name, const std::string& place,
                                            std::size_t most) {
  std::error_code failure;
  const auto size = fs::file_size(place, failure);
  if (!failure && size <= most && size > kMaxFileBytes - bytes_) {
    return error_in(name, {"", "is too large: all files that a map names may have up to " +
                                   std::to_string(kMaxFileBytes >> 20) + " MiB together"});
  }
  note(place);
  auto bytes = read_file(place, std::min(most, kMaxFileBytes - bytes_));
  if (!bytes) return error_in(name, bytes.error());
  bytes_ += bytes->size();
  return bytes;
}

std::shared_ptr<const LinkedPicture> LinkedFiles::picture(const std::string& name, const std::string& of) {
  const auto dropped = [&](const FormatError& error) {
    if (!is_data_name(name)) note_missing(with_slashes(name));
    drops_.add(of + ", " + (error.place.empty() ? "which" : error.place + ":") + " " + error.message);
    LinkedPicture missing;
    missing.is_missing = true;
    return std::make_shared<const LinkedPicture>(std::move(missing));
  };
  if (is_data_name(name)) {
    auto picture = picture_in(name);
    return picture ? std::make_shared<const LinkedPicture>(*std::move(picture)) : dropped(picture.error());
  }
  const std::string path = with_slashes(name);
  const auto place = place_of(path);
  if (!place) return dropped(place.error());
  const auto number = file_number(*place);
  if (const auto known = number ? pictures_.find(*number) : pictures_.end(); known != pictures_.end())
    return known->second;
  auto picture = read_picture(path, *place);
  const auto shared =
      picture ? std::make_shared<const LinkedPicture>(*std::move(picture)) : dropped(picture.error());
  if (number) pictures_[*number] = shared;
  return shared;
}

FormatResult<LinkedPicture> LinkedFiles::read_picture(const std::string& name, const std::string& place) {
  const auto bytes = read(name, place);
  if (!bytes) return tl::unexpected(bytes.error());
  auto picture = decode(*bytes);
  if (!picture) return error_in(name, picture.error());
  picture->path = place;
  return picture;
}

FormatResult<LinkedPicture> LinkedFiles::picture_in(std::string_view data_name) {
  constexpr std::string_view kBase64 = ";base64,";
  const std::size_t at = data_name.substr(0, 64).find(kBase64);
  const auto bytes =
      at == data_name.npos ? std::nullopt : decode_base64(data_name.substr(at + kBase64.size()));
  if (!bytes) return tl::unexpected(FormatError{"", "is not in Base64"});
  return decode(*bytes);
}

FormatResult<LinkedPicture> LinkedFiles::decode(std::string_view bytes) {
  const std::size_t pixels = pixels_of_picture(bytes);
  if (pixels > kMaxLinkedPixels - pixels_) {
    return tl::unexpected(FormatError{"", "is too large: all pictures that a map names may have up to " +
                                              std::to_string(kMaxLinkedPixels) + " pixels together"});
  }
  pixels_ += pixels;
  auto rgba = talus::read_picture(bytes, kMaxLinkedPictureSide);
  if (!rgba) return tl::unexpected(rgba.error());
  const auto chunk = find_png_chunk(bytes, "PLTE");
  LinkedPicture picture;
  picture.rgba = *std::move(rgba);
  for (std::size_t i = 0; chunk && i + 3 <= chunk->size(); i += 3)
    picture.palette.push_back({static_cast<std::uint8_t>((*chunk)[i]),
                               static_cast<std::uint8_t>((*chunk)[i + 1]),
                               static_cast<std::uint8_t>((*chunk)[i + 2])});
  return picture;
}

}  // namespace talus
