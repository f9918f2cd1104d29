#include "answer.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "overlay_pen.h"

namespace talus {
namespace {

constexpr const Overlay* kId = &overlay::answer;
constexpr int kCurveLines = 24;  // drawn for each curve of the floor
constexpr double kPathStep =
    8;  // px between the points of a path along the floor, unless more of it is visible
constexpr double kMaxOfPath = 1024;  // points of one path
constexpr int kMaxOfPaths = 2048;    // of all

class AnswerDrawer {
 public:
  AnswerDrawer(const HardCase& hard, const Level& level, Rect visible, OverlayDrawing& out)
      : hard_(hard), level_(level), pen_(*kId, visible, out) {
    for (const CaseCheck& check : hard.checks) checks_[check.body].push_back(&check);
  }

  void draw() {
    for (const auto& part : hard_.floor.parts) draw_part(part);
    for (std::size_t i = 0; i < level_.spawns.size(); ++i) draw_body(static_cast<int>(i) + 1);
  }

 private:
  Rect start_of(int body) const {
    const Spawn& spawn = level_.spawns[static_cast<std::size_t>(body - 1)];
    return {spawn.position.x, spawn.position.y, spawn.size.x, spawn.size.y};
  }

  // Returns the box that a check of a position wants. A coordinate that the check leaves open is that of the
  // start.
  Rect wanted(const CaseCheck& check) const {
    Rect box = start_of(check.body);
    if (check.x || check.right) box.x = check.x ? *check.x : *check.right - box.w;
    if (check.y || check.bottom) box.y = check.y ? *check.y : *check.bottom - box.h;
    return box;
  }

  void draw_part(const std::variant<Segment, Arc, Sine>& part) {
    if (const auto* segment = std::get_if<Segment>(&part)) return pen_.line(segment->from, segment->to);
    CaseFloor alone;
    alone.parts.push_back(part);
    const auto [x0, x1] = part.index() == 1 ? std::pair(std::get<Arc>(part).x0, std::get<Arc>(part).x1)
                                            : std::pair(std::get<Sine>(part).x0, std::get<Sine>(part).x1);
    const auto at = [&, left = x0, width = x1 - x0](int i) {
      const double x = left + width * i / kCurveLines;
      return Vec2{x, alone.top(x, x).value_or(0)};
    };
    for (int i = 0; i < kCurveLines; ++i) pen_.line(at(i), at(i + 1));
  }

  void draw_body(int body) {
    Rect at = start_of(body);
    pen_.box(at);
    const auto checks = checks_.find(body);
    if (checks == checks_.end()) return;
    const bool stands = draw_positions(checks->second, at);
    for (const CaseCheck* check : checks->second) {
      if (check->measure == CaseCheck::Measure::reaches && check->x && !stands)
        draw_way(start_of(body), *check->x);
      if (check->measure == CaseCheck::Measure::velocity)
        pen_.line(at.center(),
                  at.center() + Vec2{check->x.value_or(0), check->y.value_or(0)} * kPixelsPerVelocity, true);
    }
  }

  // Draws ghosts of the body where it should be, each with an arrow from the one before. Sets `at` to the
  // last of them. Returns whether a check gives an x.
  bool draw_positions(const std::vector<const CaseCheck*>& checks, Rect& at) {
    bool any = false;
    for (const CaseCheck* check : checks) {
      if (check->measure != CaseCheck::Measure::position) continue;
      const Rect next = wanted(*check);
      any = any || check->x || check->right;
      if (next == at || !(check->x || check->right || check->y)) continue;
      pen_.box(next, true);
      pen_.line(at.center(), next.center(), true);
      at = next;
    }
    return any;
  }

  // Draws the path of the body's centre to where it should get: along the floor, or straight if there is no
  // floor.
  void draw_way(const Rect& start, double x) {
    const Rect& seen = pen_.visible();
    const double sign = x < start.x ? -1 : 1, length = std::abs(x - start.x);
    const double step = std::max(kPathStep, std::ceil(seen.w / kMaxOfPath));
    // The points from just before the visible part to just behind it.
    const double near = sign > 0 ? seen.x - start.center().x : start.center().x - seen.right();
    const double first = std::max(1.0, std::floor(near / step));
    const double last = std::min(std::floor(length / step), std::ceil((near + seen.w) / step));
    const auto point = [&](double i) -> std::optional<Vec2> {
      const double left = start.x + sign * step * i;
      const auto top = hard_.floor.parts.empty() ? start.bottom() : hard_.floor.top(left, left + start.w);
      if (!top) return std::nullopt;
      return Vec2{left + start.w / 2, *top - start.h / 2};
    };
    std::optional<Vec2> from = first > 1 ? point(first - 1) : start.center();
    for (double i = first; i <= last && points_ < kMaxOfPaths; ++i, ++points_) {
      const auto to = point(i);
      if (from && to) pen_.line(*from, *to, step * (i + 1) > length);
      if (to) from = to;
    }
  }

  const HardCase& hard_;
  const Level& level_;
  OverlayPen pen_;
  std::map<int, std::vector<const CaseCheck*>> checks_;  // by body
  int points_ = 0;                                       // of paths, so far
};

}  // namespace

void add_answer(const HardCase& hard, const Level& level, Rect visible, OverlayDrawing& drawing) {
  AnswerDrawer(hard, level, visible, drawing).draw();
}

namespace {

void draw_answer(const OverlaySource& source, OverlayPen& pen) {
  if (source.hard_case != nullptr) add_answer(*source.hard_case, *source.level, pen.visible(), pen.drawing());
}

}  // namespace

namespace overlay {

const Overlay answer{
    .key = "answer",
    .label = "right answer",
    .help =
        "For a hard case: where bodies start, where they should be, and the floor that they should stay on.",
    .color = 0xa7f070,
    .safe_color = 0x8cc850,
    .digit = '8',
    .layer = 2,
    .draw = draw_answer,
    .draw_swatch =
        [](OverlayPen& pen) {
          pen.box({3, 1, 4, 4}, true);
          pen.line({0, 6.5}, {8, 6.5});
        },
};

}  // namespace overlay
}  // namespace talus
