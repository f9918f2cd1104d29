#include "flag_search.h"

namespace talus {

FlagUse find_flag_use(const Level& level, FlagPattern pattern) {
  FlagUse use;
  use.cells.resize(static_cast<std::size_t>(level.tile_count()));
  for (const TileNumber tile : level.map.cells()) ++use.cells[tile];
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
                                      bool forwards, int tile) {
  const auto cells = level.map.cells();
  const auto count = static_cast<std::ptrdiff_t>(cells.size());
  const std::ptrdiff_t width = level.map.width(), step = forwards ? 1 : -1;
  const bool inside = from && level.map.contains(*from);
  std::ptrdiff_t at = inside ? from->y * width + from->x : forwards ? -1 : count;
  for (std::ptrdiff_t looked_at = 0; looked_at < count; ++looked_at) {
    at = (at + step + count) % count;
    const TileNumber found = cells[static_cast<std::size_t>(at)];
    if ((tile < 0 || tile == found) && pattern.matches(level.tile_flags(found)))
      return Cell{static_cast<int>(at % width), static_cast<int>(at / width)};
  }
  return {};
}

}  // namespace talus
