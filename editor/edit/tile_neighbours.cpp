// Counts which tiles lie around some tiles on the map.
#include "tile_neighbours.h"

#include <algorithm>
#include <map>

#include <talus/level/tileset.h>

namespace talus {
namespace {

TileNeighbours empty_ring(CellRect tiles) {
  TileNeighbours n{tiles.w, tiles.h, {}};
  n.ring.resize(static_cast<std::size_t>(tiles.w + 2) * (tiles.h + 2));
  return n;
}

// A cell of the ring, the tile of the rectangle beside it, and the direction from there.
struct RingCell {
  std::size_t index;
  int tile;
  Cell step;
};

std::vector<RingCell> ring_cells(const SheetLayout& sheet, CellRect tiles) {
  std::vector<RingCell> cells;
  for (int y = -1; y <= tiles.h; ++y) {
    for (int x = -1; x <= tiles.w; ++x) {
      const int inner_x = std::clamp(x, 0, tiles.w - 1), inner_y = std::clamp(y, 0, tiles.h - 1);
      if (x == inner_x && y == inner_y) continue;
      const auto index = static_cast<std::size_t>(y + 1) * (tiles.w + 2) + x + 1;
      const Cell inner{tiles.x + inner_x, tiles.y + inner_y};
      if (sheet.contains(inner)) cells.push_back({index, sheet.tile_at(inner), {x - inner_x, y - inner_y}});
    }
  }
  return cells;
}

}  // namespace

std::optional<Cell> place_of_tiles(const Level& level, CellRect tiles, Cell cell) {
  const TileMap& map = level.map;
  if (!map.contains(cell)) return std::nullopt;
  const SheetLayout sheet = level.sheet(SheetId::tiles).layout();
  const Cell on_sheet = sheet.place_of(map.tile_at(cell));
  const Cell inside{on_sheet.x - tiles.x, on_sheet.y - tiles.y};
  if (inside.x < 0 || inside.y < 0 || inside.x >= tiles.w || inside.y >= tiles.h) return std::nullopt;
  const Cell place{cell.x - inside.x, cell.y - inside.y};
  for (int y = 0; y < tiles.h; ++y) {
    for (int x = 0; x < tiles.w; ++x) {
      const Cell at{place.x + x, place.y + y};
      if (!map.contains(at) || map.tile_at(at) != sheet.tile_at({tiles.x + x, tiles.y + y}))
        return std::nullopt;
    }
  }
  return place;
}

TileNeighbours neighbours_at(const TileMap& map, CellRect tiles, Cell place) {
  TileNeighbours n = empty_ring(tiles);
  for (int y = -1; y <= tiles.h; ++y) {
    for (int x = -1; x <= tiles.w; ++x) {
      const Cell at{place.x + x, place.y + y};
      const bool inside = x >= 0 && y >= 0 && x < tiles.w && y < tiles.h;
      if (!inside && map.contains(at))
        n.ring[static_cast<std::size_t>(y + 1) * (tiles.w + 2) + x + 1] = map.tile_at(at);
    }
  }
  return n;
}

TileNeighbours commonest_neighbours(const Level& level, CellRect tiles) {
  const TileMap& map = level.map;
  const std::vector<RingCell> cells = ring_cells(level.sheet(SheetId::tiles).layout(), tiles);
  std::vector<std::vector<const RingCell*>> cells_of_tile(static_cast<std::size_t>(level.tile_count()));
  for (const RingCell& c : cells) cells_of_tile[static_cast<std::size_t>(c.tile)].push_back(&c);
  TileNeighbours n = empty_ring(tiles);
  std::vector<std::map<TileNumber, int>> counts(n.ring.size());  // by tile beside the cell
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      for (const RingCell* c : cells_of_tile[map.tile_at({x, y})]) {
        const Cell at{x + c->step.x, y + c->step.y};
        if (map.contains(at)) ++counts[c->index][map.tile_at(at)];
      }
    }
  }
  for (const RingCell& c : cells) {
    const auto& count = counts[c.index];
    const auto most = std::max_element(count.begin(), count.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most != count.end()) n.ring[c.index] = most->first;
  }
  return n;
}

}  // namespace talus
