// Draws the map in the corner.
#include "minimap.h"

#include <algorithm>
#include <cmath>

#include "tile_drawing.h"

namespace talus {
namespace {

constexpr float kShare = 0.3f;    // largest share of the canvas's width and height
constexpr float kMax = 220;       // px at scale 1, longest side
constexpr float kLeastSide = 4;   // px at scale 1, shortest side of a long and low map
constexpr float kLeastFrame = 3;  // px at scale 1, smallest side of the frame

// Place of the minimap, and its zoom.
CanvasView place_of(const TileMap& map, const CanvasView& view, const Ui& ui) {
  const float width = static_cast<float>(map.px_width()), height = static_cast<float>(map.px_height());
  const float room_x = std::min((view.max.x - view.min.x) * kShare, ui.px(kMax));
  const float room_y = std::min((view.max.y - view.min.y) * kShare, ui.px(kMax));
  const float zoom = std::min(room_x / width, room_y / height);
  const ImVec2 size{std::max(ui.px(kLeastSide), std::floor(width * zoom)),
                    std::max(ui.px(kLeastSide), std::floor(height * zoom))};
  const float gap = ui.px(6);
  const ImVec2 max{view.max.x - gap, view.max.y - gap}, min{max.x - size.x, max.y - size.y};
  return {min, max, {min.x, min.y}, zoom, map.tile_size()};
}

bool is_inside(ImVec2 p, const CanvasView& place) {
  return p.x >= place.min.x && p.y >= place.min.y && p.x < place.max.x && p.y < place.max.y;
}

// The frame around what the canvas shows, clamped to the minimap and large enough to be seen.
void draw_shown(ImDrawList& list, const CanvasView& place, const CanvasView& view, const Ui& ui) {
  const Rect shown = view.visible();
  ImVec2 from = place.to_screen({shown.x, shown.y}), to = place.to_screen({shown.right(), shown.bottom()});
  const float least = ui.px(kLeastFrame);
  const auto widen = [least](float& a, float& b, float low, float high) {
    const float lack = std::max(0.0f, least - (b - a)) / 2;
    a = std::clamp(a - lack, low, std::max(low, high - least));
    b = std::clamp(b + lack, std::min(high, low + least), high);
  };
  widen(from.x, to.x, place.min.x, place.max.x);
  widen(from.y, to.y, place.min.y, place.max.y);
  list.AddRect({from.x - 1, from.y - 1}, {to.x + 1, to.y + 1}, theme::color(theme::kDark), 0, 0,
               ui.px(1) + 2);
  list.AddRect(from, to, theme::color(theme::kText), 0, 0, ui.px(1));
}

}  // namespace

bool Minimap::update(const TileMap& map, const CanvasView& view, const Ui& ui, bool hovered,
                     std::optional<Vec2>& centre) {
  const ImGuiIO& io = ImGui::GetIO();
  const CanvasView place = place_of(map, view, ui);
  const bool over = hovered && is_inside(io.MousePos, place);
  if (over && ImGui::IsMouseClicked(0)) dragging_ = true;
  if (!io.MouseDown[0]) dragging_ = false;
  if (dragging_) {
    const Vec2 at = place.to_level(io.MousePos);
    centre = Vec2{std::clamp(at.x, 0.0, map.px_width()), std::clamp(at.y, 0.0, map.px_height())};
  }
  return over || dragging_;
}

void Minimap::draw(ImDrawList& list, const Level& level, const CanvasView& view, Ui& ui,
                   std::string_view name) const {
  const CanvasView place = place_of(level.map, view, ui);
  list.AddRectFilled({place.min.x - 2, place.min.y - 2}, {place.max.x + 2, place.max.y + 2},
                     theme::color(theme::kDark, 230));
  // Layers may lie beyond the map.
  list.PushClipRect({place.min.x - 1, place.min.y - 1}, {place.max.x + 1, place.max.y + 1}, true);
  draw_far_tiles(list, level, place, ui, {});
  list.PopClipRect();
  draw_shown(list, place, view, ui);
  list.AddRect({place.min.x - 2, place.min.y - 2}, {place.max.x + 2, place.max.y + 2},
               theme::color(theme::kMuted));
  ui.place(name, place.min, place.max);
}

}  // namespace talus
