// Starts, continues and ends the search.
#include "reach_finder.h"

#include <algorithm>
#include <chrono>

namespace talus {
namespace {

constexpr int kStatesAtOnce = 64;  // between looks at the clock

}  // namespace

std::optional<std::string> ReachFinder::start(const Scene& scene, std::optional<BodyOrigin> origin) {
  if (!scene.ground && !scene.single_ground)
    return "Only the exact solver has players: choose it in Tuning to see where one gets to.";
  const State state = initial_state(scene);
  const Body* player = nullptr;
  for (const Body& body : state.bodies) {
    if (body.kind == BodyKind::player && (player == nullptr || body.origin == origin)) player = &body;
  }
  if (player == nullptr)
    return "No player to follow: place a body with the body tool, and make it a player in the inspector.";
  search_.emplace(scene, *player);
  running_ = true;
  is_stale_ = false;
  others_ = static_cast<int>(state.bodies.size()) - 1;
  return std::nullopt;
}

void ReachFinder::advance(double seconds) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const std::chrono::duration<double> most(seconds);
  while (running_ && Clock::now() - start < most) running_ = !search_->advance(kStatesAtOnce);
}

void ReachFinder::note_change() {
  running_ = false;
  is_stale_ = search_.has_value();
}

void ReachFinder::forget() { *this = {}; }

}  // namespace talus
