// What was dropped, as phrases.
#include "tiled_map.h"

#include "utf8_text.h"

namespace talus {

std::vector<std::string> TiledDrops::phrases() const {
  std::vector<std::string> phrases;
  constexpr std::size_t kMostShown = 200;  // bytes; names in files may be of any length
  for (const auto& [phrase, count] : counts_) {
    const std::string shown = printable(shortened(phrase, kMostShown));
    phrases.push_back(count == 1 ? shown : shown + " (" + std::to_string(count) + " times)");
  }
  return phrases;
}

}  // namespace talus
