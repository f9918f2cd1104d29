// Shapes between the level and the shape editor.
#include "edited_shape.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "edit/tile_shapes.h"

namespace talus {
namespace {

constexpr std::size_t kLeastPoints = 3;  // of a polygon

const TileShape& own_shape(const Level& level, int tile) {
  return level.tile_shapes[static_cast<std::size_t>(tile)];
}

// The changes of shapes by a stroke so far, the other way round, so that nothing is left of it. Empty if it
// has no edits.
Edit taken_back(const Session& session, int stroke) {
  Edit back;
  const UndoStack& history = session.history();
  if (stroke == 0 || history.open_stroke() != stroke) return back;
  back = history.edits()[history.position() - 1];
  for (Change& change : back.changes)
    if (auto* shape = std::get_if<TileShapeChange>(&change)) std::swap(shape->before, shape->after);
  return back;
}

void say_least_points(Actions& actions) {
  actions.push_back(action::ShowMessage{"A polygon needs at least 3 points.", true});
}

}  // namespace

EditedShape edited_shape(const Session& session, const View& view) {
  const Level& level = session.level();
  const ShapeView& shown = view.shape;
  EditedShape edited;
  edited.size = level.map.tile_size();
  if (session.choices().area.sheet != SheetId::tiles) return edited;
  edited.tile = session.choices().area.tile_at(level, 0, 0);
  edited.whole = shape_of_tile(level, static_cast<TileNumber>(edited.tile));
  const bool is_same = shown.tile == edited.tile;
  edited.is_drawing = is_same && shown.drawing;
  edited.is_draft = is_same && shown.draft && shown.before == own_shape(level, edited.tile);
  if (edited.is_draft) edited.whole = *shown.draft;
  const std::size_t parts = part_count(edited.whole);
  edited.part = parts > 0 ? std::min(shown.part, parts - 1) : 0;
  if (edited.is_polygon() && shown.point && *shown.point < edited.shape().points.size())
    edited.point = shown.point;
  return edited;
}

void put_shape(const Session& session, Actions& actions, View& view, const TileShape& whole, int stroke) {
  const SpriteArea& area = session.choices().area;
  const int tile = area.tile_at(session.level(), 0, 0);
  view.shape.draft.reset();
  if (!problem_of(whole, session.level().map.tile_size())) {
    Edit edit = change_shapes(session.level(), area, whole);
    if (!edit.empty()) actions.push_back(action::EditLevel{std::move(edit), stroke});
    return;
  }
  if (view.shape.tile != tile) view.shape.drawing.reset();
  view.shape.tile = tile;
  view.shape.before = own_shape(session.level(), tile);
  view.shape.draft = whole;
  Edit back = taken_back(session, stroke);
  for (const Change& change : back.changes)
    if (const auto* shape = std::get_if<TileShapeChange>(&change); shape != nullptr && shape->tile == tile)
      view.shape.before = shape->after;
  if (!back.empty()) actions.push_back(action::EditLevel{std::move(back), stroke});
}

void put_part(const Session& session, Actions& actions, View& view, const TileShape& part, int stroke) {
  const EditedShape edited = edited_shape(session, view);
  const bool has_parts = part_count(edited.whole) > 0;
  put_shape(session, actions, view, has_parts ? with_part_at(edited.whole, edited.part, part) : part, stroke);
}

void begin_drawing(const Session& session, View& view) {
  const EditedShape edited = edited_shape(session, view);
  if (!edited.is_draft) view.shape.draft.reset();
  view.shape.tile = edited.tile;
  view.shape.drawing.emplace();
  view.shape.point.reset();
}

void close_drawing(const Session& session, Actions& actions, View& view) {
  const EditedShape edited = edited_shape(session, view);
  if (!edited.is_drawing) return;
  if (view.shape.drawing->size() < kLeastPoints) return say_least_points(actions);
  const TileShape polygon{.kind = TileShape::Kind::polygon, .points = *std::exchange(view.shape.drawing, {})};
  view.shape.part = part_count(edited.whole);
  put_shape(session, actions, view, with_new_part(edited.whole, polygon));
}

void drop_last_point(View& view) {
  assert(view.shape.drawing);
  if (view.shape.drawing->empty()) return view.shape.drawing.reset();
  view.shape.drawing->pop_back();
}

bool take_back_unfinished(const Session& session, View& view) {
  const EditedShape edited = edited_shape(session, view);
  if (edited.is_drawing) {
    drop_last_point(view);
    return true;
  }
  view.shape.draft.reset();
  return edited.is_draft;
}

void remove_point(const Session& session, Actions& actions, View& view, std::size_t point) {
  const TileShape polygon = edited_shape(session, view).shape();
  if (polygon.points.size() <= kLeastPoints) return say_least_points(actions);
  view.shape.point.reset();
  put_part(session, actions, view, without_point(polygon, point));
}

void add_part(const Session& session, Actions& actions, View& view, TileShape::Kind kind) {
  const EditedShape edited = edited_shape(session, view);
  view.shape.part = part_count(edited.whole);
  view.shape.point.reset();
  put_shape(session, actions, view, with_new_part(edited.whole, with_kind({}, kind, edited.size)));
}

std::string draft_text(const EditedShape& edited) {
  if (!edited.is_draft) return {};
  return "Not in the level: the shape " + problem_of(edited.whole, edited.size).value_or("is invalid") + ".";
}

}  // namespace talus
