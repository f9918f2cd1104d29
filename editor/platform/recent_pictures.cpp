#include "recent_pictures.h"

#include <array>
#include <charconv>
#include <filesystem>
#include <set>

#include "formats/files/atomic_file.h"
#include "formats/last_catch.h"
#include "formats/pictures/png_picture.h"
#include "formats/text/content_hash.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxBytes = 512 << 10;  // of a file

}  // namespace

// By a hash of the path: the names of the files in the folder tell nothing.
std::string RecentPictures::place_of(const std::string& file) const {
  std::array<char, 16> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), content_hash(file), 16).ptr;
  return folder_ + "/" + std::string(digits.data(), end) + ".png";
}

void RecentPictures::keep(const SheetPicture& picture, const std::string& file,
                          const std::vector<std::string>& recent) const {
  const std::string png = encode_png(picture.width, picture.height, 4, picture.rgba.data());
  std::error_code ignored;
  fs::create_directories(folder_, ignored);
  (void)write_file_atomic(place_of(file), png);
  std::set<std::string> kept;
  for (const std::string& other : recent) kept.insert(place_of(other));
  for (fs::directory_iterator entry(folder_, ignored), end; entry != end; entry.increment(ignored)) {
    const std::string path = entry->path().string();
    if (path.ends_with(".png") && !kept.contains(path)) fs::remove(path, ignored);
    if (ignored) break;
  }
}

std::shared_ptr<const SheetPicture> RecentPictures::find(const std::string& file) const {
  const auto bytes = read_file(place_of(file), kMaxBytes);
  if (!bytes) return nullptr;
  const auto picture = read_guarded([&] { return read_rgba(*bytes, kWidth); });
  if (!picture || picture->height > kHeight) return nullptr;
  return std::make_shared<const SheetPicture>(
      SheetPicture{picture->width, picture->height, {picture->bytes.begin(), picture->bytes.end()}});
}

}  // namespace talus
