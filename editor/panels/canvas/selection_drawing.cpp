// Dashes around cells.
#include "selection_drawing.h"

#include <algorithm>

namespace talus {
namespace {

// A line of dashes, vertical or level.
void draw_dashes(ImDrawList& list, ImVec2 from, ImVec2 to, float dash, float width) {
  const bool level = from.y == to.y;
  const float end = level ? to.x : to.y;
  bool bright = true;
  for (float at = level ? from.x : from.y; at < end; at += dash, bright = !bright) {
    const float next = std::min(at + dash, end);
    const ImU32 color = bright ? theme::color(theme::kText) : theme::color(theme::kDark);
    if (level)
      list.AddRectFilled({at, from.y}, {next, from.y + width}, color);
    else
      list.AddRectFilled({from.x, at}, {from.x + width, next}, color);
  }
}

}  // namespace

void draw_selection(ImDrawList& list, const CellRect& cells, const CanvasView& view, const Ui& ui) {
  const ImVec2 from = view.corner_of({cells.x, cells.y});
  const ImVec2 to = view.corner_of({cells.x + cells.w, cells.y + cells.h});
  const float width = std::max(1.0f, ui.px(1)), dash = ui.px(4);
  // No more dashes than can be seen.
  const float left = std::max(from.x, view.min.x - dash), right = std::min(to.x, view.max.x + dash);
  const float top = std::max(from.y, view.min.y - dash), bottom = std::min(to.y, view.max.y + dash);
  draw_dashes(list, {left, from.y - width}, {right, from.y - width}, dash, width);
  draw_dashes(list, {left, to.y}, {right, to.y}, dash, width);
  draw_dashes(list, {from.x - width, top}, {from.x - width, bottom}, dash, width);
  draw_dashes(list, {to.x, top}, {to.x, bottom}, dash, width);
}

}  // namespace talus
