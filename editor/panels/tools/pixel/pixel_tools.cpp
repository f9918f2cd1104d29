// The table of the pixel canvas's tools.
#include "pixel_tools.h"

#include "panels/canvas/drag_cancel.h"
#include "panels/sprites/pixel_selection_drawing.h"

namespace talus {
namespace {

void draw_brush(ImDrawList& list, CellRect brush, const CanvasView& view) {
  const ImVec2 from = view.to_screen({brush.x + 0.0, brush.y + 0.0});
  const ImVec2 to = view.to_screen({brush.x + brush.w + 0.0, brush.y + brush.h + 0.0});
  list.AddRect({from.x - 1, from.y - 1}, {to.x + 1, to.y + 1}, theme::color(theme::kDark));
  list.AddRect(from, to, theme::color(theme::kText));
}

}  // namespace

PixelToolHand::PixelToolHand() {
  tools_[SpriteTool::pencil] = make_pencil();
  tools_[SpriteTool::pick] = make_color_picker();
  tools_[SpriteTool::select] = make_pixel_selector();
  tools_[SpriteTool::fill] = make_pixel_fill();
  tools_[SpriteTool::line] = make_pixel_line();
  tools_[SpriteTool::rectangle] = make_pixel_rectangle();
  tools_[SpriteTool::ellipse] = make_pixel_ellipse();
}

void PixelToolHand::update(const Session& session, Actions& actions, Cell pixel, bool hovered, bool picks) {
  if (active() && (is_drag_cancelled() || held_ != &chosen(session))) held_ = nullptr;
  if (hovered && picks) take_color(session, pixel, false, actions);
  const bool right = ImGui::IsMouseClicked(1);
  if (!active()) {
    if (!hovered || (!right && !ImGui::IsMouseClicked(0))) return;
    held_ = &chosen(session);
    from_ = last_ = pixel;
    right_ = right;
    stroke_ = session.next_stroke();
    held_->press(use(session, pixel), actions);
    return;
  }
  if (pixel != last_) held_->drag(use(session, pixel), actions);
  last_ = pixel;
  if (ImGui::GetIO().MouseDown[right_ ? 1 : 0]) return;
  held_->release(use(session, pixel), actions);
  held_ = nullptr;
}

void PixelToolHand::draw(ImDrawList& list, const Session& session, const CanvasView& view, Cell pixel,
                         bool hovered, float scale) const {
  if (active()) held_->draw(list, use(session, pixel), view);
  const Choices& choices = session.choices();
  const auto& selected = choices.pixels.rect();
  if (selected) draw_pixel_selection(list, *selected, view, scale);
  if (!hovered) return;
  draw_brush(list, brush_at(pixel, chosen(session).uses_brush() ? choices.brush : 1), view);
  if (choices.sprite_tool == SpriteTool::select && selected && selected->contains(pixel))
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
}

}  // namespace talus
