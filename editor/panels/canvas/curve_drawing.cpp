// Lines, handles and marks.
#include "curve_drawing.h"

#include <algorithm>
#include <cmath>

#include "debug/number_text.h"

namespace talus {
namespace {

constexpr int kMaxPoints = 512;          // of a curve that crosses the canvas
constexpr float kLeastPointGap = 6;      // px of the screen: closer handles are left out
constexpr float kHandle = 4, kRing = 6;  // px at scale 1

}  // namespace

std::string position_text(Vec2 p) { return exact_text(p.x) + ", " + exact_text(p.y); }

void CurvePen::line(Vec2 from, Vec2 to, ImU32 color) const {
  list_.AddLine(view_.to_screen(from), view_.to_screen(to), theme::color(theme::kDark, 200), width_ + 2);
  list_.AddLine(view_.to_screen(from), view_.to_screen(to), color, width_);
}

void CurvePen::stroke(const Curve& curve, ImU32 color) const {
  const Rect visible = view_.visible();
  const std::vector<Vec2> points = points_of(curve, visible.x, visible.right(), kMaxPoints);
  std::vector<ImVec2> drawn;
  drawn.reserve(points.size());
  for (const Vec2 point : points) drawn.push_back(view_.to_screen(point));
  const int count = static_cast<int>(drawn.size());
  list_.AddPolyline(drawn.data(), count, theme::color(theme::kDark, 200), ImDrawFlags_None, width_ + 2);
  list_.AddPolyline(drawn.data(), count, color, ImDrawFlags_None, width_);
}

void CurvePen::handles(const Curve& curve, int lit, Ui& ui) const {
  const std::vector<Vec2> handles = handles_of(curve);
  for (const auto& [a, b] : handle_lines(curve))
    list_.AddLine(view_.to_screen(handles[static_cast<std::size_t>(a)]),
                  view_.to_screen(handles[static_cast<std::size_t>(b)]), theme::color(theme::kAccent, 120),
                  1);
  const bool is_polyline = kind_of(curve) == CurveKind::polyline;
  const float side = ui.px(kHandle);
  const int last = static_cast<int>(handles.size()) - 1;
  for (int i = 0; i <= last; ++i) {
    const ImVec2 at = view_.to_screen(handles[static_cast<std::size_t>(i)]);
    const bool is_end = is_end_handle(curve, i);
    if (is_polyline && !is_end &&
        view_.to_screen(handles[static_cast<std::size_t>(i + 1)]).x - at.x < kLeastPointGap)
      continue;
    const ImVec2 outside{std::max(view_.min.x - at.x, at.x - view_.max.x),
                         std::max(view_.min.y - at.y, at.y - view_.max.y)};
    if (std::max(outside.x, outside.y) > side + 1) continue;
    const ImU32 color = theme::color(i == lit ? theme::kWarning : theme::kText);
    if (is_end) {
      list_.AddRectFilled({at.x - side - 1, at.y - side - 1}, {at.x + side + 1, at.y + side + 1},
                          theme::color(theme::kDark));
      list_.AddRectFilled({at.x - side, at.y - side}, {at.x + side, at.y + side}, color);
    } else {
      list_.AddCircleFilled(at, side + 1, theme::color(theme::kDark));
      list_.AddCircleFilled(at, side, color);
    }
    ui.place("map/curve_handle" + std::to_string(i), {at.x - side, at.y - side}, {at.x + side, at.y + side});
  }
}

void CurvePen::title(const std::string& text, ImVec2 beside, std::uint32_t color) const {
  const ImVec2 size = size_of_text(text);
  const float gap = 4 * width_;
  ImVec2 at{beside.x + gap, beside.y - size.y - gap};
  at.x = std::max(view_.min.x + gap, std::min(at.x, view_.max.x - size.x - gap));
  at.y = std::clamp(at.y, view_.min.y + gap, std::max(view_.min.y + gap, view_.max.y - size.y - gap));
  list_.AddRectFilled({at.x - 4, at.y - 2}, {at.x + size.x + 4, at.y + size.y + 2},
                      theme::color(theme::kDark, theme::kPlateAlpha), 3);
  add_text(list_, at, theme::color(color), text);
}

void CurvePen::snapped(const SnappedPoint& point, const Ui& ui, std::string_view word) const {
  const ImVec2 at = view_.to_screen(point.point);
  const float dot = ui.px(3), ring = ui.px(kRing);
  const ImU32 dark = theme::color(theme::kDark, 200), bright = theme::color(theme::kAccent);
  list_.AddCircleFilled(at, dot + 1, dark);
  list_.AddCircleFilled(at, dot, bright);
  switch (point.to) {
    case SnappedPoint::To::end:
      list_.AddCircle(at, ring, dark, 0, 4);
      list_.AddCircle(at, ring, theme::color(theme::kWarning), 0, 2);
      break;
    case SnappedPoint::To::tile:
      list_.AddRect({at.x - ring, at.y - ring}, {at.x + ring, at.y + ring}, dark, 0, 0, 3);
      list_.AddRect({at.x - ring, at.y - ring}, {at.x + ring, at.y + ring}, bright, 0, 0, 1);
      break;
    case SnappedPoint::To::half:
      list_.AddNgon(at, ring, bright, 4, 1);
      break;
    default:
      break;
  }
  const bool on_end = point.to == SnappedPoint::To::end;
  const std::string text = std::string(word) + (!on_end ? "" : word.empty() ? "end" : ", on an end");
  if (!text.empty()) title(text, at, on_end ? theme::kWarning : theme::kText);
}

}  // namespace talus
