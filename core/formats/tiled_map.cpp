// What was dropped, as phrases.
#include "tiled_map.h"

namespace talus {

std::vector<std::string> TiledDrops::phrases() const {
  std::vector<std::string> phrases;
  for (const auto& [phrase, count] : counts_)
    phrases.push_back(count == 1 ? phrase : phrase + " (" + std::to_string(count) + " times)");
  return phrases;
}

}  // namespace talus
