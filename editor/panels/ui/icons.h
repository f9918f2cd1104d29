// Small vector icons, drawn so that no font has to have them.
#pragma once

#include <imgui.h>

namespace talus {

enum class Icon {
  none,
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
  stamp,
  pan,
  rectangle,
  fill,
  erase,
  pick,
  body,
  slope,
  segment,
  ground,
  curve,
  pencil,
  select,
  line,
  frame,
  ellipse,
  neighbours,
  enlarge,
  flip_horizontal,
  flip_vertical,
  rotate,
  clear,
  grid,
  borders,
  zoom_in,
  zoom_out,
  minimap,
  dice,
  close,
};

// Fills the square from `at` of side `size` px.
void draw_icon(ImDrawList& list, Icon icon, ImVec2 at, float size, ImU32 color);

}  // namespace talus
