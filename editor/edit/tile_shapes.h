// Shapes of tiles: suggested from their pixels, turned, spread, and given to many tiles at once. Functions
// that make an Edit change nothing themselves.
#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "sprite_area.h"

namespace talus {

// A usable shape of this kind that is as similar to the old one as possible: a line through a profile's ends,
// a profile along a line or along the top of other ground, the polygon of an outline (see as_polygon();
// nothing becomes that of a full tile). kind: no group (asserted). tile: px, the size of a tile.
TileShape with_kind(TileShape shape, TileShape::Kind kind, TileSize tile);
// The same line over so many tiles, 1..kMaxShapeTiles (asserted). A profile gets a height for each px of its
// width. tile: px, the size of a tile.
TileShape with_width(TileShape shape, int tiles, TileSize tile);

enum class ShapeTurn { none, mirrored, upside_down, half_turn };
TileShape turned(TileShape shape, ShapeTurn turn, TileSize tile);

// The tiles of the sheet that a shape reaches over: its own, those to the right and, if it is higher than a
// tile, those above (a floor) or below (a ceiling). They may reach beyond the sheet.
CellRect tiles_of_shape(const Level& level, int tile, const TileShape& shape);

// For a tile without a shape: the tile left of it whose shape reaches over it on the sheet, as a ramp's does
// over its right half; nothing if there is none.
std::optional<int> tile_reaching_over(const Level& level, int tile);

// Suggests a shape from the opaque pixels of a tile and of those to its right: in true colour the pixels that
// are at least half opaque, whatever their colour; else those that are not colour 0. A floor goes along the
// topmost pixel of each column, a ceiling along the lowest; the one with fewer clear pixels behind it is
// taken. A full tile is solid. It is a line if all columns are within half a pixel of one, or if one runs
// through their last pixels or the first clear ones, as stairs are drawn; else it is a profile. An image of
// 8x8 pixels covers a tile of any size. What is one-way keeps its side. Returns nothing if all pixels are
// clear. tiles: 1..kMaxShapeTiles, cut off at the sheet's edge.
std::optional<TileShape> suggest_shape(const Level& level, int tile, int tiles = 1);
// The same for each single tile of the area. Tiles without an opaque pixel keep their shapes.
Edit suggest_shapes(const Level& level, const SpriteArea& area);
// The first tile of the area gets this shape, and so do others with the same old shape. What differs from its
// old shape changes in the other tiles, too, as far as their shapes have it; the rest of them stays. Tiles
// that another one of the area reaches over are left out.
Edit change_shapes(const Level& level, const SpriteArea& area, const TileShape& shape);
// Each of the same tiles gets a shape of this kind that is as similar to its old one as possible.
Edit change_kinds(const Level& level, const SpriteArea& area, TileShape::Kind kind);
// One shape for each tile of the area.
Edit give_shape(const Level& level, const SpriteArea& area, const TileShape& shape);

// Copies the shape of a tile, turned, and the pixels of the tiles that it reaches over, so that `target` has
// the shape then. target may be the tile itself. The error is one sentence without a full stop.
tl::expected<Edit, std::string> copy_turned(const Level& level, int tile, int target, ShapeTurn turn);
// The first place with room for copy_turned, where all tiles are clear and have no shape; nothing if there is
// none.
std::optional<int> free_target(const Level& level, int tile, ShapeTurn turn);
// The tiles with pixels or a shape that copy_turned would change, in the order of the sheet. Empty if it has
// no room, or if the target is the tile itself.
std::vector<int> tiles_replaced(const Level& level, int tile, int target, ShapeTurn turn);

}  // namespace talus
