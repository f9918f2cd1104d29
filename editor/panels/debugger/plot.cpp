#include "plot.h"

#include <cmath>
#include <limits>

#include "frame_zoom.h"
#include "overlay/number_label.h"

namespace talus {
namespace {

struct Range {
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  bool empty() const { return least > greatest; }
};

Range range_of(const Series& series) {
  Range range;
  for (const SeriesPoint& p : series.points()) {
    if (!std::isfinite(p.least) || !std::isfinite(p.greatest)) continue;
    range.least = std::min(range.least, p.least);
    range.greatest = std::max(range.greatest, p.greatest);
  }
  return range;
}

}  // namespace

void draw_plot(ImDrawList& list, const Series& series, const FrameAxis& axis, ImVec2 min, ImVec2 max,
               std::int64_t at, ImU32 color, const Ui& ui) {
  list.AddRectFilled(min, max, theme::color(theme::kDark), ui.px(2));
  const Range range = range_of(series);
  const float cursor = std::round(axis.x_of(static_cast<double>(at)));
  list.AddRectFilled({cursor, min.y}, {cursor + ui.px(1), max.y}, theme::tone(theme::kText, 140));
  if (range.empty()) return;
  const double span = range.greatest - range.least;
  const float top = min.y + ui.px(2), height = max.y - min.y - 2 * ui.px(2);
  const auto y_of = [&](double value) {
    const double share = span > 0 ? (value - range.least) / span : 0.5;
    return top + height * static_cast<float>(1 - share);
  };
  if (range.least < 0 && range.greatest > 0)
    list.AddRectFilled({min.x, y_of(0)}, {max.x, y_of(0) + 1}, theme::tone(theme::kLine));
  ImVec2 before;
  bool has_before = false;
  for (std::size_t i = 0; i < series.points().size(); ++i) {
    const SeriesPoint& p = series.points()[i];
    const bool is_number = std::isfinite(p.least) && std::isfinite(p.greatest);
    const float x = axis.x_of(
        static_cast<double>(series.first() + static_cast<std::int64_t>(i) * series.frames_of_point()));
    if (is_number) {
      const ImVec2 here{x, y_of(std::isfinite(p.last) ? p.last : p.greatest)};
      if (has_before) list.AddLine(before, here, color, ui.px(1));
      if (!has_before || p.least != p.greatest)
        list.AddLine({x, y_of(p.least)}, {x, std::max(y_of(p.greatest), y_of(p.least) + 1)}, color, ui.px(1));
      before = here;
    }
    has_before = is_number;
  }
  const ImU32 muted = theme::tone(theme::kMuted);
  add_text(list, {min.x + ui.px(3), min.y}, muted, small_too(range.greatest));
  const float text = ImGui::GetTextLineHeight();
  if (max.y - min.y > 2 * text && span > 0)
    add_text(list, {min.x + ui.px(3), max.y - text}, muted, small_too(range.least));
}

void draw_timeline_plot(const std::string& name, std::string_view help, const Series* series, ImU32 color,
                        float height, const Session& session, Actions& actions, Ui& ui) {
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  const ImVec2 max{std::max(right, min.x + 1), min.y + height};
  ImGui::InvisibleButton(name.c_str(), {max.x - min.x, height});
  const std::int64_t last = session.timeline().last_frame();
  const FrameAxis axis = axis_of(ui.view.debugger.frames, last, min.x, max.x - min.x);
  const std::int64_t pointed_at = axis.frame_at(ImGui::GetIO().MousePos.x);
  ui.item(name, std::string(help) + "Frame " + std::to_string(pointed_at) + "; click to show it.",
          "wheel zooms, middle button drags");
  handle_frame_zoom(axis, last, ui);
  if (ImGui::IsItemActive()) actions.push_back(action::SeekFrame{pointed_at});
  if (series == nullptr) return;
  ImGui::PushClipRect(min, max, true);
  draw_plot(*ImGui::GetWindowDrawList(), *series, axis, min, max, session.state().frame, color, ui);
  ImGui::PopClipRect();
}

}  // namespace talus
