// Draws squares in two tones.
#include "checkered.h"

#include <algorithm>
#include <cmath>

#include "panels/ui/theme.h"

namespace talus {

void draw_checkered(ImDrawList& list, ImVec2 from, ImVec2 to, float side) {
  list.AddRectFilled(from, to, theme::color(theme::kCheckered));
  const ImVec2 seen_from = list.GetClipRectMin(), seen_to = list.GetClipRectMax();
  const auto first = [&](float start, float seen) {
    return std::max(0, static_cast<int>(std::floor((seen - start) / side)));
  };
  const float right = std::min(to.x, seen_to.x), bottom = std::min(to.y, seen_to.y);
  for (int row = first(from.y, seen_from.y); from.y + static_cast<float>(row) * side < bottom; ++row) {
    const float top = from.y + static_cast<float>(row) * side;
    const int column = first(from.x, seen_from.x);
    for (int i = column + (column + row) % 2; from.x + static_cast<float>(i) * side < right; i += 2) {
      const float left = from.x + static_cast<float>(i) * side;
      list.AddRectFilled({left, top}, {std::min(left + side, to.x), std::min(top + side, to.y)},
                         theme::color(theme::kCheckeredLight));
    }
  }
}

void draw_color(ImDrawList& list, Rgba color, ImVec2 from, ImVec2 to, float side) {
  if (color.a != 255) draw_checkered(list, from, to, side);
  list.AddRectFilled(from, to, IM_COL32(color.r, color.g, color.b, color.a));
}

}  // namespace talus
