#include "file_picture.h"

#include <chrono>
#include <filesystem>

#include <talus/formats/format.h>
#include <talus/sim/scene.h>
#include "formats/files/atomic_file.h"
#include "formats/pictures/any_picture.h"
#include "formats/pictures/png_picture.h"
#include "panels/window/area_picture.h"
#include "recent_pictures.h"

namespace talus {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::uintmax_t kMaxPreviewFileBytes = 1 << 20;
constexpr int kMaxSide = 1024;                             // px, of a picture
constexpr auto kMaxTime = std::chrono::milliseconds(300);  // for a level, so that the dialog does not hang

std::shared_ptr<const SheetPicture> picture_of_level(const std::string& path) {
  const auto end = Clock::now() + kMaxTime;
  const Progress progress([end](double) { return Clock::now() < end; });
  const auto loaded = load_level(path, {}, progress.part(0, 0.5));
  if (!loaded) return nullptr;
  const auto scene = compile_scene(loaded->level, progress.part(0.5, 1).function());
  if (!scene) return nullptr;
  return picture_of_start(loaded->level, initial_state(*scene), RecentPictures::kWidth,
                          RecentPictures::kHeight);
}

}  // namespace

std::shared_ptr<const SheetPicture> picture_in_file(const std::string& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error) || fs::file_size(path, error) > kMaxPreviewFileBytes || error)
    return nullptr;
  const auto bytes = read_file(path);
  if (!bytes) return nullptr;
  if (const auto picture = read_picture(*bytes, kMaxSide)) return shared_picture(*picture);
  return picture_of_level(path);
}

}  // namespace talus
