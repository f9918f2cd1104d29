#include "mouse_mark.h"

namespace talus {

void draw_mouse_mark(ImDrawList& list, const Session& session, const CanvasView& view, const Ui& ui) {
  const std::int64_t frame = session.state().frame;
  if (frame < 1 || frame > session.timeline().last_frame()) return;
  const Input& input = session.timeline().current().input(frame);
  if (input.mouse == Vec2{} && !input.mouse_down) return;  // no mouse was ever used
  const ImVec2 at = view.to_screen(input.mouse);
  const float radius = ui.px(5), arm = ui.px(9), width = ui.px(1.5f);
  const auto stroke = [&](ImU32 color, float thick) {
    list.AddCircle(at, radius, color, 0, thick);
    list.AddLine({at.x - arm, at.y}, {at.x + arm, at.y}, color, thick);
    list.AddLine({at.x, at.y - arm}, {at.x, at.y + arm}, color, thick);
  };
  stroke(theme::color(theme::kDark, 200), width + 2);
  if (input.mouse_down) list.AddCircleFilled(at, radius, theme::color(theme::kAccent));
  stroke(theme::color(theme::kAccent), width);
}

}  // namespace talus
