#include "object_drawing.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <talus/level/placed_picture.h>
#include "panels/ui/shown_text.h"

namespace talus {
namespace {

struct DrawnObject {
  std::vector<Vec2> points;  // px of the map
  bool is_closed = false;
};

// Points and texts are small crosses at their places, and so are tiles without a picture. Others have a
// frame.
DrawnObject drawn(const MapObject& object) {
  if (object.picture.picture != nullptr) {
    const PlacedPicture shown = placed(object);
    return {{shown.corner, shown.corner + shown.right, shown.corner + shown.right + shown.down,
             shown.corner + shown.down},
            true};
  }
  DrawnObject line{line_of(object), false};
  if (line.points.empty()) line = {outline_of(object), true};
  return line;
}

Rect bounds_of(const std::vector<Vec2>& points) {
  Vec2 least = points.front(), most = least;
  for (const Vec2 p : points) {
    least = {std::min(least.x, p.x), std::min(least.y, p.y)};
    most = {std::max(most.x, p.x), std::max(most.y, p.y)};
  }
  return {least.x, least.y, most.x - least.x, most.y - least.y};
}

// A box around the object, however it is turned: quick to find, and not the least.
Rect around(const MapObject& object) {
  double reach = object.size.x + object.size.y;
  for (const Vec2 p : object.points) reach = std::max(reach, std::abs(p.x) + std::abs(p.y));
  return {object.position.x - reach, object.position.y - reach, 2 * reach, 2 * reach};
}

bool meets(const Rect& a, const Rect& b) {
  return a.x <= b.right() && b.x <= a.right() && a.y <= b.bottom() && b.y <= a.bottom();
}

void draw_cross(ImDrawList& list, ImVec2 at, float side, ImU32 color) {
  list.AddLine({at.x - side, at.y}, {at.x + side, at.y}, color);
  list.AddLine({at.x, at.y - side}, {at.x, at.y + side}, color);
}

void draw_object_name(ImDrawList& list, const MapObject& object, ImVec2 mouse, const Ui& ui) {
  constexpr std::size_t kMaxShown = 60;  // bytes
  const std::string text = shown_line(object.name.empty() ? object.type : object.name, kMaxShown);
  if (text.empty()) return;
  const ImVec2 at{mouse.x + ui.px(12), mouse.y + ui.px(12)}, size = size_of_text(text);
  const float inset = ui.px(3);
  list.AddRectFilled({at.x - inset, at.y - inset}, {at.x + size.x + inset, at.y + size.y + inset},
                     theme::color(theme::kDark, theme::kPlateAlpha));
  add_text(list, at, theme::color(theme::kText), text);
}

}  // namespace

void draw_objects(ImDrawList& list, const Level& level, const CanvasView& view, const Ui& ui, ImVec2 mouse) {
  const float width = std::max(1.0f, std::round(ui.scale * 1.5f));
  const MapObject* named = nullptr;
  for (const ObjectLayer& layer : level.objects) {
    const LayerLooks looks = shown_looks(level.layers.groups, layer);
    if (!looks.visible) continue;
    CanvasView there = view;
    there.origin = view.origin + looks.offset * view.zoom;
    const Rect visible = there.visible();
    const Vec2 pointed = there.to_level(mouse);
    const ImU32 color = theme::color(layer.is_ground ? theme::kAccent : theme::kMuted);
    for (const MapObject& object : layer.objects) {
      if (!object.visible || !meets(around(object), visible)) continue;
      const DrawnObject shape = drawn(object);
      const Rect bounds =
          shape.points.empty() ? Rect{object.position.x, object.position.y, 0, 0} : bounds_of(shape.points);
      if (!meets(bounds, visible)) continue;
      if (meets(bounds, {pointed.x, pointed.y, 0, 0})) named = &object;
      if (shape.points.empty()) {
        draw_cross(list, there.to_screen(object.position), ui.px(4), color);
        continue;
      }
      std::vector<ImVec2> points;
      for (const Vec2 p : shape.points) points.push_back(there.to_screen(p));
      list.AddPolyline(points.data(), static_cast<int>(points.size()), color,
                       shape.is_closed ? ImDrawFlags_Closed : ImDrawFlags_None, width);
    }
  }
  if (named != nullptr) draw_object_name(list, *named, mouse, ui);
}

}  // namespace talus
