// The object tool: draws an object, or chooses one and moves it, or drags one of its handles.
#include <cmath>
#include <string>
#include <utility>

#include "edit/object_handles.h"
#include "edit/snap.h"
#include "level_tools.h"
#include "panels/canvas/curve_drawing.h"
#include "panels/inspector/chosen_object.h"
#include "panels/ui/dialog.h"
#include "panels/ui/shown_text.h"

namespace talus {
namespace {

constexpr double kObjectReach = 6;  // px of the screen, to an outline or a handle
constexpr double kShake = 3;        // px of the screen: a shorter movement is not a drag

Vec2 snapped_place(const LevelToolUse& use, Vec2 at) {
  const ImGuiIO& io = ImGui::GetIO();
  return snap(use.session.level(), at, {.zoom = use.view.zoom, .off = io.KeyAlt, .halves = io.KeyCtrl}).point;
}

int nearest_place(const std::vector<Vec2>& places, Vec2 at, double reach) {
  int found = -1;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double distance = std::hypot(places[i].x - at.x, places[i].y - at.y);
    if (distance > reach) continue;
    found = static_cast<int>(i);
    reach = distance;
  }
  return found;
}

void draw_outline(ImDrawList& list, const MapObject& object, Vec2 offset, const CanvasView& view, ImU32 color,
                  float width) {
  std::vector<Vec2> points = line_of(object);
  const bool is_open = !points.empty();
  if (!is_open) points = outline_of(object);
  if (object.form == MapObject::Form::tile) points = frame_of(object);
  std::vector<ImVec2> shown;
  shown.reserve(points.size());
  for (const Vec2 point : points) shown.push_back(view.to_screen(point + offset));
  if (shown.size() > 1)
    list.AddPolyline(shown.data(), static_cast<int>(shown.size()), color,
                     is_open ? ImDrawFlags_None : ImDrawFlags_Closed, width);
  if (!shown.empty()) return;
  const ImVec2 at = view.to_screen(object.position + offset);
  list.AddCircle(at, 3 * width, color, 0, width);
}

class ObjectTool : public LevelTool {
 public:
  bool press(const LevelToolUse& use, Actions& actions) override;
  void drag(const LevelToolUse& use, Actions& actions) override;
  void release(const LevelToolUse& use, Actions& actions) override;
  void cancel(const LevelToolUse& use, Actions& actions) override {
    LevelTool::cancel(use, actions);
    drag_ = Drag::none;
  }
  // Enter closes the polygon that is being drawn, Backspace takes its last corner, and Escape all of it.
  void rest(const LevelToolUse& use, Actions& actions) override;
  void leave() override { corners_.clear(); }
  // Draws the chosen object with its handles, which are registered as "map/object_handle0" and so on, and its
  // name, at "map/chosen_object"; and what a press would grab or begin.
  void draw(ImDrawList& list, const LevelToolUse& use) const override;
  std::string hint(const LevelToolUse& use) const override;

 private:
  enum class Drag { none, fresh, whole, handle };
  // What a press would grab.
  struct Grip {
    ObjectRef object;
    int handle = -1;  // -1: the whole object
    int side = -1;    // of which a new point is pulled out; -1: none
  };

  Grip grip_at(const LevelToolUse& use) const;
  bool press_corner(const LevelToolUse& use, Actions& actions);
  MapObject fresh_object(const LevelToolUse& use) const;
  MapObject changed(const LevelToolUse& use) const;
  void add(const LevelToolUse& use, Actions& actions, MapObject object) const;
  void close_polygon(const LevelToolUse& use, Actions& actions);
  void draw_chosen(ImDrawList& list, const LevelToolUse& use) const;
  void draw_corners(ImDrawList& list, const LevelToolUse& use) const;

  Drag drag_ = Drag::none;
  Grip held_;
  Vec2 from_;                  // px, where the button went down; snapped for a new object
  bool moved_ = false;         // further than a shaking hand
  MapObject before_;           // the held object before the drag
  std::vector<Vec2> corners_;  // of the polygon that is being drawn
};

ObjectTool::Grip ObjectTool::grip_at(const LevelToolUse& use) const {
  if (ImGui::GetIO().KeyShift) return {};
  const double reach = kObjectReach / use.view.zoom;
  const ObjectRef chosen = use.session.choices().object;
  const MapObject* const object = chosen_object(use.session);
  if (object != nullptr && !problem_of_layer(use.session.level(), chosen.layer)) {
    const Vec2 at = use.at - offset_of_layer(use.session.level(), chosen.layer);
    if (const int handle = nearest_place(handles_of(*object), at, reach); handle >= 0)
      return {chosen, handle, -1};
    if (const int side = nearest_place(middles_of(*object), at, reach); side >= 0) return {chosen, -1, side};
  }
  return {object_at(use.session.level(), use.at, reach), -1, -1};
}

bool ObjectTool::press(const LevelToolUse& use, Actions& actions) {
  moved_ = false;
  if (!corners_.empty()) return press_corner(use, actions);
  held_ = grip_at(use);
  if (held_.object.index >= 0) {
    drag_ = held_.handle >= 0 || held_.side >= 0 ? Drag::handle : Drag::whole;
    from_ = use.at;
    before_ = *find_object(use.session.level(), held_.object);
    if (held_.side >= 0) {
      before_ = with_point_after(before_, held_.side,
                                 use.at - offset_of_layer(use.session.level(), held_.object.layer));
      held_.handle = held_.side + 1;
    }
    actions.push_back(action::SelectObject{held_.object});
    return true;
  }
  if (const auto problem = problem_of_layer(use.session.level(), use.session.choices().object.layer)) {
    actions.push_back(action::ShowMessage{*problem, true});
    return false;
  }
  if (use.session.choices().object_kind == ObjectKind::polygon) return press_corner(use, actions);
  drag_ = Drag::fresh;
  from_ = snapped_place(use, use.at);
  return true;
}

// A press on the first corner closes the polygon.
bool ObjectTool::press_corner(const LevelToolUse& use, Actions& actions) {
  const double reach = kObjectReach / use.view.zoom;
  const bool closes = corners_.size() >= 3 && nearest_place({corners_.front()}, use.at, reach) == 0;
  const Vec2 corner = snapped_place(use, use.at);
  if (closes)
    close_polygon(use, actions);
  else if (corners_.empty() || corner != corners_.back())
    corners_.push_back(corner);
  return false;
}

void ObjectTool::close_polygon(const LevelToolUse& use, Actions& actions) {
  if (corners_.size() < 3) return;
  add(use, actions, polygon_through(std::exchange(corners_, {})));
}

void ObjectTool::rest(const LevelToolUse& use, Actions& actions) {
  if (corners_.empty()) return;
  if (use.session.choices().object_kind != ObjectKind::polygon || key_pressed(ImGuiKey_Escape))
    corners_.clear();
  else if (key_pressed(ImGuiKey_Backspace))
    corners_.pop_back();
  else if (key_pressed(ImGuiKey_Enter))
    close_polygon(use, actions);
}

void ObjectTool::drag(const LevelToolUse& use, Actions& actions) {
  const bool edits = drag_ == Drag::whole || drag_ == Drag::handle;
  const MapObject* const now = find_object(use.session.level(), held_.object);
  if (edits && now == nullptr) drag_ = Drag::none;  // Undo has removed it
  moved_ = moved_ || std::hypot(use.at.x - from_.x, use.at.y - from_.y) * use.view.zoom > kShake;
  if (!edits || now == nullptr || !moved_) return;
  MapObject object = changed(use);
  if (object == *now || problem_of_object(object)) return;
  const std::string_view what = drag_ == Drag::whole ? "Move an object" : "Change an object's form";
  actions.push_back(action::EditLevel{
      change_object(use.session.level(), held_.object, std::move(object), std::string(what)), use.stroke});
}

// The held object with the handle, or all of it, at the mouse.
MapObject ObjectTool::changed(const LevelToolUse& use) const {
  const Vec2 offset = offset_of_layer(use.session.level(), held_.object.layer);
  if (drag_ == Drag::handle) return with_handle(before_, held_.handle, snapped_place(use, use.at) - offset);
  const Vec2 to = snapped_place(use, before_.position + offset + use.at - from_) - offset;
  return moved_object(before_, to - before_.position);
}

MapObject ObjectTool::fresh_object(const LevelToolUse& use) const {
  const ObjectKind kind = use.session.choices().object_kind;
  const Vec2 to = snapped_place(use, use.at);
  if (kind == ObjectKind::point) return object_between(MapObject::Form::box, to, to);
  return object_between(kind == ObjectKind::ellipse ? MapObject::Form::ellipse : MapObject::Form::box, from_,
                        to);
}

void ObjectTool::add(const LevelToolUse& use, Actions& actions, MapObject object) const {
  if (const auto problem = problem_of_object(object)) {
    actions.push_back(action::ShowMessage{"No object: it " + *problem + ".", true});
    return;
  }
  const std::vector<ObjectLayer>& layers = use.session.level().objects;
  int into = use.session.choices().object.layer;
  if (into < 0 || into >= static_cast<int>(layers.size())) {
    into = static_cast<int>(layers.size()) - 1;
    while (into >= 0 && layers[static_cast<std::size_t>(into)].image) --into;
  }
  object.position = object.position - offset_of_layer(use.session.level(), into);
  if (const auto problem = problem_of_layer(use.session.level(), into)) {
    actions.push_back(action::ShowMessage{*problem, true});
    return;
  }
  actions.push_back(action::EditLevel{add_object(use.session.level(), into, std::move(object))});
  actions.push_back(action::SelectObject{place_of_added(use.session.level(), into)});
}

// A click beside all objects chooses none.
void ObjectTool::release(const LevelToolUse& use, Actions& actions) {
  if (std::exchange(drag_, Drag::none) != Drag::fresh) return;
  MapObject object = fresh_object(use);
  const bool is_point = use.session.choices().object_kind == ObjectKind::point;
  if (is_point || (moved_ && object.size.x > 0 && object.size.y > 0))
    return add(use, actions, std::move(object));
  actions.push_back(action::SelectObject{{use.session.choices().object.layer, -1}});
}

void ObjectTool::draw(ImDrawList& list, const LevelToolUse& use) const {
  const CurvePen pen(list, use.view, use.ui.px(2));
  const Grip grip = use.hovered && drag_ == Drag::none && corners_.empty() ? grip_at(use) : Grip{};
  if (grip.object.index >= 0 && grip.object != use.session.choices().object)
    draw_outline(list, *find_object(use.session.level(), grip.object),
                 offset_of_layer(use.session.level(), grip.object.layer), use.view,
                 theme::color(theme::kWarning), use.ui.px(2));
  draw_chosen(list, use);
  if (!corners_.empty()) return draw_corners(list, use);
  if (drag_ == Drag::fresh)
    draw_outline(list, fresh_object(use), {}, use.view, theme::color(theme::kAccent), use.ui.px(2));
  const bool begins = use.hovered && grip.object.index < 0 && drag_ == Drag::none;
  if (begins)
    pen.snapped({snapped_place(use, use.at), SnappedPoint::To::pixel}, use.ui,
                label_of(use.session.choices().object_kind));
}

void ObjectTool::draw_chosen(ImDrawList& list, const LevelToolUse& use) const {
  const MapObject* const object = chosen_object(use.session);
  if (object == nullptr) return;
  const ImU32 color = theme::color(theme::kAccent), dark = theme::color(theme::kDark);
  const Vec2 offset = offset_of_layer(use.session.level(), use.session.choices().object.layer);
  draw_outline(list, *object, offset, use.view, color, use.ui.px(2));
  const float half = use.ui.px(4);
  int number = 0;
  for (const Vec2 handle : handles_of(*object)) {
    const ImVec2 at = use.view.to_screen(handle + offset), least{at.x - half, at.y - half},
                 most{at.x + half, at.y + half};
    list.AddRectFilled({least.x - 1, least.y - 1}, {most.x + 1, most.y + 1}, dark);
    list.AddRectFilled(least, most, color);
    use.ui.place("map/object_handle" + std::to_string(number++), least, most);
  }
  number = 0;
  for (const Vec2 middle : middles_of(*object)) {
    const ImVec2 at = use.view.to_screen(middle + offset);
    list.AddCircleFilled(at, half - 1, dark);
    list.AddCircle(at, half - 1, color, 0, use.ui.px(1));
    use.ui.place("map/object_side" + std::to_string(number++), at, at);
  }
  constexpr std::size_t kMaxTitle = 60;  // bytes
  const ImVec2 beside = use.view.to_screen(object->position + offset);
  const CurvePen pen(list, use.view, use.ui.px(2));
  pen.title(shown_line(object_title(use.session.level(), use.session.choices().object), kMaxTitle), beside,
            theme::kAccent);
  use.ui.place("map/chosen_object", beside, beside);
}

void ObjectTool::draw_corners(ImDrawList& list, const LevelToolUse& use) const {
  const CurvePen pen(list, use.view, use.ui.px(2));
  const ImU32 color = theme::color(theme::kAccent);
  for (std::size_t i = 0; i + 1 < corners_.size(); ++i) pen.line(corners_[i], corners_[i + 1], color);
  if (use.hovered) pen.line(corners_.back(), snapped_place(use, use.at), color);
  const ImVec2 first = use.view.to_screen(corners_.front());
  list.AddCircleFilled(first, use.ui.px(5), color);
  use.ui.place("map/first_corner", first, first);
}

std::string ObjectTool::hint(const LevelToolUse& use) const {
  if (!corners_.empty())
    return "a click adds a corner; the first corner or Enter closes it, Backspace takes one back";
  if (chosen_object(use.session) == nullptr) return {};
  return "drag to move, a handle to resize; with Shift a drag draws";
}

}  // namespace

std::unique_ptr<LevelTool> make_object_tool() { return std::make_unique<ObjectTool>(); }

}  // namespace talus
