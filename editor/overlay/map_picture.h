// A picture of the map for low zoom: each pixel is a cell, or a block of cells, in the commonest colour of
// its tile.
#pragma once

#include <optional>
#include <vector>

#include <talus/level/level.h>
#include "level/cell_rect.h"

namespace talus {

using TileColors = std::vector<Rgb>;            // by tile
using TileOpacity = std::vector<std::uint8_t>;  // by tile, 0 is clear

// Options of the picture.
struct MapLook {
  bool hide_balls = false;            // draws ball tiles as tile 0, as the play view does
  std::optional<FlagPattern> tinted;  // tints tiles whose flags match; empty: tints nothing
  Rgb tint;
  friend bool operator==(const MapLook&, const MapLook&) = default;
};
inline constexpr int kTintPercent = 43;
// The look of one layer of a map.
struct LayerLook {
  int layer = 0;          // index in Level::layers
  bool is_opaque = true;  // else tile 0 of layers that are not at the back, colour 0 and what is clear in
                          // true colour are clear
  MapLook look;           // balls and tinted flags; of layers that are ground only
  friend bool operator==(const LayerLook&, const LayerLook&) = default;
};

// Returns the commonest colour of each tile; if several are equally common, the first one in the palette. A
// tile in true colour has the mean of its colours.
TileColors tile_colors(const Level& level, const MapLook& look);

// The tiles of a layer as a picture needs them.
struct LayerPaint {
  TileColors colors;    // of what is not clear
  TileOpacity opacity;  // how much of the tile is not clear; empty: all of each tile
};
// Returns the tiles of a layer, each in one colour as tile_colors(). look.layer: of the level (asserted).
LayerPaint layer_paint(const Level& level, const LayerLook& look);

// The most cells that one pixel stands for, along each side.
inline constexpr int kMaxBlock = 1 << 21;

// Returns RGBA of width * height pixels, row by row. The first pixel stands for the block with its top left
// cell at `from`. Each pixel is the mean of its cells on the map, and transparent if it has none. block: a
// power of 2, 1..kMaxBlock.
std::vector<std::uint8_t> map_picture(const TileMap& map, const TileColors& colors, Cell from, int block,
                                      int width, int height);
// The same for a layer of a level; where its tiles are clear, so is the picture.
std::vector<std::uint8_t> layer_picture(const Level& level, int layer, const LayerPaint& paint, Cell from,
                                        int block, int width, int height);

}  // namespace talus
