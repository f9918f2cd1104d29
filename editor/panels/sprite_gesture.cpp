// The tools of the pixel canvas at the mouse.
#include "sprite_gesture.h"

#include <cmath>

#include "dialog.h"

namespace talus {
namespace {

bool draws_shape(SpriteTool tool) {
  return tool == SpriteTool::line || tool == SpriteTool::rectangle || tool == SpriteTool::ellipse;
}

bool uses_brush(SpriteTool tool) { return tool == SpriteTool::pencil || draws_shape(tool); }

// Light dashes on a dark line, so that they show on any art.
void draw_dashes(ImDrawList& list, ImVec2 from, ImVec2 to, float scale) {
  const float dash = std::round(4 * scale), width = std::max(1.0f, std::round(scale));
  const float length = std::max(to.x - from.x, to.y - from.y);
  const bool across = to.x - from.x > to.y - from.y;
  list.AddRectFilled(from, {across ? to.x : from.x + width, across ? from.y + width : to.y},
                     theme::color(theme::kDark));
  for (float at = 0; at < length; at += 2 * dash) {
    const float end = std::min(at + dash, length);
    const ImVec2 a{across ? from.x + at : from.x, across ? from.y : from.y + at};
    const ImVec2 b{across ? from.x + end : from.x + width, across ? from.y + width : from.y + end};
    list.AddRectFilled(a, b, theme::color(theme::kText));
  }
}

void draw_selection(ImDrawList& list, CellRect rect, const CanvasView& view, float scale) {
  const double right = rect.x + rect.w, bottom = rect.y + rect.h;
  const ImVec2 from = view.to_screen({static_cast<double>(rect.x), static_cast<double>(rect.y)});
  const ImVec2 to = view.to_screen({right, bottom});
  draw_dashes(list, from, {to.x, from.y}, scale);
  draw_dashes(list, {from.x, to.y}, to, scale);
  draw_dashes(list, from, {from.x, to.y}, scale);
  draw_dashes(list, {to.x, from.y}, to, scale);
}

// The pixels as an edit leaves them.
void draw_pixels_of(ImDrawList& list, const Edit& edit, const Level& level, const SpriteArea& area,
                    const CanvasView& view) {
  for (const Change& change : edit.changes) {
    const auto* pixel = std::get_if<PixelChange>(&change);
    if (pixel == nullptr) continue;
    const int x = (pixel->tile % kSheetColumns - area.tiles.x) * kTileSize + pixel->pixel % kTileSize;
    const int y = (pixel->tile / kSheetColumns - area.tiles.y) * kTileSize + pixel->pixel / kTileSize;
    list.AddRectFilled(view.to_screen({x + 0.0, y + 0.0}), view.to_screen({x + 1.0, y + 1.0}),
                       theme::color(level.palette[pixel->after]));
  }
}

void draw_brush(ImDrawList& list, CellRect brush, const CanvasView& view) {
  const ImVec2 from = view.to_screen({brush.x + 0.0, brush.y + 0.0});
  const ImVec2 to = view.to_screen({brush.x + brush.w + 0.0, brush.y + brush.h + 0.0});
  list.AddRect({from.x - 1, from.y - 1}, {to.x + 1, to.y + 1}, theme::color(theme::kDark));
  list.AddRect(from, to, theme::color(theme::kText));
}

}  // namespace

void SpriteGesture::update(const Session& session, Actions& actions, Cell pixel, bool hovered) {
  if (active() && (key_pressed(ImGuiKey_Escape) || tool_ != session.choices().sprite_tool)) from_.reset();
  if (hovered && ImGui::IsMouseClicked(2))
    actions.push_back(
        action::SetColor{pixel_at(session.level(), session.choices().area, pixel.x, pixel.y), false});
  const bool right = ImGui::IsMouseClicked(1);
  if (!active()) {
    if (hovered && (right || ImGui::IsMouseClicked(0))) press(session, actions, pixel, right);
  } else if (!ImGui::GetIO().MouseDown[right_ ? 1 : 0]) {
    release(session, actions, pixel);
    from_.reset();
  } else if (pixel != last_) {
    drag(session, actions, pixel);
    last_ = pixel;
  }
}

void SpriteGesture::press(const Session& session, Actions& actions, Cell pixel, bool right) {
  const Level& level = session.level();
  const Choices& choices = session.choices();
  from_ = last_ = pixel;
  right_ = right;
  tool_ = choices.sprite_tool;
  stroke_ = session.next_stroke();
  switch (tool_) {
    case SpriteTool::pencil:
      actions.push_back(action::EditLevel{line_to(session, pixel), stroke_});
      break;
    case SpriteTool::pick:
      actions.push_back(action::SetColor{pixel_at(level, choices.area, pixel.x, pixel.y), right});
      break;
    case SpriteTool::fill:
      actions.push_back(action::EditLevel{ImGui::GetIO().KeyCtrl
                                              ? replace_color(level, choices.area,
                                                              pixel_at(level, choices.area, pixel.x, pixel.y),
                                                              color(choices))
                                              : fill_pixels(level, choices.area, pixel, color(choices))});
      break;
    case SpriteTool::select: {
      const auto& selected = choices.pixels.rect();
      moves_ = selected && selected->contains(pixel);
      deselects_ = selected && !moves_;
      break;
    }
    default:
      break;
  }
}

void SpriteGesture::drag(const Session& session, Actions& actions, Cell pixel) {
  if (tool_ == SpriteTool::pencil) {
    actions.push_back(action::EditLevel{line_to(session, pixel), stroke_});
  } else if (tool_ == SpriteTool::select) {
    deselects_ = false;
    if (moves_)
      actions.push_back(action::MovePixels{{pixel.x - last_.x, pixel.y - last_.y}});
    else
      actions.push_back(action::SelectPixels{spanned(*from_, pixel)});
  }
}

void SpriteGesture::release(const Session& session, Actions& actions, Cell pixel) {
  if (draws_shape(tool_)) {
    actions.push_back(action::EditLevel{shape_to(session, pixel)});
  } else if (tool_ == SpriteTool::select && !moves_ && pixel == *from_) {
    // A click chooses one pixel, or, beside a selection, none.
    actions.push_back(action::SelectPixels{deselects_ ? std::optional<CellRect>()
                                                      : std::optional<CellRect>({pixel.x, pixel.y, 1, 1})});
  }
}

std::uint8_t SpriteGesture::color(const Choices& choices) const {
  return static_cast<std::uint8_t>(right_ ? choices.secondary_color : choices.color);
}

Edit SpriteGesture::line_to(const Session& session, Cell pixel) const {
  const Choices& choices = session.choices();
  return draw_line(session.level(), choices.area, last_, pixel, {color(choices), choices.brush});
}

Edit SpriteGesture::shape_to(const Session& session, Cell pixel) const {
  const Choices& choices = session.choices();
  const ImGuiIO& io = ImGui::GetIO();
  const PixelPen pen{color(choices), choices.brush};
  if (tool_ == SpriteTool::line) {
    const Cell to = io.KeyShift ? straightened(*from_, pixel) : pixel;
    Edit edit = draw_line(session.level(), choices.area, *from_, to, pen);
    edit.label = "Draw a line";
    return edit;
  }
  const Cell to = io.KeyShift ? squared(*from_, pixel) : pixel;
  return tool_ == SpriteTool::rectangle
             ? draw_rectangle(session.level(), choices.area, *from_, to, pen, io.KeyCtrl)
             : draw_ellipse(session.level(), choices.area, *from_, to, pen, io.KeyCtrl);
}

void SpriteGesture::draw(ImDrawList& list, const Session& session, const CanvasView& view, Cell pixel,
                         bool hovered, float scale) const {
  const Choices& choices = session.choices();
  if (active() && draws_shape(tool_))
    draw_pixels_of(list, shape_to(session, pixel), session.level(), choices.area, view);
  const auto& selected = choices.pixels.rect();
  if (selected) draw_selection(list, *selected, view, scale);
  if (!hovered) return;
  draw_brush(list, brush_at(pixel, uses_brush(choices.sprite_tool) ? choices.brush : 1), view);
  if (choices.sprite_tool == SpriteTool::select && selected && selected->contains(pixel))
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
}

}  // namespace talus
