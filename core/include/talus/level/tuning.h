// Every number of the physics that a user may change.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <talus/collision/shape.h>

namespace talus {

// How bodies are moved.
enum class SolverKind {
  article,  // the article's algorithm, defects included
  bump,     // slopes as one more response of the World
  exact     // swept against the merged outline of the ground
};

// What bodies are to one another; the numbers are those of SharedTuning::bodies.
enum class BodyPairs {
  pass,   // nothing: they go through one another
  block,  // obstacles, one after the other, as in the article
  meet  // only of `exact`: they move at the same time, bounce off, push and carry one another; else as block
};

// Numbers that the solvers share. The article "Slopes in AABB collision systems" has them as constants, which
// are the defaults. tuning_fields() holds the range of each one and the symptom of a wrong value.
struct SharedTuning {
  double cell_size = 24;      // px, side of a grid cell of the collision world
  double fall_speed = 5;      // px/frame, the vy that falling tends to
  double fall_blend = 0.075;  // share of the way to fall_speed gained in a frame
  double drift_speed = 0;     // px/frame, the vx that rolling tends to
  double drift_blend = 0.03;  // share of the way to drift_speed gained in a frame
  double floor_bounce = 0.9;  // vy kept, reversed, at a floor or ceiling
  double floor_grip = 0.75;   // vx kept at a floor or ceiling
  double wall_bounce = 0.9;   // vx kept, reversed, at a wall
  double slope_bounce = 0.5;  // vy kept, reversed, on a slope; not used by `exact`
  double slope_width = 16;    // px, the box of a slope, from the left side of its flagged tile
  double slope_height = 8;    // px
  double drag_blend = 0.3;    // share of the way to the mouse that a dragged ball moves in a frame
  double drag_offset = 4;     // px from a ball's corner to where the mouse holds it, in x and y
  double drag_probe = 1;  // px/frame, downward speed with which a dragged ball finds slopes; `article` alone
  double bodies = 1;      // whole; a BodyPairs
  // `bodies` by its name; the number must be one of them.
  BodyPairs pairs() const { return static_cast<BodyPairs>(static_cast<int>(bodies)); }
  friend bool operator==(const SharedTuning&, const SharedTuning&) = default;
};

// Numbers of the exact solver alone. Ranges: tuning_fields().
struct ExactTuning {
  double gravity = 0;     // px/frame^2, added to vy; 0: balls fall as the article's do
  double steepest = 2;    // the largest |dy/dx| that counts as floor
  double snap = 0;        // px that a grounded player is pulled down; 0: what the steepest floor needs
  double rebound = 0;     // 1: what is left of a step's motion after a bounce goes on from it; 0: slides
  double max_passes = 8;  // whole; contacts handled in a step before the rest of its motion is dropped
  double single_precision = 0;  // 1: the step is computed in float
  double substeps = 1;          // whole; equal parts that a frame is cut into
  friend bool operator==(const ExactTuning&, const ExactTuning&) = default;
};

// How a player runs and jumps. Ranges: tuning_fields().
struct PlayerTuning {
  double run_speed = 1.5;    // px/frame, the speed that running tends to
  double run_gain = 0.25;    // px/frame^2, towards run_speed
  double run_loss = 0.25;    // px/frame^2, towards rest when no direction is held
  double air_gain = 0.125;   // px/frame^2, as run_gain in the air
  double jump_speed = 3.5;   // px/frame, upwards, at the start of a jump
  double jump_cut = 0.5;     // share of the upward speed kept when jump is let go
  double gravity = 0.2;      // px/frame^2
  double fall_limit = 4;     // px/frame, the largest downward speed
  double coyote_frames = 6;  // whole; frames after leaving the floor in which a jump still works
  double surface_speed = 0;  // 1: run_speed is measured along the slope; 0: horizontally
  friend bool operator==(const PlayerTuning&, const PlayerTuning&) = default;
};

// All numbers. Readers and writers refuse a level with a number outside of its range.
struct Tuning {
  SolverKind solver = SolverKind::exact;  // the one that moves the bodies
  SharedTuning shared;                    // of all solvers
  ExactTuning exact;                      // of the solver exact alone
  PlayerTuning player;                    // for players; article and bump move them as balls
  friend bool operator==(const Tuning&, const Tuning&) = default;
};

// The numbers of a new level with tiles of that size: the defaults, made for tiles of 8x8 px, with lengths
// and speeds scaled, but within their ranges.
Tuning new_tuning(TileSize tile);

// One row for each number, for everything that lists the numbers: files, tuning panel, documentation.
struct TuningField {
  std::string_view group;  // in files, the object in "tuning" that holds it: "exact"; empty: "tuning" itself
  std::string_view key;    // in files: "fall_speed"
  std::string_view label;  // on screen: "fall speed"
  std::string_view unit;   // "px", "px/frame", "px/frame^2" or ""
  double& (*in)(Tuning& tuning);  // where a tuning keeps the number
  double min;                     // the smallest value; a file with a smaller one is refused
  double max;                     // the largest value; a file with a larger one is refused
  bool whole;                     // a file with a value that is not a whole number is refused
  std::string_view help;          // what it does and what a wrong value looks like, one sentence
  std::span<const std::string_view> words = {};  // in files and on screen, of 0, 1 and so on; empty: numbers

  std::string path() const;                                    // "exact.gravity", or the key alone
  double of(Tuning tuning) const { return in(tuning); }        // the number of that tuning
  double standard() const { return of(Tuning()); }             // the default
  bool accepts(double value) const;                            // in range, and whole if it must be
  std::string_view word_of(const Tuning& tuning) const;        // of a field with words
  std::optional<double> of_word(std::string_view word) const;  // nothing if it is no word of the field
};
// Fields of one group follow one another.
std::span<const TuningField> tuning_fields();
// The shared numbers have no group.
inline constexpr std::array<std::string_view, 2> kTuningGroups = {"exact", "player"};

std::span<const SolverKind> solver_kinds();                       // all of them
std::string_view solver_name(SolverKind solver);                  // in files and on screen: "article"
std::optional<SolverKind> solver_of_name(std::string_view name);  // nothing if there is no such solver

}  // namespace talus
