// What the panels of sprites and colours show.
#pragma once

#include <map>
#include <vector>

#include <talus/collision/geometry.h>
#include "edit/pixel_color.h"

namespace talus {

inline constexpr int kMaxPixelZoom = 8;

// How the pixel canvas is shown.
struct PixelView {
  bool neighbours = false;  // among the tiles that stand around it on the map
  bool enlarged = false;    // above the map and the play view, instead of below the sheet
  bool unfolded = false;    // shown below a sheet in true colour, too, which is seldom painted
  friend bool operator==(const PixelView&, const PixelView&) = default;
};

struct SpritesView {
  PixelView pixels;
  int palette_color = 12;           // 0..15, which the sliders edit
  bool picks_right = false;         // whether the picker chooses the right button's colour, in true colour
  std::vector<Rgba> recent_colors;  // those that were painted with last in true colour, the last one first
  int pixel_zoom = 0;               // steps that the pixels are shown larger than fits, 0..kMaxPixelZoom
  int sheet_zoom = 0;               // steps that the sheet zooms in by when it is drawn next; < 0: out
  std::map<int, Cell> tile_places;  // by tile, where on the map the mouse was on it last
  int tileset = -1;                 // index of the tileset that the sheet shows alone; -1: all tiles
  bool finds = false;               // whether a small sheet has the field that finds tiles, too
  bool marks_used = false;          // whether the sheet marks the tiles that the map uses
  int kept_tile = -1;               // tile that the panel of the tile stays with; -1: the selected one
  int shown_tile = -1;              // tile that the sheet shows when it is drawn next; -1: none
};

}  // namespace talus
