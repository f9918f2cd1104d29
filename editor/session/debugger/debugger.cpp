#include "debugger.h"

#include <algorithm>
#include <cassert>

namespace talus {
namespace {

constexpr double kSeconds = 0.004;      // of processor time, for a call of advance()
constexpr double kJudgeSeconds = 0.02;  // for judging a frame, and for counting the hits before a step

}  // namespace

FrameView Debugger::view(const Timeline& timeline) const {
  return shown_frame_.view(timeline, source(), other_id(timeline));
}

const std::shared_ptr<const Terrain>& Debugger::ground(const Timeline& timeline) const {
  const auto& own = timeline.scene().ground;
  return own != nullptr ? own : shown_.get()->ground(timeline.frame());
}

const std::vector<Stage>& Debugger::stages(const Timeline& timeline, int body) const {
  // The stages of the other solvers do not show the ground.
  const bool is_exact = timeline.scene().tuning.solver == SolverKind::exact;
  return shown_frame_.stages(timeline, is_exact ? ground(timeline) : nullptr, body);
}

const State* Debugger::other_state(const Timeline& timeline) const {
  // Reading a frame compiles the ground for measurements, so it is done only if needed.
  if (!side_.has(timeline.frame())) return nullptr;
  const auto& other = view(timeline).now().other;
  return other ? &*other : nullptr;
}

void Debugger::follow(const Timeline& timeline, const Level& level) {
  const Branch& branch = timeline.current();
  const bool is_other = branch.id != branch_ || branch.revision != revision_;
  const BranchFrames& frames = shown_.of(branch);
  if (&timeline.scene() == timeline.level_scene().get())
    frames.know(branch.chapters[branch.chapter_at(timeline.frame())].version, timeline.level_scene());
  side_.follow(timeline, level, frames_.count());
  if (is_other || side_.id() != side_id_) forget_parting();
  if (!is_other && side_.id() != side_id_) breakpoints_.forget_hits();
  side_id_ = side_.id();
  if (is_other) {
    breakpoints_.forget_frames();
    plots_.begin_again();
    parting_plot_.begin_again();
  }
  branch_ = branch.id;
  revision_ = branch.revision;
}

void Debugger::forget_timeline() {
  compare_with(std::nullopt);
  forget_parting();
  const std::vector<Breakpoint> all = breakpoints_.all();
  for (Breakpoint breakpoint : all) {
    breakpoint.enabled = false;
    breakpoints_.put(breakpoint);
  }
  breakpoints_.forget_frames();
  stop_.reset();
  search_failed_ = false;
  shown_.clear();
  shown_frame_.forget();
  other_frames_.clear();
  other_frame_ = {};
  branch_ = revision_ = 0;
}

void Debugger::search(const Timeline& timeline, SearchDirection direction) {
  search_failed_ = false;
  stop_.reset();
  breakpoints_.search(timeline.frame(), direction);
}

void Debugger::search_parting(double threshold) {
  search_failed_ = false;
  stop_.reset();
  auto armed = ArmedBreakpoint::arm({.condition = parting_condition(threshold)});
  if (!armed || side_.frames() == nullptr) return;
  breakpoints_.search_first(std::move(*armed));
}

void Debugger::search_last_stop(const Timeline& timeline, int body) {
  search_failed_ = false;
  stop_.reset();
  const Body* const found = timeline.state().find(body);
  if (found == nullptr) return;
  const char* const condition = traits_of(found->kind).takes_keys
                                    ? "(input.left || input.right) && x == before(x)"
                                    : "vx == 0 && before(vx) != 0";
  auto armed = ArmedBreakpoint::arm({.id = kStoppedBody, .condition = condition, .body = body});
  assert(armed);
  breakpoints_.search_last(std::move(*armed), timeline.frame() + 1);
}

bool Debugger::may_step(const Timeline& timeline) {
  if (breakpoints_.is_judging(timeline.frame())) return false;
  const Stopwatch clock;
  bool ready = false;
  do {
    const TimedPiece piece(counted_);
    ready = breakpoints_.ready(source(), timeline.frame(), counted_.count());
  } while (!ready && clock.seconds() < kJudgeSeconds);
  if (ready) counted_.begin_again();
  return ready;
}

bool Debugger::stops_at(const Timeline& timeline, const Level& level) {
  stop_.reset();
  if (breakpoints_.all().empty()) return false;
  follow(timeline, level);
  breakpoints_.begin_frame(source(), timeline.frame());
  return still_stops_at(timeline);
}

bool Debugger::still_stops_at(const Timeline& timeline) {
  if (!breakpoints_.is_judging(timeline.frame())) return false;
  const Stopwatch clock;
  stop_.reset();
  while (!breakpoints_.judge_more(stop_))
    if (clock.seconds() > kJudgeSeconds) return false;
  return stop_.has_value();
}

void Debugger::compare_with(std::optional<Variant> variant) {
  side_.set_variant(variant);
  plots_.begin_again();
  parting_plot_.begin_again();
}

std::optional<std::int64_t> Debugger::advance(const Timeline& timeline, const Level& level, int chosen_body) {
  const Stopwatch clock;
  other_is_behind_ = false;
  do {
    const TimedPiece piece(frames_);
    follow(timeline, level);
    const bool side_behind = side_.variant() != nullptr && !side_.has(timeline.current().run_frame());
    is_busy_ = side_behind;
    if (side_behind) continue;
    if (breakpoints_.advance_search(source(), frames_.count())) {
      stop_ = breakpoints_.found();
      search_failed_ = !stop_;
      return stop_ ? std::optional(stop_->frame) : std::nullopt;
    }
    // One after another: frames that are read in order cost a step each, others a seek.
    const bool done = !searching() &&
                      shown_frame_.advance(timeline, source(), other_id(timeline), kSeconds) &&
                      breakpoints_.count(source(), timeline.frame(), frames_.count()) &&
                      advance_plots(timeline, chosen_body) && advance_parting();
    is_busy_ = !done;
  } while (is_busy_ && clock.seconds() < kSeconds);
  if (!is_busy_) frames_.begin_again();
  return std::nullopt;
}

// Returns true at the last frame.
bool Debugger::advance_plots(const Timeline& timeline, int chosen_body) {
  const bool done = plots_.advance(source(), chosen_body, frames_.count());
  if (side_.frames() == nullptr) return done;
  if (parting_plot_.all().empty()) parting_plot_.put(0, {"parting", 0});
  const auto& bodies = timeline.state().bodies;
  const int body = chosen_body != 0 || bodies.empty() ? chosen_body : bodies.front().id;
  return parting_plot_.advance(source(), body, frames_.count()) && done;
}

// The whole branch, and what is played later: forwards from the frames that were searched before. Returns
// true at the last frame.
bool Debugger::advance_parting() {
  if (side_.variant() == nullptr || parting_frame_) return true;
  if (!parting_search_) {
    if (parting_searched_ >= source().last()) return true;
    auto armed = ArmedBreakpoint::arm({.condition = parting_condition(parting_)});
    if (!armed) return true;
    parting_search_.emplace(std::vector{std::move(*armed)}, parting_searched_, SearchDirection::forwards);
  }
  if (!parting_search_->advance(source(), frames_.count())) return false;
  if (parting_search_->found()) parting_frame_ = parting_search_->found()->frame;
  parting_searched_ = source().last();
  parting_search_.reset();
  return true;
}

void Debugger::forget_parting() {
  parting_search_.reset();
  parting_searched_ = -1;
  parting_frame_.reset();
}

void Debugger::set_parting(double threshold) {
  parting_ = threshold;
  forget_parting();
}

std::optional<std::int64_t> Debugger::parting_frame(const Timeline& timeline) const {
  return side_.variant() != nullptr ? parting_frame_ : timeline.parting_frame();
}

std::optional<std::int64_t> Debugger::other_end() const {
  return side_.frames() != nullptr ? std::optional(side_.frames()->last()) : std::nullopt;
}

std::optional<double> Debugger::comparing_progress(const Timeline& timeline) const {
  const std::int64_t last = timeline.current().run_frame();
  if (side_.variant() == nullptr || side_.has(last)) return std::nullopt;
  return side_.frames() != nullptr ? static_cast<double>(side_.frames()->last()) /
                                         static_cast<double>(std::max<std::int64_t>(last, 1))
                                   : 0;
}

// Read apart from the judged frames, so that each goes along its branch in order.
const Frame* Debugger::other_frame(const Timeline& timeline) const {
  const Branch* branch = side_.branch(timeline);
  if (branch == nullptr || !side_.has(timeline.frame())) return nullptr;
  const BranchFrames& frames = other_frames_.of(*branch);
  const bool known = other_frame_.scene != nullptr && other_id_ == other_frames_.id() &&
                     other_frame_.state.frame == timeline.frame();
  if (!known) {
    const Stopwatch clock;
    while (!frames.approach(timeline.frame()))
      if (clock.seconds() > kSeconds) {
        other_is_behind_ = true;
        return nullptr;
      }
    frames.read(timeline.frame(), other_frame_);
  }
  other_id_ = other_frames_.id();
  return &other_frame_;
}

const Series* Debugger::parting_series() const {
  if (side_.frames() == nullptr || parting_plot_.all().empty()) return nullptr;
  return parting_plot_.series(parting_plot_.all().front());
}

}  // namespace talus
