#include "keep_aside.h"

#include <filesystem>

namespace talus {

FormatResult<std::string> keep_aside(const std::string& path) {
  namespace fs = std::filesystem;
  const fs::path file(path);
  std::error_code error;
  fs::path kept;
  for (int n = 1; kept.empty() || fs::exists(fs::symlink_status(kept, error)); ++n)
    kept =
        file.parent_path() / (file.stem().string() + "-kept" + std::to_string(n) + file.extension().string());
  fs::rename(file, kept, error);
  if (error) return tl::unexpected(FormatError{"", "cannot be kept under another name: " + error.message()});
  return kept.string();
}

}  // namespace talus
