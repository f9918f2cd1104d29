#include "link_target.h"

#include <filesystem>

#include "real_path.h"

namespace talus {

std::string link_target(const std::string& path) {
  std::error_code ignored;
  const bool is_link = std::filesystem::is_symlink(std::filesystem::symlink_status(path, ignored));
  return is_link ? real_path(path).value_or("") : "";
}

}  // namespace talus
