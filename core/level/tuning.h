// Every number of the physics that a user may change.
#pragma once

#include <span>
#include <string_view>

namespace talus {

enum class SolverKind { article };  // `bump` and `exact` are built by later work

// The constants of the article "Slopes in AABB collision systems", named. Velocities are in px a frame.
// Defaults are the article's own; tuning_fields() holds each one's range and the symptom of a wrong value.
struct ArticleTuning {
  double cell_size = 24;      // px, side of a grid cell of the collision world
  double fall_speed = 5;      // px/frame, the vy that falling tends to
  double fall_blend = 0.075;  // share of the way to fall_speed gained in a frame
  double drift_speed = 0;     // px/frame, the vx that rolling tends to
  double drift_blend = 0.03;  // share of the way to drift_speed gained in a frame
  double floor_bounce = 0.9;  // vy kept, reversed, at a floor or ceiling
  double floor_grip = 0.75;   // vx kept at a floor or ceiling
  double wall_bounce = 0.9;   // vx kept, reversed, at a wall
  double slope_bounce = 0.5;  // vy kept, reversed, on a slope
  double slope_width = 16;    // px, the box of a slope, from the left side of its flagged tile
  double slope_height = 8;    // px
  double drag_blend = 0.3;    // share of the way to the mouse that a dragged ball moves in a frame
  double drag_offset = 4;     // px from a ball's corner to where the mouse holds it, in x and y
  double drag_probe = 1;      // px/frame, the downward speed with which a dragged ball looks for slopes
  double balls_block = 1;     // 1: balls are obstacles to one another, as in the article; 0: they pass
  friend bool operator==(const ArticleTuning&, const ArticleTuning&) = default;
};

struct Tuning {
  SolverKind solver = SolverKind::article;
  ArticleTuning article;
  friend bool operator==(const Tuning&, const Tuning&) = default;
};

// One row for everything that lists the numbers: the files, the tuning panel, the documentation.
struct TuningField {
  std::string_view key;    // in files: "fall_speed"
  std::string_view label;  // on screen: "fall speed"
  std::string_view unit;   // "px", "px/frame" or ""
  double ArticleTuning::*value;
  double min, max;        // inclusive; a file with a value outside is refused
  std::string_view help;  // what it does and what a wrong value looks like, one sentence
};
std::span<const TuningField> tuning_fields();

std::string_view solver_name(SolverKind solver);  // "article"

}  // namespace talus
