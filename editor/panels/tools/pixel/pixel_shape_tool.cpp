// Draws shapes of pixels.
#include "pixel_shape_tool.h"

#include "panels/ui/theme.h"

namespace talus {

void PixelShapeTool::release(const PixelToolUse& use, Actions& actions) {
  actions.push_back(action::EditLevel{shape(use)});
}

// The pixels after the edit, those of one colour side by side as one.
void PixelShapeTool::draw(ImDrawList& list, const PixelToolUse& use, const CanvasView& view) const {
  const Level& level = use.session.level();
  const SpriteArea& area = use.session.choices().area;
  CellRect run{0, 0, 0, 1};
  PixelColor color_of_run = 0;
  const auto draw_run = [&] {
    if (run.w == 0) return;
    const ImVec2 from = view.to_screen({run.x + 0.0, run.y + 0.0});
    const ImVec2 to = view.to_screen({run.x + run.w + 0.0, run.y + 1.0});
    if (!is_in_rgba(level, area.sheet)) {
      list.AddRectFilled(from, to, theme::color(level.palette[static_cast<std::size_t>(color_of_run)]));
      return;
    }
    const Rgba c = rgba_of(color_of_run);
    list.AddRectFilled(from, to, theme::color(theme::kCheckered));
    list.AddRectFilled(from, to, IM_COL32(c.r, c.g, c.b, c.a));
  };
  for_each_painted(level, area, shape(use), [&](Cell pixel, PixelColor color) {
    const bool goes_on = run.w > 0 && pixel.y == run.y && pixel.x == run.x + run.w && color == color_of_run;
    if (!goes_on) {
      draw_run();
      run = {pixel.x, pixel.y, 0, 1};
      color_of_run = color;
    }
    ++run.w;
  });
  draw_run();
}

}  // namespace talus
