// Dashes around pixels.
#include "pixel_selection_drawing.h"

#include <algorithm>
#include <cmath>

#include "panels/ui/theme.h"

namespace talus {
namespace {

// Light dashes on a dark line, so that they show on any art.
void draw_dashed_side(ImDrawList& list, ImVec2 from, ImVec2 to, float scale) {
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

}  // namespace

void draw_pixel_selection(ImDrawList& list, CellRect rect, const CanvasView& view, float scale) {
  const double right = rect.x + rect.w, bottom = rect.y + rect.h;
  const ImVec2 from = view.to_screen({static_cast<double>(rect.x), static_cast<double>(rect.y)});
  const ImVec2 to = view.to_screen({right, bottom});
  draw_dashed_side(list, from, {to.x, from.y}, scale);
  draw_dashed_side(list, {from.x, to.y}, to, scale);
  draw_dashed_side(list, from, {from.x, to.y}, scale);
  draw_dashed_side(list, {to.x, from.y}, to, scale);
}

}  // namespace talus
