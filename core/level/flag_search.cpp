#include "flag_search.h"

#include <numeric>

namespace talus {
namespace {

// The indices of the layers.
std::vector<int> layers_to_search(const Level& level, SearchedLayers layers) {
  if (layers == SearchedLayers::chosen) return {level.layers.chosen};
  std::vector<int> all(level.layers.list.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

// Whether a layer shows a tile at all: tile 0 is empty in front of another layer.
bool is_shown(int layer, TileNumber tile) { return tile != 0 || layer == 0; }

}  // namespace

FlagUse find_flag_use(const Level& level, FlagPattern pattern, SearchedLayers layers) {
  FlagUse use;
  use.cells.resize(static_cast<std::size_t>(level.tile_count()));
  for (const int layer : layers_to_search(level, layers)) {
    for (const TileNumber tile : level.cells_of(layer).tiles())
      if (is_shown(layer, tile)) ++use.cells[tile];
  }
  for (int tile = 0; tile < level.tile_count(); ++tile) {
    std::size_t& cells = use.cells[static_cast<std::size_t>(tile)];
    if (pattern.matches(level.tile_flags(static_cast<TileNumber>(tile)))) {
      use.tiles.push_back(tile);
      use.cell_count += cells;
    } else {
      cells = 0;
    }
  }
  return use;
}

std::optional<Cell> find_flagged_cell(const Level& level, FlagPattern pattern, std::optional<Cell> from,
                                      bool forwards, int tile, SearchedLayers layers) {
  const std::vector<int> searched = layers_to_search(level, layers);
  const auto matches = [&](int layer, std::size_t at) {
    const TileNumber found = level.cells_of(layer).tiles()[at];
    return (tile < 0 || tile == found) && is_shown(layer, found) && pattern.matches(level.tile_flags(found));
  };
  const auto count = static_cast<std::ptrdiff_t>(level.map.cells().size());
  const std::ptrdiff_t width = level.map.width(), step = forwards ? 1 : -1;
  const bool inside = from && level.map.contains(*from);
  std::ptrdiff_t at = inside ? from->y * width + from->x : forwards ? -1 : count;
  for (std::ptrdiff_t looked_at = 0; looked_at < count; ++looked_at) {
    at = (at + step + count) % count;
    for (const int layer : searched)
      if (matches(layer, static_cast<std::size_t>(at)))
        return Cell{static_cast<int>(at % width), static_cast<int>(at / width)};
  }
  return {};
}

}  // namespace talus
