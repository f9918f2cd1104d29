// MapList: the maps of a folder, or several maps, to go through one after the other.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace talus {

class MapList {
 public:
  static constexpr std::size_t kMost = 10'000;  // maps

  // Lists files as they are, and of folders the maps in them. deep: and in the folders within. Links to
  // folders are not followed.
  void list(const std::vector<std::string>& paths, bool deep);
  const std::vector<std::string>& files() const { return files_; }
  // The index of the map that was opened last; nothing: another file was.
  std::optional<std::size_t> current() const;
  void note_opened(const std::string& path) { opened_ = path; }
  // The map so many places behind the one that was opened last, in a circle. Lists the folder of that one if
  // it is not in the list. Empty: there is no other map.
  std::string beside(int step);

 private:
  std::vector<std::string> files_;
  std::string opened_;  // empty: nothing
};

}  // namespace talus
