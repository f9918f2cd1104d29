// Trails of bodies.
#include "trail.h"

#include <algorithm>

namespace talus {

const std::vector<TrailPoint>& Trails::trail(const Timeline& timeline, const Branch& branch, int body,
                                             std::int64_t first, std::int64_t last) {
  last = std::clamp<std::int64_t>(last, 0, branch.run_frame());
  first = std::clamp<std::int64_t>(first, std::max<std::int64_t>(0, last - kMostFrames + 1), last);
  const auto same = [&](const Kept& kept) {
    return kept.branch == branch.id && kept.revision == branch.revision && kept.body == body;
  };
  const auto found = std::find_if(kept_.begin(), kept_.end(), same);
  if (found != kept_.end()) {
    std::rotate(kept_.begin(), found, found + 1);
  } else {
    kept_.insert(kept_.begin(), {branch.id, branch.revision, body, first, first - 1, {}});
    if (kept_.size() > kMost) kept_.pop_back();
  }
  Kept& kept = kept_.front();
  if (first < kept.first || first > kept.last + 1) {
    kept.points.clear();
    kept.last = first - 1;
  }
  std::erase_if(kept.points,
                [&](const TrailPoint& point) { return point.frame < first || point.frame > last; });
  const std::int64_t known = std::min(kept.last, last);
  kept.first = first;
  kept.last = last;
  if (known == last) return kept.points;
  // The frame that is shown need not be made again.
  if (known + 1 == last && branch.id == timeline.current().id && timeline.frame() == last) {
    if (const Body* at = timeline.state().find(body)) kept.points.push_back({last, at->box});
    return kept.points;
  }
  timeline.walk(branch, known + 1, last, false, [&](const State& state, const StepRecord*) {
    if (const Body* at = state.find(body)) kept.points.push_back({state.frame, at->box});
    return true;
  });
  return kept.points;
}

}  // namespace talus
