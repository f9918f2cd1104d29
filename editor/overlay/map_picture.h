// The map from afar: a pixel for a cell, or for a block of cells, in the colour that its tile has most of.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <talus/level/level.h>
#include "level/cell_rect.h"

namespace talus {

using TileColors = std::array<Rgb, kTileCount>;

// What is shown besides the tiles themselves.
struct MapLook {
  bool hide_balls = false;            // ball tiles look as tile 0, as the play view leaves them out
  std::optional<FlagPattern> tinted;  // tiles whose flags match are tinted
  Rgb tint;
  friend bool operator==(const MapLook&, const MapLook&) = default;
};
inline constexpr int kTintPercent = 43;

// The colour that most pixels of each tile have; of several, the one that comes first in the palette.
TileColors tile_colors(const Level& level, const MapLook& look);

// Cells that one pixel stands for, along each side.
inline constexpr int kMaxBlock = 1 << 21;

// RGBA, width * height pixels, row by row. The first pixel stands for the block with its top-left cell at
// `from`; each is the mean of its cells on the map, and clear where it has none.
// block: a power of 2, 1..kMaxBlock.
std::vector<std::uint8_t> map_picture(const TileMap& map, const TileColors& colors, Cell from, int block,
                                      int width, int height);

}  // namespace talus
