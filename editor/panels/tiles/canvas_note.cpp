// Places a text on a canvas.
#include "canvas_note.h"

#include <algorithm>

namespace talus {

void draw_canvas_note(ImDrawList& list, std::string_view text, ImVec2 point, float away,
                      const CanvasView& view) {
  const ImVec2 size = size_of_text(text);
  const float above = point.y - size.y - away;
  const ImVec2 at{std::clamp(point.x - size.x / 2, view.min.x, std::max(view.min.x, view.max.x - size.x)),
                  above < view.min.y ? point.y + away : above};
  list.AddRectFilled({at.x - 2, at.y}, {at.x + size.x + 2, at.y + size.y}, theme::color(theme::kDark, 205));
  add_text(list, at, theme::color(theme::kText), text);
}

}  // namespace talus
