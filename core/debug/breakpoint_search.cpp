#include "breakpoint_search.h"

#include <algorithm>

namespace talus {
namespace {

constexpr std::int64_t kBlock = 256;  // frames

}  // namespace

BreakpointSearch::BreakpointSearch(std::vector<ArmedBreakpoint> breakpoints, std::int64_t from,
                                   SearchDirection direction)
    : counter_(std::move(breakpoints)),
      history_(counter_.frames_before()),
      from_(from),
      direction_(direction),
      is_done_(counter_.empty()) {
  if (direction == SearchDirection::backwards) {
    begin_block_before(from);
  } else {
    next_ = block_ = counter_.counts() ? 0 : from + 1;
  }
}

void BreakpointSearch::begin_block_before(std::int64_t end) {
  block_end_ = end;
  next_ = block_ = counter_.counts() ? 0 : std::max<std::int64_t>(end - kBlock, 0);
  if (end <= 0) is_done_ = true;
}

bool BreakpointSearch::advance(const FrameSource& source, std::int64_t frames) {
  for (; frames > 0 && !is_done_; --frames) judge(source);
  return is_done_;
}

void BreakpointSearch::judge(const FrameSource& source) {
  const bool is_forwards = direction_ == SearchDirection::forwards;
  if (is_forwards && next_ > source.last()) {
    is_done_ = true;
    return;
  }
  is_judging_ = is_judging_ || history_.approach(source, next_);
  if (!is_judging_ || !counter_.advance(history_.view(), kBodiesAtOnce)) return;
  is_judging_ = false;
  std::optional<Stop> stop = counter_.stop();
  if (stop && !counter_.counts()) stop->hit = 0;
  ++judged_;
  ++next_;
  if (is_forwards) {
    if (!stop || stop->frame <= from_) return;
    found_ = stop;
    is_done_ = true;
    return;
  }
  if (stop) found_ = stop;
  if (next_ < block_end_) return;
  if (found_) {
    is_done_ = true;
  } else {
    begin_block_before(block_);
  }
}

double BreakpointSearch::progress(const FrameSource& source) const {
  if (is_done_) return 1;
  const std::int64_t first = counter_.counts() ? 0 : from_ + 1;
  const std::int64_t all = direction_ == SearchDirection::backwards ? from_ : source.last() + 1 - first;
  return all > 0 ? static_cast<double>(judged_) / static_cast<double>(all) : 1;
}

}  // namespace talus
