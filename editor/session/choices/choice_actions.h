// Actions: choosing what is edited, with which tool, and what is shown with it.
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include <talus/collision/geometry.h>
#include "edit/curve_tools.h"
#include "edit/object_handles.h"
#include "edit/pixel_color.h"
#include "edit/sprite_area.h"
#include "edit/sprite_shapes.h"
#include "edit/stamp.h"
#include "overlay/overlay_table.h"

namespace talus {

// The tools of the map: those of the keys 1 to 9 and 0 in their order, 1 to 4 as in TIC-80; then those with
// letters.
enum class MapTool {
  stamp,
  pan,
  select,
  fill,
  line,
  rectangle,
  ellipse,
  slope,
  segment,
  body,
  erase,
  pick,
  ground,
  flag,
  curve,
  object
};
// The tools of the sprite canvas; the first four in the order of their keys 1 to 4, as in TIC-80.
enum class SpriteTool { pencil, pick, select, fill, line, rectangle, ellipse };

namespace action {

struct SelectCurve {
  int curve = -1;  // its index in the level; an unknown one: no curve
};
struct SetCurveKind {  // what the curve tool draws
  CurveKind kind = CurveKind::segment;
};
struct SelectObject {  // an unknown one: no object; its layer gets new ones, if the level has that
  ObjectRef object;
};
struct SetObjectKind {  // what the object tool draws
  ObjectKind kind = ObjectKind::rectangle;
};
struct SelectTiles {  // on the sheet: for the canvas and the flags, and, for tiles, the stamp
  SpriteArea area;
};
struct SelectPixels {            // in the canvas, until another tool or canvas is chosen
  std::optional<CellRect> rect;  // px of the canvas, clamped to it; nothing: no selection
};
struct SetStamp {
  Stamp stamp;
};
struct SetRandomStamp {  // each painted cell takes a tile of the stamp at random
  bool on = true;
  std::uint32_t seed = 1;  // for what is painted from now on
};
struct SelectCells {  // on the map; cut off at its edge; wholly outside, or nothing: no selection
  std::optional<CellRect> cells;
};
struct SetPasted {  // tiles that follow the mouse until a click puts them on the map; nothing: no such tiles
  std::optional<Stamp> tiles;
};
struct SetMapTool {  // drops tiles that follow the mouse
  MapTool tool;
};
struct SetSpriteTool {
  SpriteTool tool;
};
struct SetBrush {  // for the tools that draw pixels
  int size = 1;    // px, 1..kMaxBrush; clamped
};
struct SetColor {          // for sheets in 16 colours
  int color = 0;           // 0..15
  bool secondary = false;  // false: the left button's colour; true: the right button's
};
struct SetRgba {           // for sheets in true colour
  Rgba color;              // clear: the button erases
  bool secondary = false;  // as above
};
struct SetOverlay {
  const Overlay* overlay;  // never null
  bool on = true;
};
struct SetFlagOverlay {
  // The pattern that is tinted on the map and the sheet, painted and searched; empty: no tint.
  std::optional<FlagPattern> pattern;
};
struct SetOverlayPalette {
  OverlayPalette palette;
};
struct SetGrid {
  bool on = true;
};
struct SetScreenBorders {
  bool on = true;
};

}  // namespace action

// The actions that ChoiceHandler carries out.
using ChoiceAction =
    std::variant<action::SelectCurve, action::SetCurveKind, action::SelectObject, action::SetObjectKind,
                 action::SelectTiles, action::SelectPixels, action::SetStamp, action::SetRandomStamp,
                 action::SelectCells, action::SetPasted, action::SetMapTool, action::SetSpriteTool,
                 action::SetBrush, action::SetColor, action::SetRgba, action::SetOverlay,
                 action::SetFlagOverlay, action::SetOverlayPalette, action::SetGrid,
                 action::SetScreenBorders>;

}  // namespace talus
