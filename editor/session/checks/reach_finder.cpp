// Starts, continues and ends the search.
#include "reach_finder.h"

#include <algorithm>

namespace talus {

std::optional<std::string> ReachFinder::start(const Scene& scene, std::optional<BodyOrigin> origin) {
  if (!scene.ground && !scene.single_ground)
    return "Only the exact solver has players: choose it in Tuning to see where one gets to.";
  const State state = initial_state(scene);
  const Body* player = nullptr;
  for (const Body& body : state.bodies) {
    if (traits_of(body.kind).takes_keys && (player == nullptr || body.origin == origin)) player = &body;
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
  const Stopwatch watch;
  while (running_ && watch.seconds() < seconds) {
    const TimedPiece piece(share_);
    running_ = !search_->advance(static_cast<int>(share_.count()));
  }
}

void ReachFinder::note_change() {
  running_ = false;
  is_stale_ = search_.has_value();
}

void ReachFinder::forget() { *this = {}; }

}  // namespace talus
