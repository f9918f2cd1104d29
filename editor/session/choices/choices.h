// What the user has chosen; the actions with the same names change it.
#pragma once

#include <cstdint>
#include <optional>

#include "choice_actions.h"
#include "edit/pixel_selection.h"

namespace talus {

struct Choices {
  MapTool map_tool = MapTool::stamp;
  SpriteTool sprite_tool = SpriteTool::pencil;
  SpriteArea area;                                 // shown in the canvas and the flags panel
  int brush = 1;                                   // px, of the sprite tools, 1..kMaxBrush
  PixelSelection pixels;                           // in the canvas, with the select tool
  Stamp stamp;                                     // painted on the map
  bool random_stamp = false;                       // each cell takes a tile of the stamp at random
  std::uint32_t random_seed = 1;                   // see random_tile()
  std::optional<CellRect> selection;               // on the map, wholly inside it
  std::optional<Stamp> pasted;                     // follows the mouse
  int color = 12;                                  // left button, 0..15
  int secondary_color = 0;                         // right button, 0..15
  Rgba rgba = {0xf4, 0xf4, 0xf4, 0xff};            // left button, on sheets in true colour
  Rgba secondary_rgba = {};                        // right button, the same: the eraser
  int body = 0;                                    // id of the chosen body; 0: no body
  int curve = -1;                                  // index of the chosen curve; an unknown one: no curve
  CurveKind curve_kind = CurveKind::arc;           // kind that the curve tool draws
  ObjectRef object;                                // the chosen one; an unknown one: no object
  ObjectKind object_kind = ObjectKind::rectangle;  // what the object tool draws
  OverlaySet overlays;                             // shown in the play view
  OverlayPalette overlay_palette = OverlayPalette::standard;
  std::optional<FlagPattern> flag_overlay;  // tinted, painted and looked for
  bool grid = true;
  bool screen_borders = true;

  // The colour that a button paints on the sheet of `area`.
  PixelColor paint(const Level& level, bool secondary) const {
    if (is_in_rgba(level, area.sheet)) return pixel_color(secondary ? secondary_rgba : rgba);
    return secondary ? secondary_color : color;
  }
};

}  // namespace talus
