// Looks beside the program first, so that a build can be installed anywhere.
#include "asset_path.h"

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

}  // namespace talus
