// MapList: the maps of a folder, or several maps, to go through one after the other.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <talus/level/progress.h>

namespace talus {

class MapList {
 public:
  static constexpr std::size_t kMax = 10'000;  // maps
  static constexpr int kMaxEntries = 200'000;  // files and folders that are looked at

  // Lists files as they are, and of folders the maps in them. deep: and in the folders within. Links to
  // folders are not followed. A stop by `progress` leaves some out.
  void list(const std::vector<std::string>& paths, bool deep, const Progress& progress = {});
  // Whether folders hold more than was looked at.
  bool is_cut() const { return is_cut_; }
  const std::vector<std::string>& files() const { return files_; }
  // The index of the map that was opened last; nothing: another file was.
  std::optional<std::size_t> current() const;
  void note_opened(const std::string& path) { opened_ = path; }
  const std::string& opened() const { return opened_; }  // empty: nothing
  // The map so many places behind the one that was opened last, in a circle. Empty: there is no other map.
  std::string beside(int step) const;

 private:
  void add_maps(const std::string& folder, bool deep, int& looked, const Progress& progress);

  std::vector<std::string> files_;
  bool is_cut_ = false;
  std::string opened_;
};

}  // namespace talus
