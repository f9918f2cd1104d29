#include <talus/level/tuning.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace talus {
namespace {

using S = SharedTuning;
using E = ExactTuning;
using P = PlayerTuning;

// For TuningField::in: where a tuning keeps a number.
template <auto Group, auto Number>
double& member(Tuning& tuning) {
  return tuning.*Group.*Number;
}
template <auto Number>
constexpr auto shared = member<&Tuning::shared, Number>;
template <auto Number>
constexpr auto exact = member<&Tuning::exact, Number>;
template <auto Number>
constexpr auto player = member<&Tuning::player, Number>;

constexpr bool kAny = false, kWhole = true;

constexpr std::array<std::string_view, 3> kPairWords = {"pass", "block", "meet"};  // by BodyPairs

constexpr std::array kFields = std::to_array<TuningField>({
    {"", "cell_size", "cell size", "px", shared<&S::cell_size>, 1, 1024, kAny,
     "Side of a grid cell of the collision world; only speed depends on it. Slow when far from 2-4 tiles."},
    {"", "fall_speed", "fall speed", "px/frame", shared<&S::fall_speed>, -64, 64, kAny,
     "The vertical speed that falling tends to. Over 8, a ball skips a tile a frame and slopes are "
     "missed."},
    {"", "fall_blend", "fall blend", "", shared<&S::fall_blend>, 0, 1, kAny,
     "Share of the way to the fall speed gained each frame. Too high: no arc; too low: floats."},
    {"", "drift_speed", "drift speed", "px/frame", shared<&S::drift_speed>, -64, 64, kAny,
     "The horizontal speed that rolling tends to: 0 comes to rest, anything else is wind."},
    {"", "drift_blend", "drift blend", "", shared<&S::drift_blend>, 0, 1, kAny,
     "Share of the way to the drift speed gained each frame. Too low: rolls forever."},
    {"", "floor_bounce", "floor bounce", "", shared<&S::floor_bounce>, 0, 2, kAny,
     "Share of vy kept, reversed, at a floor or ceiling. Over 1, balls gain energy and never rest."},
    {"", "floor_grip", "floor grip", "", shared<&S::floor_grip>, 0, 2, kAny,
     "Share of vx kept at a floor or ceiling. Too low: balls stop where they land."},
    {"", "wall_bounce", "wall bounce", "", shared<&S::wall_bounce>, 0, 2, kAny,
     "Share of vx kept, reversed, at a wall. Over 1, balls gain speed between two walls."},
    {"", "slope_bounce", "slope bounce", "", shared<&S::slope_bounce>, 0, 2, kAny,
     "Share of vy kept, reversed, on a slope. Too high: balls hop down instead of rolling."},
    {"", "slope_width", "slope width", "px", shared<&S::slope_width>, 1, 64, kAny,
     "Width of a slope's box from the left side of its flagged tile. Must match the drawing."},
    {"", "slope_height", "slope height", "px", shared<&S::slope_height>, 1, 64, kAny,
     "Height of a slope's box. The article's floor height is right only when it equals a ball's height, "
     "8."},
    {"", "drag_blend", "drag blend", "", shared<&S::drag_blend>, 0, 1, kAny,
     "Share of the way to the mouse that a dragged ball moves each frame. 0 leaves it hanging."},
    {"", "drag_offset", "drag offset", "px", shared<&S::drag_offset>, -64, 64, kAny,
     "Distance in x and y from a ball's corner to where the mouse holds it: 4 is its centre."},
    {"", "drag_probe", "drag probe", "px/frame", shared<&S::drag_probe>, 0, 64, kAny,
     "Downward speed with which a dragged ball looks for slopes. 0: it sinks into them."},
    {"", "bodies", "bodies", "", shared<&S::bodies>, 0, 2, kWhole,
     "pass: bodies go through one another. block: they are obstacles, as in the article. meet, with exact: "
     "they move at the same time, bounce off and push one another.",
     kPairWords},
    {"exact", "gravity", "gravity", "px/frame^2", exact<&E::gravity>, 0, 64, kAny,
     "Speed gained downwards each frame. 0: balls fall as in the article. Too high: they never roll."},
    {"exact", "steepest", "steepest floor", "", exact<&E::steepest>, 0, 64, kAny,
     "The largest |dy/dx| that counts as floor: 1 is 45 degrees. Too low: players slide off slopes."},
    {"exact", "snap", "floor snap", "px", exact<&E::snap>, 0, 64, kAny,
     "How far a grounded player is pulled down to the floor; 0: as far as the steepest floor needs. Too "
     "high: small ledges pull."},
    {"exact", "rebound", "rebound", "", exact<&E::rebound>, 0, 1, kWhole,
     "1: balls bounce within the step, and lose no energy but by the bounce. 0: what is left of a step "
     "slides, "
     "as in the article."},
    {"exact", "max_passes", "passes", "", exact<&E::max_passes>, 4, 16, kWhole,
     "Contacts handled in one step before the rest of its motion is dropped. Too low: bodies stop in "
     "corners."},
    {"exact", "single_precision", "single precision", "", exact<&E::single_precision>, 0, 1, kWhole,
     "1: the step is computed in float, 24 bits; far from the origin contacts get coarse. 0: in double."},
    {"exact", "substeps", "substeps", "", exact<&E::substeps>, 1, 64, kWhole,
     "Equal parts that a frame is cut into. More cost time, and contacts do not need them."},
    {"player", "run_speed", "run speed", "px/frame", player<&P::run_speed>, 0, 64, kAny,
     "The speed that running tends to. Over 8, a tile a frame, runs are hard to steer."},
    {"player", "run_gain", "run gain", "px/frame^2", player<&P::run_gain>, 0, 64, kAny,
     "Speed gained each frame towards the run speed. Too low: sluggish starts and turns."},
    {"player", "run_loss", "run loss", "px/frame^2", player<&P::run_loss>, 0, 64, kAny,
     "Speed lost each frame when no direction is held. Too low: the floor feels like ice."},
    {"player", "air_gain", "air gain", "px/frame^2", player<&P::air_gain>, 0, 64, kAny,
     "As the run gain, in the air. 0: a jump cannot be steered."},
    {"player", "jump_speed", "jump speed", "px/frame", player<&P::jump_speed>, 0, 64, kAny,
     "Upward speed at the start of a jump; its height is this squared over twice the gravity."},
    {"player", "jump_cut", "jump cut", "", player<&P::jump_cut>, 0, 1, kAny,
     "Share of the upward speed kept when jump is let go. 1: every jump has its full height."},
    {"player", "gravity", "gravity", "px/frame^2", player<&P::gravity>, 0, 64, kAny,
     "Speed gained downwards each frame. Too low: the player floats."},
    {"player", "fall_limit", "fall limit", "px/frame", player<&P::fall_limit>, 0, 64, kAny,
     "The largest downward speed. Too low: falls feel like gliding."},
    {"player", "coyote_frames", "coyote frames", "", player<&P::coyote_frames>, 0, 60, kWhole,
     "Frames after leaving the floor in which a jump still works. 0: late jumps are lost."},
    {"player", "surface_speed", "surface speed", "", player<&P::surface_speed>, 0, 1, kWhole,
     "1: the run speed is measured along the slope, so slopes slow the way across. 0: horizontally."},
});

constexpr std::array<SolverKind, 3> kSolvers = {SolverKind::article, SolverKind::bump, SolverKind::exact};

}  // namespace

std::string TuningField::path() const {
  return group.empty() ? std::string(key) : std::string(group) + "." + std::string(key);
}

std::string_view TuningField::word_of(const Tuning& tuning) const {
  return words[static_cast<std::size_t>(of(tuning))];
}

std::optional<double> TuningField::of_word(std::string_view word) const {
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) return std::nullopt;
  return static_cast<double>(found - words.begin());
}

bool TuningField::accepts(double value) const {
  return value >= min && value <= max && (!whole || value == std::trunc(value));
}

Tuning new_tuning(TileSize tile) {
  constexpr std::array<std::string_view, 6> kHorizontal = {"drift_speed", "slope_width", "run_speed",
                                                           "run_gain",    "run_loss",    "air_gain"};
  constexpr TileSize kUsual;
  Tuning tuning;
  for (const TuningField& field : kFields) {
    if (!field.unit.starts_with("px")) continue;
    const bool is_horizontal =
        std::find(kHorizontal.begin(), kHorizontal.end(), field.key) != kHorizontal.end();
    const double factor = is_horizontal ? 1.0 * tile.width / kUsual.width : 1.0 * tile.height / kUsual.height;
    double& number = field.in(tuning);
    number = std::clamp(number * factor, field.min, field.max);
  }
  return tuning;
}

std::span<const TuningField> tuning_fields() { return kFields; }

std::span<const SolverKind> solver_kinds() { return kSolvers; }

std::string_view solver_name(SolverKind solver) {
  switch (solver) {
    case SolverKind::article:
      return "article";
    case SolverKind::bump:
      return "bump";
    case SolverKind::exact:
      return "exact";
  }
  return "";
}

std::optional<SolverKind> solver_of_name(std::string_view name) {
  const auto found = std::find_if(kSolvers.begin(), kSolvers.end(),
                                  [&](SolverKind solver) { return solver_name(solver) == name; });
  return found != kSolvers.end() ? std::optional(*found) : std::nullopt;
}

}  // namespace talus
