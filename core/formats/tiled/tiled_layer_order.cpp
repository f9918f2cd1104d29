#include "tiled_layer_order.h"

namespace talus {

// The longest sequence of ascending numbers, in the square of the number of layers, of which there are at
// most kMaxTiledLayers.
std::vector<bool> layers_that_stay(const std::vector<int>& places) {
  std::vector<bool> stays(places.size());
  std::vector<int> length(places.size()), previous(places.size(), -1);
  int last = -1;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i] < 0) continue;
    length[i] = 1;
    for (std::size_t k = 0; k < i; ++k) {
      if (places[k] < 0 || places[k] >= places[i] || length[k] < length[i]) continue;
      length[i] = length[k] + 1;
      previous[i] = static_cast<int>(k);
    }
    if (last < 0 || length[i] > length[static_cast<std::size_t>(last)]) last = static_cast<int>(i);
  }
  for (; last >= 0; last = previous[static_cast<std::size_t>(last)])
    stays[static_cast<std::size_t>(last)] = true;
  return stays;
}

}  // namespace talus
