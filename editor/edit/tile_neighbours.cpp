// Counts neighbours.
#include "tile_neighbours.h"

#include <algorithm>
#include <array>

#include <talus/level/tileset.h>

namespace talus {
namespace {

TileNeighbours empty_ring(CellRect tiles) {
  TileNeighbours n{tiles.w, tiles.h, {}};
  n.ring.resize(static_cast<std::size_t>(tiles.w + 2) * (tiles.h + 2));
  return n;
}

int tile_of(CellRect tiles, int x, int y) { return (tiles.y + y) * kSheetColumns + tiles.x + x; }

// A cell of the ring, the tile of the rectangle beside it, and the direction from there.
struct RingCell {
  std::size_t index;
  int tile;
  Cell step;
};

std::vector<RingCell> ring_cells(CellRect tiles) {
  std::vector<RingCell> cells;
  for (int y = -1; y <= tiles.h; ++y) {
    for (int x = -1; x <= tiles.w; ++x) {
      const int inner_x = std::clamp(x, 0, tiles.w - 1), inner_y = std::clamp(y, 0, tiles.h - 1);
      if (x == inner_x && y == inner_y) continue;
      const auto index = static_cast<std::size_t>(y + 1) * (tiles.w + 2) + x + 1;
      cells.push_back({index, tile_of(tiles, inner_x, inner_y), {x - inner_x, y - inner_y}});
    }
  }
  return cells;
}

}  // namespace

std::optional<Cell> place_of_tiles(const TileMap& map, CellRect tiles, Cell cell) {
  if (!map.contains(cell)) return std::nullopt;
  const int tile = map.at(cell);
  const Cell inside{tile % kSheetColumns - tiles.x, tile / kSheetColumns - tiles.y};
  if (inside.x < 0 || inside.y < 0 || inside.x >= tiles.w || inside.y >= tiles.h) return std::nullopt;
  const Cell place{cell.x - inside.x, cell.y - inside.y};
  for (int y = 0; y < tiles.h; ++y) {
    for (int x = 0; x < tiles.w; ++x) {
      const Cell at{place.x + x, place.y + y};
      if (!map.contains(at) || map.at(at) != tile_of(tiles, x, y)) return std::nullopt;
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
        n.ring[static_cast<std::size_t>(y + 1) * (tiles.w + 2) + x + 1] = map.at(at);
    }
  }
  return n;
}

TileNeighbours commonest_neighbours(const TileMap& map, CellRect tiles) {
  const std::vector<RingCell> cells = ring_cells(tiles);
  std::array<std::vector<const RingCell*>, kTileCount> cells_of_tile;
  for (const RingCell& c : cells) cells_of_tile[static_cast<std::size_t>(c.tile)].push_back(&c);
  TileNeighbours n = empty_ring(tiles);
  std::vector<std::array<int, kTileCount>> counts(n.ring.size());
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      for (const RingCell* c : cells_of_tile[map.at({x, y})]) {
        const Cell at{x + c->step.x, y + c->step.y};
        if (map.contains(at)) ++counts[c->index][map.at(at)];
      }
    }
  }
  for (const RingCell& c : cells) {
    const auto& count = counts[c.index];
    const auto most = std::max_element(count.begin(), count.end());
    if (*most > 0) n.ring[c.index] = static_cast<std::uint8_t>(most - count.begin());
  }
  return n;
}

}  // namespace talus
