#include "tuning.h"

#include <array>

namespace talus {

std::span<const TuningField> tuning_fields() {
  using T = ArticleTuning;
  static constexpr std::array<TuningField, 15> kFields = {{
      {"cell_size", "cell size", "px", &T::cell_size, 1, 1024,
       "Side of a grid cell of the collision world; only speed depends on it. Slow when far from 2-4 tiles."},
      {"fall_speed", "fall speed", "px/frame", &T::fall_speed, -64, 64,
       "The vertical speed that falling tends to. Over 8, a ball skips a tile a frame and slopes are "
       "missed."},
      {"fall_blend", "fall blend", "", &T::fall_blend, 0, 1,
       "Share of the way to the fall speed gained each frame. Too high: no arc; too low: floats."},
      {"drift_speed", "drift speed", "px/frame", &T::drift_speed, -64, 64,
       "The horizontal speed that rolling tends to: 0 comes to rest, anything else is wind."},
      {"drift_blend", "drift blend", "", &T::drift_blend, 0, 1,
       "Share of the way to the drift speed gained each frame. Too low: rolls forever."},
      {"floor_bounce", "floor bounce", "", &T::floor_bounce, 0, 2,
       "Share of vy kept, reversed, at a floor or ceiling. Over 1, balls gain energy and never rest."},
      {"floor_grip", "floor grip", "", &T::floor_grip, 0, 2,
       "Share of vx kept at a floor or ceiling. Too low: balls stop where they land."},
      {"wall_bounce", "wall bounce", "", &T::wall_bounce, 0, 2,
       "Share of vx kept, reversed, at a wall. Over 1, balls gain speed between two walls."},
      {"slope_bounce", "slope bounce", "", &T::slope_bounce, 0, 2,
       "Share of vy kept, reversed, on a slope. Too high: balls hop down instead of rolling."},
      {"slope_width", "slope width", "px", &T::slope_width, 1, 64,
       "Width of a slope's box from the left side of its flagged tile. Must match the drawing."},
      {"slope_height", "slope height", "px", &T::slope_height, 1, 64,
       "Height of a slope's box. The article's floor height is right only when it equals a ball's height, "
       "8."},
      {"drag_blend", "drag blend", "", &T::drag_blend, 0, 1,
       "Share of the way to the mouse that a dragged ball moves each frame. 0 leaves it hanging."},
      {"drag_offset", "drag offset", "px", &T::drag_offset, -64, 64,
       "Distance in x and y from a ball's corner to where the mouse holds it: 4 is its centre."},
      {"drag_probe", "drag probe", "px/frame", &T::drag_probe, 0, 64,
       "Downward speed with which a dragged ball looks for slopes. 0: it sinks into them."},
      {"balls_block", "balls block", "", &T::balls_block, 0, 1,
       "1: balls are obstacles to one another, as in the article. 0: they pass through each other."},
  }};
  return kFields;
}

std::string_view solver_name(SolverKind solver) {
  switch (solver) {
    case SolverKind::article:
      return "article";
  }
  return "";
}

}  // namespace talus
