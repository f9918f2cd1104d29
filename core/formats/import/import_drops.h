// ImportDrops: what a reader of another program's files finds and cannot keep.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace talus {

// Returns a name in quotes, for messages. Names in files may be of any length, so a long one is cut.
std::string quoted_name(std::string_view name);

// Keeps each thing once.
class ImportDrops {
 public:
  // Cuts the phrase to 200 bytes. Of different phrases it keeps the first 1000, and counts how often others
  // came.
  void add(std::string_view phrase);
  // In alphabetical order. A thing that was found several times has its count: "the animation of a tile (3
  // times)". If some were not kept, the last one is "and 234 more".
  std::vector<std::string> phrases() const;

 private:
  std::map<std::string, int> counts_;
  std::size_t more_ = 0;
};

}  // namespace talus
