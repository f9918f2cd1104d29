// Changes points of polygons with the mouse.
#include "polygon_hand.h"

#include <cmath>
#include <string>

#include <talus/collision/shape_forms.h>
#include "canvas_note.h"
#include "debug/number_text.h"
#include "panels/canvas/drag_cancel.h"

namespace talus {
namespace {

constexpr float kPointReach = 9, kSideReach = 6;  // px at scale 1, from a point or a side to the mouse
constexpr float kLeastDrag = 3;                   // px at scale 1; less is a click
constexpr float kPointSize = 4;                   // px at scale 1, half of a handle's side

double in_tile(float pixels, const CanvasView& view, const Ui& ui) { return ui.px(pixels) / view.zoom; }

Vec2 mouse_place(const CanvasView& view) { return view.to_level(ImGui::GetIO().MousePos); }

PointSnap snap_now(const Ui& ui) { return ImGui::GetIO().KeyAlt ? PointSnap::free : ui.view.shape.snap; }

bool is_inside(TileShape polygon, TileSize tile, Vec2 place) {
  polygon.one_way = false;
  return is_in_ground(polygon, tile, place);
}

bool is_on_first(const std::vector<Vec2>& points, const CanvasView& view, const Ui& ui) {
  return points.size() >= 3 &&
         point_near({points.front()}, mouse_place(view), in_tile(kPointReach, view, ui)).has_value();
}

std::string place_text(Vec2 place) { return exact_text(place.x) + ", " + exact_text(place.y); }

void draw_point(ImDrawList& list, ImVec2 at, float side, std::uint32_t color) {
  list.AddRectFilled({at.x - side - 1, at.y - side - 1}, {at.x + side + 1, at.y + side + 1},
                     theme::color(theme::kDark));
  list.AddRectFilled({at.x - side, at.y - side}, {at.x + side, at.y + side}, theme::color(color));
}

}  // namespace

void PolygonHand::update(const Session& session, Actions& actions, const CanvasView& view, Ui& ui) {
  if (ImGui::IsItemActivated() && ImGui::IsMouseDown(0)) press(session, actions, view, ui);
  if (holds() && is_drag_cancelled()) cancel(session, actions, ui.view);
  if (!ImGui::IsItemActive()) grip_ = Grip::none;
  if (holds()) drag(session, actions, view, ui);
  if (!holds() && ImGui::IsItemHovered() && ImGui::IsMouseClicked(1))
    remove_under_mouse(session, actions, view, ui);
}

void PolygonHand::take_hold(Grip grip, const EditedShape& edited, std::size_t point) {
  grip_ = grip;
  moved_ = false;
  press_ = ImGui::GetIO().MousePos;
  held_ = point;
  from_ = edited;
  polygon_ = edited.shape();
}

void PolygonHand::press(const Session& session, Actions& actions, const CanvasView& view, Ui& ui) {
  const EditedShape edited = edited_shape(session, ui.view);
  if (edited.is_drawing) return press_drawing(session, actions, view, ui);
  ShapeView& shown = ui.view.shape;
  const Vec2 place = mouse_place(view);
  stroke_ = session.next_stroke();
  if (edited.is_polygon()) {
    const std::vector<Vec2>& points = edited.shape().points;
    if (const auto point = point_near(points, place, in_tile(kPointReach, view, ui))) {
      shown.point = point;
      return take_hold(Grip::point, edited, *point);
    }
    if (const auto side = side_near(points, place, in_tile(kSideReach, view, ui))) {
      take_hold(Grip::point, edited, *side + 1);
      polygon_ = with_point_on(polygon_, *side, place, snap_now(ui), edited.size);
      put_part(session, actions, ui.view, polygon_, stroke_);
      shown.point = held_;
      return;
    }
    if (is_inside(edited.shape(), edited.size, place)) {
      shown.point.reset();
      return take_hold(Grip::whole, edited, *point_near(points, place, HUGE_VAL));
    }
  }
  shown.point.reset();
  if (const auto part = part_near(edited.whole, edited.size, place, in_tile(kSideReach, view, ui)))
    shown.part = *part;
}

void PolygonHand::press_drawing(const Session& session, Actions& actions, const CanvasView& view, Ui& ui) {
  std::vector<Vec2>& points = *ui.view.shape.drawing;
  if (is_on_first(points, view, ui)) return close_drawing(session, actions, ui.view);
  const EditedShape edited = edited_shape(session, ui.view);
  const Vec2 place = kept_near(snapped(mouse_place(view), snap_now(ui), edited.size), edited.size);
  if (!points.empty() && points.back() == place) return;
  points.push_back(place);
  take_hold(Grip::drawn, edited, points.size() - 1);
}

void PolygonHand::drag(const Session& session, Actions& actions, const CanvasView& view, Ui& ui) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  moved_ = moved_ || std::hypot(mouse.x - press_.x, mouse.y - press_.y) >= ui.px(kLeastDrag);
  if (!moved_) return;
  const PointSnap snap = snap_now(ui);
  if (grip_ == Grip::drawn) {
    if (!ui.view.shape.drawing || held_ >= ui.view.shape.drawing->size()) return;
    (*ui.view.shape.drawing)[held_] = kept_near(snapped(mouse_place(view), snap, from_.size), from_.size);
    return;
  }
  const Vec2 point = polygon_.points[held_];
  const Vec2 wanted = snapped(point + (mouse_place(view) - view.to_level(press_)), snap, from_.size);
  const TileShape now = grip_ == Grip::point ? with_point_at(polygon_, held_, wanted, from_.size)
                                             : moved_by(polygon_, wanted - point, from_.size);
  const EditedShape edited = edited_shape(session, ui.view);
  const TileShape whole = with_part_at(from_.whole, from_.part, now);
  if (whole != edited.whole) put_shape(session, actions, ui.view, whole, stroke_);
}

void PolygonHand::cancel(const Session& session, Actions& actions, View& view) {
  if (grip_ == Grip::drawn) {
    if (view.shape.drawing && !view.shape.drawing->empty()) view.shape.drawing->pop_back();
  } else if (from_.is_draft) {
    put_shape(session, actions, view, from_.whole, stroke_);
  } else {
    view.shape.draft.reset();
    take_back(session, actions, stroke_);
  }
  view.shape.point = from_.point;
  grip_ = Grip::none;
}

void PolygonHand::remove_under_mouse(const Session& session, Actions& actions, const CanvasView& view,
                                     Ui& ui) const {
  const EditedShape edited = edited_shape(session, ui.view);
  if (edited.is_drawing) return drop_last_point(ui.view);
  if (!edited.is_polygon()) return;
  const double reach = in_tile(kPointReach, view, ui);
  if (const auto point = point_near(edited.shape().points, mouse_place(view), reach))
    remove_point(session, actions, ui.view, *point);
}

void PolygonHand::draw(const Session& session, const CanvasView& view, Ui& ui) const {
  const EditedShape edited = edited_shape(session, ui.view);
  if (edited.is_drawing) return draw_drawing(view, ui);
  if (edited.is_polygon()) draw_polygon(edited, view, ui);
}

void PolygonHand::draw_drawing(const CanvasView& view, Ui& ui) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::vector<Vec2>& points = *ui.view.shape.drawing;
  const bool hovered = ImGui::IsItemHovered(), closes = hovered && !holds() && is_on_first(points, view, ui);
  const Vec2 next = snapped(mouse_place(view), snap_now(ui), view.tile);
  std::vector<ImVec2> line;
  line.reserve(points.size() + 1);
  for (const Vec2 point : points) line.push_back(view.to_screen(point));
  if (hovered && !holds()) line.push_back(view.to_screen(closes ? points.front() : next));
  const int count = static_cast<int>(line.size());
  list.AddPolyline(line.data(), count, theme::color(theme::kDark, 200), ImDrawFlags_None, ui.px(2) + 2);
  list.AddPolyline(line.data(), count, theme::color(theme::kWarning), ImDrawFlags_None, ui.px(2));
  const float side = ui.px(kPointSize);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ImVec2 at = view.to_screen(points[i]);
    draw_point(list, at, i == 0 && closes ? side * 1.5f : side, i == 0 ? theme::kWarning : theme::kText);
    ui.place("shape/drawn" + std::to_string(i), {at.x - side, at.y - side}, {at.x + side, at.y + side});
  }
  if (!hovered) return;
  const Vec2 shown = holds() && held_ < points.size() ? points[held_] : next;
  if (!closes && !holds()) draw_point(list, view.to_screen(shown), side * 0.5f, theme::kWarning);
  draw_canvas_note(list, closes ? "close" : place_text(shown), view.to_screen(shown), 2 * side, view);
}

void PolygonHand::draw_polygon(const EditedShape& edited, const CanvasView& view, Ui& ui) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::vector<Vec2>& points = edited.shape().points;
  const bool hovered = ImGui::IsItemHovered() && !holds();
  const Vec2 mouse = mouse_place(view);
  const auto pointed = hovered ? point_near(points, mouse, in_tile(kPointReach, view, ui)) : std::nullopt;
  const float side = ui.px(kPointSize);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ImVec2 at = view.to_screen(points[i]);
    const bool is_chosen = edited.point == i;
    draw_point(list, at, pointed == i ? side * 1.25f : side, is_chosen ? theme::kWarning : theme::kText);
    ui.place("shape/point" + std::to_string(i), {at.x - side, at.y - side}, {at.x + side, at.y + side});
  }
  const auto on_side =
      hovered && !pointed ? side_near(points, mouse, in_tile(kSideReach, view, ui)) : std::nullopt;
  if (on_side) {  // where a click would insert a point
    const TileShape more = with_point_on(edited.shape(), *on_side, mouse, snap_now(ui), edited.size);
    const Vec2 place = more.points[*on_side + 1];
    list.AddCircleFilled(view.to_screen(place), side, theme::color(theme::kDark, 200));
    list.AddCircle(view.to_screen(place), side, theme::color(theme::kWarning), 0, ui.px(1));
    draw_canvas_note(list, "new " + place_text(place), view.to_screen(place), 2 * side, view);
  }
  const auto noted = pointed ? pointed : holds() || !hovered ? edited.point : std::nullopt;
  if (noted)
    draw_canvas_note(list, place_text(points[*noted]), view.to_screen(points[*noted]), 2 * side, view);
}

}  // namespace talus
