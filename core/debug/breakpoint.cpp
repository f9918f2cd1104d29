#include "breakpoint.h"

#include <algorithm>

#include "number_text.h"

namespace talus {
namespace {

constexpr std::array kBreakpointKinds = {
    BreakpointKindInfo{
        BreakpointKind::touches_tile, "contact with a tile", {{{"column", ""}, {"row", ""}}}, false},
    BreakpointKindInfo{BreakpointKind::touches_body, "contact with a body", {{{"body", "", 1}}}, false},
    BreakpointKindInfo{BreakpointKind::normal_range,
                       "normal in a range",
                       {{{"from", "degrees", -45}, {"to", "degrees", 45}}},
                       false},
    BreakpointKindInfo{BreakpointKind::slope_delta, "|slope delta| over", {{{"over", "", 0.5}}}, false},
    BreakpointKindInfo{BreakpointKind::grounded, "grounded changes", {}, true},
    BreakpointKindInfo{BreakpointKind::penetration, "penetration over", {{{"over", "px", 0.01}}}, false},
    BreakpointKindInfo{BreakpointKind::speed, "speed over", {{{"over", "px/frame", 4}}}, false},
    BreakpointKindInfo{
        BreakpointKind::enters_cell, "body enters a cell", {{{"column", ""}, {"row", ""}}}, false},
    BreakpointKindInfo{BreakpointKind::enters_rect,
                       "body enters a rectangle",
                       {{{"x", "px"}, {"y", "px"}, {"w", "px", 8}, {"h", "px", 8}}},
                       false},
    BreakpointKindInfo{BreakpointKind::capped, "cap reached", {}, false},
    BreakpointKindInfo{BreakpointKind::parting, "solvers part by more than", {{{"over", "px", 0.01}}}, false},
};

}  // namespace

std::span<const BreakpointKindInfo> breakpoint_kind_infos() { return kBreakpointKinds; }

std::string condition_of(BreakpointKind kind, std::span<const double> fields) {
  const BreakpointKindInfo& info = kBreakpointKinds[static_cast<std::size_t>(kind)];
  const auto field = [&](std::size_t i) {
    return exact_text(i < fields.size() ? fields[i] : info.fields[i].standard);
  };
  switch (kind) {
    case BreakpointKind::touches_tile:
      return "touches(" + field(0) + ", " + field(1) + ")";
    case BreakpointKind::touches_body:
      return "touches_body(" + field(0) + ")";
    case BreakpointKind::normal_range:
      return "normal.angle >= " + field(0) + " && normal.angle <= " + field(1);
    case BreakpointKind::slope_delta:
      return "abs(slope_delta) > " + field(0);
    case BreakpointKind::grounded:
      return "changed(grounded)";
    case BreakpointKind::penetration:
      return "penetration > " + field(0);
    case BreakpointKind::speed:
      return "speed > " + field(0);
    case BreakpointKind::enters_cell:
      return "in_cell(" + field(0) + ", " + field(1) + ")";
    case BreakpointKind::enters_rect:
      return "in_rect(" + field(0) + ", " + field(1) + ", " + field(2) + ", " + field(3) + ")";
    case BreakpointKind::capped:
      return "capped";
    case BreakpointKind::parting:
      return "parting > " + field(0);
  }
  return {};
}

tl::expected<ArmedBreakpoint, ExpressionError> ArmedBreakpoint::arm(const Breakpoint& breakpoint) {
  auto condition = Expression::parse_condition(breakpoint.condition);
  if (!condition) return tl::unexpected(condition.error());
  return ArmedBreakpoint(breakpoint, std::move(*condition));
}

bool ArmedBreakpoint::held(const FrameView& view, int body, std::size_t back) const {
  if (condition_.asks_body() && view.before(back).state.find(body) == nullptr) return false;
  return condition_.evaluate(view, body, back) != 0;
}

bool ArmedBreakpoint::hits_for(const FrameView& view, int body) const {
  if (!held(view, body, 0)) return false;
  return breakpoint_.each_frame || view.is_first() || !held(view, body, 1);
}

std::optional<int> ArmedBreakpoint::hit(const FrameView& view) const {
  for (std::size_t i = 0; i < questions(view); ++i) {
    if (const auto body = hit(view, i)) return body;
  }
  return std::nullopt;
}

std::size_t ArmedBreakpoint::questions(const FrameView& view) const {
  return condition_.asks_body() && breakpoint_.body == 0 ? view.now().state.bodies.size() : 1;
}

std::optional<int> ArmedBreakpoint::hit(const FrameView& view, std::size_t question) const {
  int body = 0;
  if (condition_.asks_body())
    body = breakpoint_.body != 0 ? breakpoint_.body : view.now().state.bodies[question].id;
  return hits_for(view, body) ? std::optional(body) : std::nullopt;
}

HitCounter::HitCounter(std::vector<ArmedBreakpoint> breakpoints) : breakpoints_(std::move(breakpoints)) {
  std::erase_if(breakpoints_, [](const ArmedBreakpoint& armed) { return !armed.breakpoint().enabled; });
  hits_.assign(breakpoints_.size(), 0);
  hit_.resize(breakpoints_.size());
  for (const ArmedBreakpoint& armed : breakpoints_)
    frames_before_ = std::max(frames_before_, armed.frames_before());
}

bool HitCounter::counts() const {
  return std::any_of(breakpoints_.begin(), breakpoints_.end(),
                     [](const ArmedBreakpoint& armed) { return armed.breakpoint().count > 1; });
}

int HitCounter::hits(int breakpoint) const {
  for (std::size_t i = 0; i < breakpoints_.size(); ++i) {
    if (breakpoints_[i].breakpoint().id == breakpoint) return hits_[i];
  }
  return 0;
}

bool HitCounter::was_hit(int breakpoint) const {
  for (std::size_t i = 0; i < breakpoints_.size(); ++i) {
    if (breakpoints_[i].breakpoint().id == breakpoint) return hit_[i].has_value();
  }
  return false;
}

bool HitCounter::advance(const FrameView& view, std::size_t bodies) {
  for (; breakpoint_ < breakpoints_.size(); ++breakpoint_, question_ = 0) {
    const ArmedBreakpoint& armed = breakpoints_[breakpoint_];
    std::optional<int>& body = hit_[breakpoint_];
    if (question_ == 0) body.reset();
    for (const std::size_t all = armed.questions(view); question_ < all && !body; ++question_) {
      if (bodies-- == 0) return false;
      body = armed.hit(view, question_);
    }
  }
  forget_frame();
  count_hits(view.now().state.frame);
  return true;
}

void HitCounter::forget_frame() { breakpoint_ = question_ = 0; }

void HitCounter::count_hits(std::int64_t frame) {
  stop_.reset();
  for (std::size_t i = 0; i < breakpoints_.size(); ++i) {
    if (!hit_[i]) continue;
    const Breakpoint& breakpoint = breakpoints_[i].breakpoint();
    ++hits_[i];
    if (!stop_ && hits_[i] >= breakpoint.count) stop_ = Stop{frame, breakpoint.id, *hit_[i], hits_[i]};
  }
}

}  // namespace talus
