#include "answer.h"

#include <algorithm>

#include "overlay_pen.h"

namespace talus {
namespace {

constexpr const Overlay* kId = &overlay::answer;
constexpr int kCurveLines = 24;  // drawn for each curve of the floor
constexpr double kPathStep = 8;  // px between the points of a path along the floor

class AnswerDrawer {
 public:
  AnswerDrawer(const HardCase& hard, const Level& level, OverlayDrawing& out)
      : hard_(hard), level_(level), out_(out) {}

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

  void line(Vec2 from, Vec2 to, bool arrow = false) { out_.lines.push_back({kId, from, to, arrow}); }

  void draw_part(const std::variant<Segment, Arc, Sine>& part) {
    if (const auto* segment = std::get_if<Segment>(&part)) return line(segment->from, segment->to);
    CaseFloor alone;
    alone.parts.push_back(part);
    const auto [x0, x1] = part.index() == 1 ? std::pair(std::get<Arc>(part).x0, std::get<Arc>(part).x1)
                                            : std::pair(std::get<Sine>(part).x0, std::get<Sine>(part).x1);
    const auto at = [&, left = x0, width = x1 - x0](int i) {
      const double x = left + width * i / kCurveLines;
      return Vec2{x, alone.top(x, x).value_or(0)};
    };
    for (int i = 0; i < kCurveLines; ++i) line(at(i), at(i + 1));
  }

  void draw_body(int body) {
    Rect at = start_of(body);
    out_.boxes.push_back({kId, at, false});
    const bool stands = draw_positions(body, at);
    for (const CaseCheck& check : hard_.checks) {
      if (check.body != body) continue;
      if (check.measure == CaseCheck::Measure::reaches && check.x && !stands)
        draw_way(start_of(body), *check.x);
      if (check.measure == CaseCheck::Measure::velocity)
        line(at.center(), at.center() + Vec2{check.x.value_or(0), check.y.value_or(0)} * kPixelsPerVelocity,
             true);
    }
  }

  // Draws ghosts of the body where it should be, each with an arrow from the one before. Sets `at` to the
  // last of them. Returns whether a check gives an x.
  bool draw_positions(int body, Rect& at) {
    bool any = false;
    for (const CaseCheck& check : hard_.checks) {
      if (check.body != body || check.measure != CaseCheck::Measure::position) continue;
      const Rect next = wanted(check);
      any = any || check.x || check.right;
      if (next == at || !(check.x || check.right || check.y)) continue;
      out_.boxes.push_back({kId, next, true});
      line(at.center(), next.center(), true);
      at = next;
    }
    return any;
  }

  // Draws the path of the body's centre to where it should get: along the floor, or straight if there is no
  // floor.
  void draw_way(const Rect& start, double x) {
    const double step = x < start.x ? -kPathStep : kPathStep;
    Vec2 from = start.center();
    for (double left = start.x + step; step > 0 ? left <= x : left >= x; left += step) {
      const auto top = hard_.floor.parts.empty() ? start.bottom() : hard_.floor.top(left, left + start.w);
      if (!top) continue;
      const Vec2 to{left + start.w / 2, *top - start.h / 2};
      line(from, to, step > 0 ? left + step > x : left + step < x);
      from = to;
    }
  }

  const HardCase& hard_;
  const Level& level_;
  OverlayDrawing& out_;
};

}  // namespace

void add_answer(const HardCase& hard, const Level& level, OverlayDrawing& drawing) {
  AnswerDrawer(hard, level, drawing).draw();
}

namespace {

void draw_answer(const OverlaySource& source, OverlayPen& pen) {
  if (source.hard_case != nullptr) add_answer(*source.hard_case, *source.level, pen.drawing());
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
