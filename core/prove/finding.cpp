#include "finding.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "level/level_text.h"

namespace talus {
namespace {

constexpr std::string_view kOfSolver =
    "The ground is good: choose the solver exact in Tuning, or report it with this level.";

constexpr std::array<FindingInfo, 12> kInfos = {{
    {"stops", "stops, though the way is free", false, kOfSolver},
    {"slows", "loses speed, though nothing is in the way", false, kOfSolver},
    {"leaves-floor", "leaves the floor, though it goes on", false, kOfSolver},
    {"jumps", "moves further than its floor leads", false, kOfSolver},
    {"floats", "stands where no floor is at its foot", false, kOfSolver},
    {"inside", "comes into the ground", false, kOfSolver},
    {"falls-through", "falls through a floor", false, kOfSolver},
    {"ghost", "is stopped by something that is not there", false, kOfSolver},
    {"gains", "gets speed from nothing", false, kOfSolver},
    {"lip", "is stopped by a low edge", true,
     "Let the floors on both sides of the edge meet at one height, or make the edge a wall."},
    {"gap", "comes to a gap in its floor", true,
     "Close the gap between the two floors, or make it wider than the body."},
    {"wedged", "is wedged, and comes back there from every jump", true,
     "Make the gap wider than the body, or so narrow that the body stays out of it."},
}};

// "a player of 8x8 px that runs to the right"
std::string subject_of(const Trial& trial) {
  const BodyTraits& traits = traits_of(trial.body.kind);
  std::string text = "a " + std::string(traits.word) + " of " + px_text(trial.body.box.w) + "x" +
                     px_text(trial.body.box.h) + " px";
  if (trial.body.foot == Foot::centre) text += " on its centre";
  if (trial.direction == 0) return text;
  const bool runs = traits.takes_keys && trial.jump_frames == 0;
  text += trial.jump_frames > 0 ? " that jumps" : runs ? " that runs" : " that rolls";
  return text + (trial.direction < 0 ? " to the left" : " to the right");
}

// " of 1 px" of an edge; nothing of kinds that need none.
std::string measure_of(const Finding& finding) {
  const std::string px = px_text(std::round(finding.amount * kWeldParts) / kWeldParts) + " px";
  switch (finding.kind) {
    case FindingKind::lip:
    case FindingKind::gap:
      return " of " + px;
    case FindingKind::inside:
    case FindingKind::falls_through:
      return " by " + px;
    case FindingKind::ghost:
      return " and leaves " + px + " of its way free";
    default:
      return "";
  }
}

}  // namespace

const FindingInfo& info_of(FindingKind kind) {
  const auto index = static_cast<std::size_t>(kind);
  assert(index < kInfos.size());
  return kInfos[index];
}

Input input_of(const Trial& trial, int frame) {
  Input input;
  input.left = trial.direction < 0 && frame >= trial.run_from;
  input.right = trial.direction > 0 && frame >= trial.run_from;
  input.jump = frame <= trial.jump_frames;
  return input;
}

LoneBody lone_body_of(const Trial& trial) {
  const Body& body = trial.body;
  LoneBody alone;
  alone.spawn.position = body.box.position();
  alone.spawn.velocity = body.velocity;
  alone.spawn.kind = body.kind;
  alone.spawn.size = {body.box.w, body.box.h};
  alone.spawn.foot = body.foot;
  alone.stands = body.gait.grounded;
  alone.run_speed = trial.speed;
  return alone;
}

void add_alike(Finding& finding, const Finding& other) {
  constexpr int kShown = 45;  // steps; a longer way is no clearer
  const int count = finding.count + other.count;
  if (std::min(finding.frame, kShown) < std::min(other.frame, kShown)) finding = other;
  finding.count = count;
}

std::string placeless_message_of(const Finding& finding) {
  return subject_of(finding.trial) + " " + std::string(info_of(finding.kind).label) +
         (finding.amount > 0 ? measure_of(finding) : "");
}

std::string message_of(const Finding& finding) {
  std::string text = placeless_message_of(finding);
  text += " at " + px_text(finding.place.x) + ", " + px_text(finding.place.y) + " px";
  if (!info_of(finding.kind).of_level) text += " (solver " + std::string(solver_name(finding.solver)) + ")";
  return text;
}

}  // namespace talus
