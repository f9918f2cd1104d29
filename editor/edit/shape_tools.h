// Tools for the shapes of the ground. Each makes an Edit and changes nothing itself.
#pragma once

#include "cell_painter.h"
#include "level/slope_tiles.h"
#include "stamp.h"

namespace talus {

// The error of a tool that lays a line, when its ends are one point.
inline constexpr const char* kNoLength = "drag from one end to the other";

// The shape should be usable (see problem_of). Other shapes are kept, but the lint reports them and they are
// not saved.
Edit set_tile_shape(const Level& level, int tile, TileShape shape);  // tile: 0..255 (asserted)
Edit set_flag_shape(const Level& level, int flag, TileShape shape);  // flag: 0..31 (asserted)
Edit set_curves(const Level& level, std::vector<LevelCurve> curves, std::string label);

// Puts the tiles along a slope on the map. They must have been made for this level. Cells outside of `within`
// are left out, and so are drawn tiles that only these would show.
Edit put_slope_tiles(const Level& level, const SlopeTiles& tiles, Within within = {});

// The slope tool: tiles along the line between two points, px. If `stamp` has sloped floors, these are laid;
// else tiles of the sheet that follow the line exactly and look like it; else blank tiles are drawn, in the
// main colour of the tile that goes below. Their edge has the colours of the upper rows of the top of the
// ground: of the tile that is painted there, else of the ground on which an end of the line stands; without
// either, `line_color` (0..15). The first full tile of `stamp` goes below; if it has none, the inside of the
// ground that is painted, or the tile under the top of that ground, or a drawn one. Ground that it covers
// gets the part that fits. Cells outside of `within` are left out. fills: whether the ground follows the
// slope, see SlopeTilesOptions. Bodies that it would bury start above it. The error is one sentence; a floor
// too steep to stand on is one, too.
tl::expected<Edit, std::string> lay_slope(const Level& level, Vec2 a, Vec2 b, const Stamp& stamp,
                                          std::uint8_t line_color, Within within = {}, bool fills = true);

}  // namespace talus
