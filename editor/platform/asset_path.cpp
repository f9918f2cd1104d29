// Looks beside the program first, so that a build can be installed anywhere.
#include "asset_path.h"

#include <algorithm>
#include <filesystem>

namespace talus {

std::string asset_path(std::string_view name) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    const fs::path installed = program.parent_path().parent_path() / "share/talus/assets" / name;
    if (fs::exists(installed, error)) return installed.string();
  }
  return (fs::path(TALUS_ASSET_DIR) / name).string();
}

std::vector<std::string> scene_paths() {
  return {asset_path("demo.talus.json"), asset_path("platformer/meadow.tmx"), asset_path("cave.talus.json"),
          asset_path("yard.talus.json")};
}

std::vector<std::string> hard_case_paths() {
  std::vector<std::string> paths;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(asset_path("hard_cases"), error)) {
    if (entry.path().extension() == ".json") paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

}  // namespace talus
