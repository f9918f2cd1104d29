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
    is_judging_ = is_judging_ || history_.approach(source, judged_ + 1);
    if (is_judging_ && counter_.advance(history_.view(), kBodiesAtOnce)) add(judged_ + 1, counter_);
  }
  return judged_ >= frame;
}

void HitLog::note(std::int64_t frame, const HitCounter& judged) {
  if (hits_.empty() || frame != judged_ + 1) return;
  counter_.forget_frame();
  add(frame, judged);
}

void HitLog::add(std::int64_t frame, const HitCounter& judged) {
  is_judging_ = false;
  judged_ = frame;
  for (Hits& hits : hits_)
    if (judged.was_hit(hits.breakpoint)) hits.frames.push_back(frame);
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
