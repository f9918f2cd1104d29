// Shapes of tiles: proposed from their pixels, turned, spread, and given to many tiles at once. What makes an
// Edit changes nothing itself.
#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "sprite_area.h"

namespace talus {

// A shape of this kind that can be used, as like the old one as may be: a line through a profile's ends, a
// profile along a line, or along the top of a full tile.
TileShape with_kind(TileShape shape, TileShape::Kind kind);
// The same line over so many tiles, 1..kMaxShapeTiles (asserted); a profile has a height for each column
// line.
TileShape with_width(TileShape shape, int tiles);

enum class ShapeTurn { none, mirrored, upside_down, half_turn };
TileShape turned(TileShape shape, ShapeTurn turn);

// The tiles of the sheet that a shape reaches over: its own, those to the right, and, where it is higher than
// a tile, those above (a floor) or below (a ceiling). May reach beyond the sheet.
CellRect tiles_of_shape(int tile, const TileShape& shape);

// The tile left of one without a shape whose shape reaches over it on the sheet, as a ramp's does over its
// right half; none: no tile's does.
std::optional<int> tile_reaching_over(const Level& level, int tile);

// What the opaque pixels of a tile, and of those to its right, look like; colour 0 is clear. A floor goes
// along the topmost pixel of each column, a ceiling along the lowest; whichever has fewer clear pixels behind
// it. Full: solid. A line where all columns are within half a pixel of one, or where one runs through their
// last pixels or the first clear ones, as stairs are drawn; else a profile. Nothing: all is clear.
// tiles: 1..kMaxShapeTiles, cut at the sheet's edge.
std::optional<TileShape> suggest_shape(const Level& level, int tile, int tiles = 1);
// The same for each tile of the area by itself; those without an opaque pixel keep what they have.
Edit suggest_shapes(const Level& level, const SpriteArea& area);
// The first tile of the area gets this shape, and what differs from its old one changes in the others, too,
// as far as their shapes have it; the rest of them stays. Left out are tiles that another one of the area
// reaches over.
Edit change_shapes(const Level& level, const SpriteArea& area, const TileShape& shape);
// Each of the same tiles gets a shape of this kind, as like its old one as may be.
Edit change_kinds(const Level& level, const SpriteArea& area, TileShape::Kind kind);
// One shape for each tile of the area.
Edit give_shape(const Level& level, const SpriteArea& area, const TileShape& shape);

// Copies the shape of a tile and the pixels of the tiles that it reaches over, turned, so that `target` has
// the shape then; target may be the tile itself. The error is one clear sentence, without a full stop.
tl::expected<Edit, std::string> copy_turned(const Level& level, int tile, int target, ShapeTurn turn);
// Where copy_turned finds room: the first place whose tiles are all clear and have no shape; none: nowhere.
std::optional<int> free_target(const Level& level, int tile, ShapeTurn turn);
// The tiles that copy_turned would change though they have pixels or a shape; in the order of the sheet. None
// where it has no room, and where the target is the tile itself.
std::vector<int> tiles_replaced(const Level& level, int tile, int target, ShapeTurn turn);

}  // namespace talus
