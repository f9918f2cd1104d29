// Laying slopes.
#include "line_gesture.h"

#include <cmath>

#include "curve_drawing.h"
#include "edit/shape_tools.h"

namespace talus {
namespace {

Vec2 on_whole_px(Vec2 p) { return {std::round(p.x), std::round(p.y)}; }

}  // namespace

void LineGesture::update(const Session& session, Actions& actions, Vec2 at, bool pressed, bool down) {
  if (pressed) from_ = on_whole_px(at);
  if (!from_ || down) return;
  finish(session, actions, on_whole_px(at));
  from_.reset();
}

void LineGesture::finish(const Session& session, Actions& actions, Vec2 to) const {
  const Level& level = session.level();
  const Choices& choices = session.choices();
  auto edit = lay_slope(level, *from_, to, choices.stamp, static_cast<std::uint8_t>(choices.color));
  if (!edit) {
    actions.push_back(action::ShowMessage{
        "Slope from " + position_text(*from_) + " to " + position_text(to) + ": " + edit.error() + ".",
        true});
  } else if (!edit->empty()) {
    actions.push_back(action::EditLevel{*std::move(edit)});
  }
}

void LineGesture::draw_preview(ImDrawList& list, const CanvasView& view, const Ui& ui, Vec2 at) const {
  const ImVec2 to = view.to_screen(on_whole_px(at));
  const ImU32 dark = theme::color(theme::kDark, 200), bright = theme::color(theme::kAccent);
  const float width = ui.px(2), dot = ui.px(3);
  if (from_) {
    const ImVec2 from = view.to_screen(*from_);
    list.AddLine(from, to, dark, width + 2);
    list.AddLine(from, to, bright, width);
    list.AddCircleFilled(from, dot + 1, dark);
    list.AddCircleFilled(from, dot, bright);
  }
  list.AddCircleFilled(to, dot + 1, dark);
  list.AddCircleFilled(to, dot, bright);
}

}  // namespace talus
