// What the panels of sprites and colours show.
#pragma once

#include <map>

#include <talus/collision/geometry.h>

namespace talus {

// How the pixel canvas is shown.
struct PixelView {
  bool neighbours = false;  // among the tiles that stand around it on the map
  bool enlarged = false;    // above the map and the play view, instead of below the sheet
  friend bool operator==(const PixelView&, const PixelView&) = default;
};

struct SpritesView {
  PixelView pixels;
  int palette_color = 12;  // 0..15, which the sliders edit
  // Where on the map the mouse was on each tile last.
  int sheet_zoom = 0;               // steps that the sheet is shown larger than by itself; may be negative
  std::map<int, Cell> tile_places;  // by tile
  int tileset = -1;                 // index of the tileset that the sheet shows alone; -1: all tiles
  bool finds = false;               // whether a small sheet has the field that finds tiles, too
  bool marks_used = false;          // whether the sheet marks the tiles that the map uses
  int shown_tile = -1;              // tile that the sheet scrolls to when it is drawn next; -1: none
};

}  // namespace talus
