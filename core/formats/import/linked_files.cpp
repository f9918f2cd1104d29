// Finds and reads linked files, and counts what they take.
#include "linked_files.h"

#include <algorithm>
#include <filesystem>

#include "../files/atomic_file.h"
#include "../pictures/aseprite_picture.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

// The number of pixels that a picture claims; 0 if it would be refused for its size.
std::size_t pixels_of_picture(std::string_view bytes) {
  if (is_aseprite(bytes)) {
    const TileSize size = size_of_aseprite(bytes);
    const bool fits = size.width <= kMaxLinkedPictureSide && size.height <= kMaxLinkedPictureSide;
    return fits ? static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) : 0;
  }
  constexpr std::size_t kSides = 8;  // bytes
  const auto header = find_png_chunk(bytes, "IHDR");
  if (!header || header->size() < kSides) return 0;
  const auto side_at = [&](std::size_t at) {
    std::size_t side = 0;
    for (std::size_t i = at; i < at + kSides / 2; ++i)
      side = side << 8 | static_cast<std::uint8_t>((*header)[i]);
    return side <= kMaxLinkedPictureSide ? side : 0;  // a larger picture is refused without being read
  };
  return side_at(0) * side_at(kSides / 2);
}

}  // namespace

tl::unexpected<FormatError> error_in(const std::string& file, const FormatError& error) {
  return tl::unexpected(error_within("file " + file, error));
}

std::string with_slashes(std::string path) {
  std::replace(path.begin(), path.end(), '\\', '/');
  return path;
}

FormatResult<std::string> LinkedFiles::place_of(const std::string& name) const {
  std::error_code failure;
  const fs::path path(name);
  const bool is_drive = name.size() > 1 && name[1] == ':';
  if (name.find('\0') != name.npos || path.is_absolute() || is_drive || name.find("://") != name.npos)
    return error_in(name, {"", "must be relative to the folder of the map"});
  const fs::path file = fs::path(context_.folder) / path;
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
    drops_.add(of + ", " + error.place + ": " + error.message);
    LinkedPicture missing;
    missing.is_missing = true;
    return std::make_shared<const LinkedPicture>(std::move(missing));
  };
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
  const std::size_t pixels = pixels_of_picture(*bytes);
  if (pixels > kMaxLinkedPixels - pixels_) {
    return error_in(name, {"", "is too large: all pictures that a map names may have up to " +
                                   std::to_string(kMaxLinkedPixels) + " pixels together"});
  }
  pixels_ += pixels;
  auto rgba = is_aseprite(*bytes) ? read_aseprite(*bytes, kMaxLinkedPictureSide)
                                  : read_rgba(*bytes, kMaxLinkedPictureSide);
  if (!rgba) return error_in(name, rgba.error());
  const auto chunk = find_png_chunk(*bytes, "PLTE");
  LinkedPicture picture;
  picture.rgba = *std::move(rgba);
  for (std::size_t i = 0; chunk && i + 3 <= chunk->size(); i += 3)
    picture.palette.push_back({static_cast<std::uint8_t>((*chunk)[i]),
                               static_cast<std::uint8_t>((*chunk)[i + 1]),
                               static_cast<std::uint8_t>((*chunk)[i + 2])});
  return picture;
}

}  // namespace talus
