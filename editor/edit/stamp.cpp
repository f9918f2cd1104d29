// Takes and repeats stamps.
#include "stamp.h"

namespace talus {
namespace {

template <class TileAt>
Stamp stamp_of(CellRect cells, CellRect room, TileAt tile_at) {
  const auto part = shared(cells, room);
  if (!part) return {};
  Stamp stamp{part->w, part->h, {}};
  for (int y = part->y; y < part->y + part->h; ++y) {
    for (int x = part->x; x < part->x + part->w; ++x) stamp.tiles.push_back(tile_at(x, y));
  }
  return stamp;
}

int floor_divide(int a, int b) { return a / b - (a % b < 0 ? 1 : 0); }  // b > 0

}  // namespace

Stamp stamp_of_sheet(const SheetLayout& sheet, CellRect tiles) {
  return stamp_of(tiles, {0, 0, sheet.columns, sheet.rows()}, [&](int x, int y) {
    return MapCell(sheet.contains({x, y}) ? static_cast<TileNumber>(sheet.tile_at({x, y})) : TileNumber{0});
  });
}

Stamp stamp_of_tiles(const SheetLayout& sheet, CellRect tiles, TileNumber first) {
  Stamp stamp = stamp_of_sheet(sheet, tiles);
  if (tiles.contains({0, 0}) && stamp.tiles.size() > 1) stamp.tiles.front() = MapCell(first);
  return stamp;
}

Stamp stamp_of_map(const Level& level, CellRect cells) {
  return stamp_of(cells, {0, 0, level.map.width(), level.map.height()}, [&](int x, int y) {
    return level.map.at({x, y});
  });
}

Cell corner_of_repeated(const Stamp& stamp, Cell origin, Cell cell) {
  return {origin.x + floor_divide(cell.x - origin.x, stamp.w) * stamp.w,
          origin.y + floor_divide(cell.y - origin.y, stamp.h) * stamp.h};
}

MapCell repeated_tile(const Stamp& stamp, Cell origin, Cell cell) {
  const Cell corner = corner_of_repeated(stamp, origin, cell);
  return stamp.at(cell.x - corner.x, cell.y - corner.y);
}

Stamp turned(const Stamp& stamp, TileTurn turn) {
  const TileSize before{stamp.w, stamp.h}, after = turned(before, turn);
  Stamp result{after.width, after.height, {}};
  for (int y = 0; y < result.h; ++y) {
    for (int x = 0; x < result.w; ++x) {
      const Cell from = pixel_before_turn({x, y}, turn, before);
      const MapCell cell = stamp.at(from.x, from.y);
      result.tiles.push_back(cell.tile == 0 ? cell : MapCell(cell.tile, after_turn(cell.turn, turn)));
    }
  }
  return result;
}

}  // namespace talus
