// Lists maps by their names.
#include "map_list.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "formats/files/atomic_file.h"
#include "formats/native/companion.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = 16;          // folders within each other
constexpr std::size_t kStart = 4096;  // bytes that tell a companion

// Whether Talus wrote it beside a map. Companions may be huge.
bool is_beside_map(const std::string& path) {
  const std::string owner = owner_of_companion(path);
  std::error_code ignored;
  return !owner.empty() && fs::exists(owner, ignored) &&
         begins_as_companion(read_start_of_file(path, kStart).value_or(""));
}

// Pictures, tilesets and texts of programs are no maps, and neither are companions.
bool is_map(const fs::path& path) {
  constexpr std::array<std::string_view, 5> kEndings = {".tmx", ".tmj", ".ldtk", ".tic", ".talus.json"};
  const std::string name = path.filename().string();
  const bool has_ending = std::any_of(kEndings.begin(), kEndings.end(),
                                      [&](std::string_view ending) { return name.ends_with(ending); });
  return has_ending && !is_beside_map(path.string());
}

}  // namespace

void MapList::add_maps(const std::string& folder, bool deep, int& looked, const Progress& progress) {
  std::error_code error;
  fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error);
  for (; !error && at != fs::recursive_directory_iterator(); ++looked) {
    is_cut_ = is_cut_ || looked >= kMaxEntries || files_.size() >= kMax;
    if (is_cut_ || !progress.at(looked, kMaxEntries)) return;
    std::error_code ignored;
    if (at->is_directory(ignored)) {
      if (!deep || at.depth() >= kDeepest) at.disable_recursion_pending();
    } else if (at->is_regular_file(ignored) && is_map(at->path())) {
      files_.push_back(at->path().string());
    }
    at.increment(error);
  }
}

void MapList::list(const std::vector<std::string>& paths, bool deep, const Progress& progress) {
  files_.clear();
  is_cut_ = false;
  int looked = 0;
  for (const std::string& path : paths) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored))
      add_maps(path, deep, looked, progress);
    else if (files_.size() < kMax)
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

std::string MapList::beside(int step) const {
  if (files_.empty()) return "";
  const auto count = static_cast<std::ptrdiff_t>(files_.size());
  const auto at = static_cast<std::ptrdiff_t>(current().value_or(0));
  const std::string& next = files_[static_cast<std::size_t>(((at + step) % count + count) % count)];
  return next == opened_ ? "" : next;
}

}  // namespace talus
