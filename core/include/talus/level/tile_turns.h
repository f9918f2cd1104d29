// What a turn of a tile does to its shape, and to the pixels of its picture.
#pragma once

#include <optional>
#include <string>

#include <talus/collision/shape.h>
#include <talus/level/map_cells.h>

namespace talus {

// The size of a tile's picture after a turn: after a diagonal flip its width and height have changed places.
constexpr TileSize turned(TileSize tile, TileTurn turn) {
  return has_flip(turn, TileTurn::diagonal) ? TileSize{tile.height, tile.width} : tile;
}
// How far below the top of its cell a turned picture begins, px: its bottom left corner is that of the cell.
constexpr int top_of_turned(TileSize tile, TileTurn turn) { return tile.height - turned(tile, turn).height; }
// The pixel of a tile's picture that a pixel of the turned picture shows; both from the top left.
Cell pixel_before_turn(Cell pixel, TileTurn turn, TileSize tile);

// The shape turned with its picture, exactly; its points and heights are welded. A slope or profile that is
// only mirrored is one again, unless it is wider than a tile and left and right change places. All others
// become polygons. A one-way shape that is mirrored up and down stops bodies from below. After a quarter turn
// it would stop them from the side: it is a polygon that problem_of() refuses, and so no ground. A conveyor
// that is mirrored goes the other way. The shape must be valid for tiles of that size.
TileShape turned(const TileShape& shape, TileTurn turn, TileSize tile);

// Whether a turn makes a mirror image, in which clockwise is anticlockwise.
bool is_mirror(TileTurn turn);

// What is done to a tile: "mirrored", "turned right, mirrored"; empty for TileTurn::none.
std::string text_of(TileTurn turn);

}  // namespace talus
