// Icons: common ones from the font Fork Awesome, and own drawings for those that no font has.
#pragma once

#include <imgui.h>

namespace talus {

enum class Icon {
  none,
  // Drawn in strokes: tools, then pictures.
  stamp,
  fill,
  body,
  slope,
  segment,
  ground,
  curve,
  object,
  line,
  select,
  neighbours,
  flip_horizontal,
  flip_vertical,
  borders,
  // Glyphs.
  first_frame,
  last_frame,
  restart,
  play,
  pause,
  step,
  step_back,
  run_on,
  run_back,
  split,
  pan,
  hand,
  rectangle,
  erase,
  pick,
  pencil,
  frame,
  ellipse,
  enlarge,
  rotate,
  clear,
  grid,
  minimap,
  dice,
  zoom_in,
  zoom_out,
  eye,
  eye_closed,
  lock,
  unlock,
  plus,
  copy,
  arrow_up,
  arrow_down,
  merge_down,
  follow,
  close,
  folder,
  more,
};

// Merges the glyphs of Debian's fonts-fork-awesome into the font that was added to the atlas last. scale:
// pixels for one px at scale 1. Without the font's file nothing is added, and short texts stand for the
// glyphs.
void add_icon_font(ImFontAtlas& fonts, float scale);

// In the square from `at` of side `size` px. Strokes fill it, and glyphs lie in its middle.
void draw_icon(ImDrawList& list, Icon icon, ImVec2 at, float size, ImU32 color);

}  // namespace talus
