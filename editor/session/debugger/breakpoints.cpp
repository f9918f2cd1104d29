#include "breakpoints.h"

#include <algorithm>

namespace talus {

std::string text_of(const Stop& stop) {
  const std::string frame = std::to_string(stop.frame);
  if (stop.breakpoint == kStoppedBody)
    return "Body " + std::to_string(stop.body) + " was stopped at frame " + frame + ".";
  std::string text = stop.breakpoint != 0 ? "Breakpoint " + std::to_string(stop.breakpoint) + " at frame "
                                          : "They part at frame ";
  text += frame;
  if (stop.body != 0) text += ", body " + std::to_string(stop.body);
  if (stop.hit > 0) text += ", hit " + std::to_string(stop.hit);
  return text + ".";
}

void Breakpoints::put(Breakpoint breakpoint) {
  if (breakpoint.id == 0) breakpoint.id = ++last_id_;
  last_id_ = std::max(last_id_, breakpoint.id);
  const auto at =
      std::find_if(all_.begin(), all_.end(), [&](const Breakpoint& b) { return b.id == breakpoint.id; });
  if (at == all_.end()) {
    all_.push_back(std::move(breakpoint));
  } else {
    *at = std::move(breakpoint);
  }
  forget_frames();
}

void Breakpoints::remove(int breakpoint) {
  std::erase_if(all_, [&](const Breakpoint& b) { return b.id == breakpoint; });
  forget_frames();
}

// A breakpoint with a faulty condition does not stop; the panel shows the error.
std::vector<ArmedBreakpoint> Breakpoints::armed() const {
  std::vector<ArmedBreakpoint> armed;
  for (const Breakpoint& breakpoint : all_) {
    if (auto ready = ArmedBreakpoint::arm(breakpoint)) armed.push_back(std::move(*ready));
  }
  return armed;
}

void Breakpoints::forget_frames() {
  counter_ = HitCounter(armed());
  forget_hits();
  history_.emplace(counter_.frames_before());
  judged_ = -1;
  judging_.reset();
  search_.reset();
}

void Breakpoints::forget_hits() { log_.emplace(armed()); }

bool Breakpoints::ready(const FrameSource& source, std::int64_t frame, std::int64_t most_frames) {
  if (counter_.empty() || judged_ == frame) return true;
  if (!counter_.counts()) {
    forget_frame();
    history_->clear();
    judged_ = frame;
    return true;
  }
  if (judged_ > frame) forget_frames();
  std::optional<Stop> stop;
  for (; most_frames > 0 && judged_ < frame; --most_frames) {
    if (judging_ || history_->approach(source, judged_ + 1)) {
      judging_ = judged_ + 1;
      judge_more(stop);
    }
  }
  return judged_ == frame;
}

void Breakpoints::begin_frame(const FrameSource& source, std::int64_t frame) {
  if (counter_.empty() || frame > source.last()) return;
  forget_frame();
  history_->go_to(source, frame);
  judging_ = frame;
}

bool Breakpoints::judge_more(std::optional<Stop>& stop) {
  if (!counter_.advance(history_->view(), kBodiesAtOnce)) return false;
  judged_ = *judging_;
  judging_.reset();
  log_->note(judged_, counter_);
  stop = counter_.stop();
  // If no breakpoint counts, the counter begins wherever the game plays.
  if (stop && !counter_.counts()) stop->hit = log_->hits(stop->breakpoint, judged_).value_or(0);
  return true;
}

void Breakpoints::forget_frame() {
  counter_.forget_frame();
  judging_.reset();
}

void Breakpoints::search(std::int64_t from, SearchDirection direction) {
  direction_ = direction;
  found_.reset();
  search_.emplace(armed(), from, direction);
}

void Breakpoints::search_first(ArmedBreakpoint condition) {
  direction_ = SearchDirection::forwards;
  found_.reset();
  search_.emplace(std::vector{std::move(condition)}, -1, direction_);
}

void Breakpoints::search_last(ArmedBreakpoint condition, std::int64_t before) {
  direction_ = SearchDirection::backwards;
  found_.reset();
  search_.emplace(std::vector{std::move(condition)}, before, direction_);
}

bool Breakpoints::advance_search(const FrameSource& source, std::int64_t most_frames) {
  if (!search_ || !search_->advance(source, most_frames)) return false;
  found_ = search_->found();
  search_.reset();
  return true;
}

}  // namespace talus
