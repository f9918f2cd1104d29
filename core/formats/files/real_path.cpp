// Goes part by part, as the system does, but also past the first part that does not exist.
#include "real_path.h"

#include <sys/stat.h>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <system_error>

namespace talus {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxLinks = 40;  // the kernel's limit; a longer chain is a circle

}  // namespace

FormatResult<std::string> real_path(const std::string& path) {
  std::error_code error;
  const fs::path whole = fs::absolute(path.empty() ? "." : path, error);
  if (error) return tl::unexpected(FormatError{"", "cannot be found: " + error.message()});
  fs::path real = "/";
  std::deque<fs::path> rest(whole.begin(), whole.end());
  for (int links = 0; !rest.empty();) {
    const fs::path part = rest.front();
    rest.pop_front();
    if (part.empty() || part == "." || part.is_absolute()) continue;
    if (part == "..") {
      real = real.parent_path();
      continue;
    }
    const fs::path target = fs::read_symlink(real / part, error);
    if (error) {  // not a link
      real /= part;
      continue;
    }
    if (++links > kMaxLinks) return tl::unexpected(FormatError{"", "leads through links in a circle"});
    if (target.is_absolute()) real = "/";
    rest.insert(rest.begin(), target.begin(), target.end());
  }
  return real.string();
}

FormatResult<std::string> real_folder_of(const std::string& file) {
  return real_path(fs::path(file).parent_path().string());
}

std::string last_name(const std::string& path) {
  const fs::path whole(path);
  const fs::path name = whole.has_filename() ? whole.filename() : whole.parent_path().filename();
  return name.empty() ? path : name.string();
}

bool is_within(const std::string& place, const std::string& folder) {
  const fs::path inner(place), outer(folder);
  const auto [end, unused] = std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end());
  return end == outer.end();
}

std::optional<FileNumber> file_number(const std::string& path) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0) return std::nullopt;
  return FileNumber{status.st_dev, status.st_ino};
}

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  return fs::equivalent(a, b, ignored);
}

}  // namespace talus
