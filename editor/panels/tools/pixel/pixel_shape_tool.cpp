// Draws shapes of pixels.
#include "pixel_shape_tool.h"

#include "panels/ui/theme.h"

namespace talus {

void PixelShapeTool::release(const PixelToolUse& use, Actions& actions) {
  actions.push_back(action::EditLevel{shape(use)});
}

// The pixels after the edit.
void PixelShapeTool::draw(ImDrawList& list, const PixelToolUse& use, const CanvasView& view) const {
  const SpriteArea& area = use.session.choices().area;
  for (const Change& change : shape(use).changes) {
    const auto* pixel = std::get_if<PixelChange>(&change);
    if (pixel == nullptr) continue;
    const Cell place = use.session.level().sheet(area.sheet).layout().place_of(pixel->tile);
    const int x = (place.x - area.tiles.x) * kCartTileSize + pixel->pixel % kCartTileSize;
    const int y = (place.y - area.tiles.y) * kCartTileSize + pixel->pixel / kCartTileSize;
    list.AddRectFilled(view.to_screen({x + 0.0, y + 0.0}), view.to_screen({x + 1.0, y + 1.0}),
                       theme::color(use.session.level().palette[pixel->after]));
  }
}

}  // namespace talus
