#include "hit_log.h"

#include <algorithm>

namespace talus {

HitLog::HitLog(const std::vector<ArmedBreakpoint>& breakpoints)
    : counter_(breakpoints), history_(counter_.frames_before()) {
  for (const ArmedBreakpoint& armed : breakpoints)
    if (armed.breakpoint().enabled) hits_.push_back({armed.breakpoint().id, {}});
}

bool HitLog::advance(const FrameSource& source, std::int64_t frame, std::int64_t most_frames) {
  if (hits_.empty()) return true;
  for (; most_frames > 0 && judged_ < frame; --most_frames) {
    if (history_.approach(source, judged_ + 1)) judge(history_.view());
  }
  return judged_ >= frame;
}

void HitLog::note(const FrameView& view) {
  if (!hits_.empty() && view.now().state.frame == judged_ + 1) judge(view);
}

void HitLog::judge(const FrameView& view) {
  counter_.judge(view);
  judged_ = view.now().state.frame;
  for (Hits& hits : hits_)
    if (counter_.hits(hits.breakpoint) > static_cast<int>(hits.frames.size())) hits.frames.push_back(judged_);
}

std::optional<int> HitLog::hits(int breakpoint, std::int64_t frame) const {
  const auto of = std::find_if(hits_.begin(), hits_.end(),
                               [&](const Hits& hits) { return hits.breakpoint == breakpoint; });
  if (of == hits_.end()) return 0;
  if (frame > judged_) return std::nullopt;
  const auto end = std::upper_bound(of->frames.begin(), of->frames.end(), frame);
  return static_cast<int>(end - of->frames.begin());
}

}  // namespace talus
