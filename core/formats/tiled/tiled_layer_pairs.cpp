#include "tiled_layer_pairs.h"

#include <algorithm>

namespace talus {
namespace {

// The number of equal cells; -1 if there is another number of cells.
std::ptrdiff_t equal_cells(const MapCells& a, const MapCells& b) {
  if (a.size() != b.size()) return -1;
  std::ptrdiff_t equal = 0;
  for (std::size_t i = 0; i < a.size(); ++i) equal += a[i] == b[i] ? 1 : 0;
  return equal;
}

bool is_blank(const MapCells& cells) {
  return std::all_of(cells.tiles().begin(), cells.tiles().end(), [](TileNumber tile) { return tile == 0; });
}

}  // namespace

bool has_same_names(const std::vector<TileLayer>& a, const std::vector<TileLayer>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const TileLayer& x, const TileLayer& y) { return x.name == y.name; });
}

std::vector<int> pairs_of_tile_layers(const Level& opened, const Level& level) {
  std::vector<int> pairs(level.layers.list.size(), -1);
  std::vector<bool> is_taken(opened.layers.list.size());
  const auto match = [&](const auto& fits) {
    for (int k = 0; k < level.layers.count(); ++k) {
      int& pair = pairs[static_cast<std::size_t>(k)];
      for (int i = 0; i < opened.layers.count() && pair < 0; ++i) {
        if (is_taken[static_cast<std::size_t>(i)] || !fits(i, k)) continue;
        pair = i;
        is_taken[static_cast<std::size_t>(i)] = true;
      }
    }
  };
  const auto name = [](const Level& its, int layer) {
    return its.layers.list[static_cast<std::size_t>(layer)].name;
  };
  const auto cells = [&](int i, int k) { return equal_cells(opened.cells_of(i), level.cells_of(k)); };
  const auto all = static_cast<std::ptrdiff_t>(level.map.cells().size());
  match([&](int i, int k) { return name(opened, i) == name(level, k) && cells(i, k) == all; });
  match([&](int i, int k) { return !is_blank(level.cells_of(k)) && cells(i, k) == all; });
  match([&](int i, int k) { return name(opened, i) == name(level, k); });
  match([&](int i, int k) { return cells(i, k) * 2 >= all && opened.layers.list.size() == pairs.size(); });
  return pairs;
}

}  // namespace talus
