// Lists maps by their names.
#include "map_list.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>

#include <talus/formats/format.h>

namespace talus {
namespace {

namespace fs = std::filesystem;

constexpr int kMostEntries = 200'000;  // looked at in all
constexpr int kDeepest = 16;           // folders within each other

// Pictures, tilesets and texts of programs are no maps, and neither are companions.
bool is_map(const fs::path& path) {
  constexpr std::array<std::string_view, 5> kEndings = {".tmx", ".tmj", ".ldtk", ".tic", ".talus.json"};
  const std::string name = path.filename().string();
  const bool has_ending = std::any_of(kEndings.begin(), kEndings.end(),
                                      [&](std::string_view ending) { return name.ends_with(ending); });
  return has_ending && level_path(path.string()) == path.string();
}

void add_maps(const fs::path& folder, bool deep, std::vector<std::string>& files) {
  std::error_code error;
  fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error);
  for (int looked = 0; !error && at != fs::recursive_directory_iterator() && looked < kMostEntries;
       ++looked) {
    std::error_code ignored;
    if (at->is_directory(ignored)) {
      if (!deep || at.depth() >= kDeepest) at.disable_recursion_pending();
    } else if (files.size() < MapList::kMost && at->is_regular_file(ignored) && is_map(at->path())) {
      files.push_back(at->path().string());
    }
    at.increment(error);
  }
}

}  // namespace

void MapList::list(const std::vector<std::string>& paths, bool deep) {
  files_.clear();
  for (const std::string& path : paths) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored))
      add_maps(path, deep, files_);
    else if (files_.size() < kMost)
      files_.push_back(path);
  }
  std::sort(files_.begin(), files_.end());
  files_.erase(std::unique(files_.begin(), files_.end()), files_.end());
}

std::optional<std::size_t> MapList::current() const {
  const auto found = std::find(files_.begin(), files_.end(), opened_);
  if (found == files_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - files_.begin());
}

std::string MapList::beside(int step) {
  if (opened_.empty()) return "";
  if (!current()) list({fs::path(opened_).parent_path().string()}, false);
  if (files_.empty()) return "";
  const auto count = static_cast<std::ptrdiff_t>(files_.size());
  const auto at = static_cast<std::ptrdiff_t>(current().value_or(0));
  const std::string& next = files_[static_cast<std::size_t>(((at + step) % count + count) % count)];
  return next == opened_ ? "" : next;
}

}  // namespace talus
