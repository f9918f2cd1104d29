// Collects where a body was, from the keyframes and steps of a branch.
#include "trail.h"

#include <algorithm>

#include "work_share.h"

namespace talus {

const std::vector<TrailPoint>& Trails::trail(const Timeline& timeline, const Branch& branch, int body,
                                             std::int64_t first, std::int64_t last) {
  last = std::clamp<std::int64_t>(last, 0, branch.run_frame());
  first = std::clamp<std::int64_t>(first, std::max<std::int64_t>(0, last - kMaxFrames + 1), last);
  const auto same = [&](const Kept& kept) {
    return kept.branch == branch.id && kept.revision == branch.revision && kept.body == body;
  };
  const auto found = std::find_if(kept_.begin(), kept_.end(), same);
  if (found != kept_.end()) {
    std::rotate(kept_.begin(), found, found + 1);
  } else {
    kept_.insert(kept_.begin(), {branch.id, branch.revision, body, first, first - 1, {}});
    if (kept_.size() > kMax) kept_.pop_back();
  }
  Kept& kept = kept_.front();
  if (first < kept.first || first > kept.last + 1) {
    kept.points.clear();
    kept.last = first - 1;
  }
  std::erase_if(kept.points,
                [&](const TrailPoint& point) { return point.frame < first || point.frame > last; });
  kept.first = first;
  kept.last = std::min(kept.last, last);
  const auto add = [&](const State& state, const StepRecord*) {
    if (const Body* at = state.find(body)) kept.points.push_back({state.frame, at->box});
    kept.last = state.frame;
    return true;
  };
  // The shown frame need not be made again.
  if (kept.last + 1 == last && branch.id == timeline.current().id && timeline.frame() == last)
    add(timeline.state(), nullptr);
  const Stopwatch watch;
  while (kept.last < last && watch.seconds() < seconds_) {
    const std::int64_t next = kept.last + 1;
    if (timeline.approach(branch, next)) timeline.walk(branch, next, next, nullptr, add);
  }
  behind_ = behind_ || kept.last < last;
  return kept.points;
}

}  // namespace talus
