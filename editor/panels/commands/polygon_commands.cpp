// The commands of the shape editor: points of polygons, and parts of groups.
#include <algorithm>

#include <talus/collision/shape_forms.h>
#include "command_table.h"
#include "panels/tiles/edited_shape.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;

bool has_tile(S session, const Ui&) { return session.choices().area.sheet == SheetId::tiles; }
bool has_ground(S session, const Ui& ui) { return part_count(edited_shape(session, ui.view).whole) > 0; }
bool has_group(S session, const Ui& ui) { return part_count(edited_shape(session, ui.view).whole) > 1; }
bool has_polygon(S session, const Ui& ui) { return edited_shape(session, ui.view).is_polygon(); }
bool has_point(S session, const Ui& ui) { return edited_shape(session, ui.view).point.has_value(); }
bool is_drawing(S session, const Ui& ui) { return edited_shape(session, ui.view).is_drawing; }

bool can_remove_point(S session, const Ui& ui) { return is_drawing(session, ui) || has_point(session, ui); }
bool has_unfinished(S session, const Ui& ui) {
  const EditedShape edited = edited_shape(session, ui.view);
  return edited.is_drawing || edited.is_draft || edited.point;
}

void show_shape_tab(U ui) { ui.ask(request::ShowTab(panel_id::kShape)); }

void give_keys_to_shape(S session, A, U ui) {
  show_shape_tab(ui);
  ui.view.shape.last_frame = ImGui::GetFrameCount();
  ui.view.window.keys_in_panel = false;
  ui.view.window.focus = Focus::shape;
  if (ui.view.canvas.cursor.on() && has_tile(session, ui)) ui.view.canvas.cursor.go_to({"shape"});
}

void draw_polygon_in_tile(S session, A actions, U ui) {
  give_keys_to_shape(session, actions, ui);
  begin_drawing(session, ui.view);
}

void close_polygon(S session, A actions, U ui) { close_drawing(session, actions, ui.view); }

void drop_unfinished(S session, A, U ui) {
  ShapeView& view = ui.view.shape;
  const EditedShape edited = edited_shape(session, ui.view);
  if (edited.is_drawing)
    view.drawing.reset();
  else if (edited.is_draft)
    view.draft.reset();
  else
    view.point.reset();
}

void remove_chosen_point(S session, A actions, U ui) {
  const EditedShape edited = edited_shape(session, ui.view);
  if (edited.is_drawing) return drop_last_point(ui.view);
  remove_point(session, actions, ui.view, *edited.point);
}

// After the chosen point, or after the first one.
void insert_point(S session, A actions, U ui) {
  const EditedShape edited = edited_shape(session, ui.view);
  const std::vector<Vec2>& points = edited.shape().points;
  const std::size_t side = edited.point.value_or(0);
  const Vec2 middle = (points[side] + points[(side + 1) % points.size()]) * 0.5;
  put_part(session, actions, ui.view,
           with_point_on(edited.shape(), side, middle, ui.view.shape.snap, edited.size));
  ui.view.shape.point = side + 1;
}

CommandRun choose_point(int step) {
  return [step](S session, A, U ui) {
    const EditedShape edited = edited_shape(session, ui.view);
    const std::size_t count = edited.shape().points.size();
    const std::size_t none = step > 0 ? count - 1 : 0;  // before the first one that is chosen
    ui.view.shape.point = (edited.point.value_or(none) + count + static_cast<std::size_t>(step)) % count;
  };
}

// The chosen point, by one step of the snap; without one, the whole polygon.
CommandRun move_points(int dx, int dy) {
  return [dx, dy](S session, A actions, U ui) {
    const EditedShape edited = edited_shape(session, ui.view);
    const Vec2 step = snap_step(ui.view.shape.snap, edited.size), by{dx * step.x, dy * step.y};
    TileShape polygon = edited.shape();
    if (edited.point)
      polygon = with_point_at(polygon, *edited.point, polygon.points[*edited.point] + by, edited.size);
    else
      polygon = moved_by(polygon, by, edited.size);
    put_part(session, actions, ui.view, polygon);
  };
}

CommandRun mirror_shape(ShapeMirror mirror) {
  return [mirror](S session, A actions, U ui) {
    const EditedShape edited = edited_shape(session, ui.view);
    put_part(session, actions, ui.view, mirrored(edited.shape(), edited.size, mirror));
  };
}

void choose_next_part(S session, A, U ui) {
  const EditedShape edited = edited_shape(session, ui.view);
  ui.view.shape.part = (edited.part + 1) % part_count(edited.whole);
  ui.view.shape.point.reset();
}

void remove_part(S session, A actions, U ui) {
  ui.view.shape.point.reset();
  put_part(session, actions, ui.view, {});
}

CommandRun set_snap(PointSnap snap) {
  return [snap](S, A, U ui) { ui.view.shape.snap = snap; };
}
CommandTest has_snap(PointSnap snap) {
  return [snap](S, const Ui& ui) { return ui.view.shape.snap == snap; };
}

std::vector<Command> point_commands() {
  return {
      {.id = "shape/delete_point",
       .label = "Remove the point",
       .help = "Removes the chosen point, or the last one of an unfinished polygon. A right click on a point "
               "does it, too.",
       .key = KeyChord{kKeyDelete},
       .other_key = KeyChord{kKeyBackspace},
       .run = remove_chosen_point,
       .enabled = can_remove_point},
      {.id = "shape/insert_point",
       .label = "Insert a point",
       .help = "Inserts a point half way between the chosen one and the next. A click on a side inserts one "
               "there.",
       .key = KeyChord{'i'},
       .run = insert_point,
       .enabled = has_polygon},
      {.id = "shape/next_point",
       .label = "Next point",
       .help = "Chooses the next point of the polygon.",
       .key = KeyChord{']'},
       .run = choose_point(1),
       .enabled = has_polygon,
       .repeats = true},
      {.id = "shape/previous_point",
       .label = "Previous point",
       .help = "Chooses the previous point of the polygon.",
       .key = KeyChord{'['},
       .run = choose_point(-1),
       .enabled = has_polygon,
       .repeats = true},
      {.id = "shape/type_point",
       .label = "Type the point's place",
       .help = "Goes to the chosen point's x; Tab goes on to its y.",
       .key = KeyChord{'x'},
       .run = go_to_field(panel_id::kShape, "shape/point_x"),
       .enabled = has_point,
       .words = "coordinates position vertex"},
  };
}

std::vector<Command> move_commands() {
  struct Arrow {
    const char *id, *label;
    int key, dx, dy;
  };
  constexpr Arrow kArrows[] = {{"shape/left", "Point left", kKeyLeft, -1, 0},
                               {"shape/right", "Point right", kKeyRight, 1, 0},
                               {"shape/up", "Point up", kKeyUp, 0, -1},
                               {"shape/down", "Point down", kKeyDown, 0, 1}};
  std::vector<Command> all;
  for (const Arrow& arrow : kArrows)
    all.push_back({.id = arrow.id,
                   .label = arrow.label,
                   .help = "Moves the chosen point by one step of the snap, or the whole polygon if no point "
                           "is chosen.",
                   .key = KeyChord{arrow.key},
                   .run = move_points(arrow.dx, arrow.dy),
                   .enabled = has_polygon,
                   .repeats = true});
  return all;
}

std::vector<Command> snap_commands() {
  return {
      {.id = "shape/snap_corners",
       .label = "Snap to corners of cells",
       .help = "Points of polygons are put at corners of cells; with Alt anywhere.",
       .key = KeyChord{'1'},
       .run = set_snap(PointSnap::corners),
       .checked = has_snap(PointSnap::corners),
       .words = "grid polygon shape"},
      {.id = "shape/snap_halves",
       .label = "Snap to half cells",
       .help = "Points of polygons are put at corners of cells and half way between; with Alt anywhere.",
       .key = KeyChord{'2'},
       .run = set_snap(PointSnap::halves),
       .checked = has_snap(PointSnap::halves),
       .words = "grid polygon shape"},
      {.id = "shape/snap_pixels",
       .label = "Snap to pixels",
       .help = "Points of polygons are put at whole pixels; with Alt anywhere.",
       .key = KeyChord{'3'},
       .run = set_snap(PointSnap::pixels),
       .checked = has_snap(PointSnap::pixels),
       .words = "grid polygon shape"},
      {.id = "shape/snap_free",
       .label = "Do not snap",
       .help = "Points of polygons are put anywhere, rounded to 1/256 px as in the file.",
       .key = KeyChord{'4'},
       .run = set_snap(PointSnap::free),
       .checked = has_snap(PointSnap::free),
       .words = "grid polygon shape free"},
  };
}

std::vector<Command> part_commands() {
  return {
      {.id = "shape/add_part",
       .label = "Add a part to the shape...",
       .help = "Opens the list of what can be added, so that a tile has several polygons, slopes and so on, "
               "which are one ground.",
       .key = KeyChord{'a'},
       .run = go_to_field(panel_id::kShape, "shape/add"),
       .enabled = has_ground,
       .words = "group several polygons"},
      {.id = "shape/next_part",
       .label = "Next part",
       .help = "Chooses the next part of a shape that has several. A click on a part chooses it, too.",
       .key = KeyChord{'n'},
       .run = choose_next_part,
       .enabled = has_group,
       .repeats = true,
       .words = "group"},
      {.id = "shape/remove_part",
       .label = "Remove the part",
       .help = "Removes the chosen part of the shape.",
       .key = shift(kKeyDelete),
       .run = remove_part,
       .enabled = has_group,
       .words = "group delete"},
  };
}

std::vector<Command> whole_polygon_commands() {
  return {
      {.id = "shape/draw",
       .label = "Draw a polygon",
       .help =
           "Click the polygon's points in the shape editor, and the first one again or Enter to close it. "
           "If the tile has a shape, it becomes a further part of it.",
       .key = KeyChord{'d'},
       .menu = menus::kEditShape,
       .icon = Icon::pencil,
       .run = draw_polygon_in_tile,
       .enabled = has_tile,
       .checked = is_drawing,
       .words = "collision shape points"},
      {.id = "shape/close",
       .label = "Close the polygon",
       .help = "Joins the last point to the first one. Enter does it, too.",
       .key = KeyChord{'c'},
       .run = close_polygon,
       .enabled = is_drawing},
      {.id = "shape/mirror_h",
       .label = "Mirror the shape left and right",
       .help = "Mirrors the tile's shape, or its chosen part, in the middle of the tile. The pixels stay.",
       .key = KeyChord{'h'},
       .menu = menus::kEditShape,
       .icon = Icon::flip_horizontal,
       .run = mirror_shape(ShapeMirror::left_right),
       .enabled = has_ground,
       .words = "flip polygon"},
      {.id = "shape/mirror_v",
       .label = "Mirror the shape upside down",
       .help = "Mirrors the tile's shape, or its chosen part, in the middle of the tile; a floor becomes a "
               "ceiling. The pixels stay.",
       .key = KeyChord{'v'},
       .menu = menus::kEditShape,
       .icon = Icon::flip_vertical,
       .run = mirror_shape(ShapeMirror::up_down),
       .enabled = has_ground,
       .words = "flip polygon"},
      {.id = "shape/cancel",
       .label = "End what is unfinished",
       .help = "Drops an unfinished polygon; or goes back from an invalid shape to that of the level; or "
               "chooses no point.",
       .key = KeyChord{kKeyEscape},
       .run = drop_unfinished,
       .enabled = has_unfinished},
  };
}

}  // namespace

std::vector<Command> polygon_commands() {
  return joined({{{.id = "view/shape",
                   .label = "Shape editor",
                   .help = "Shows the selected tile's shape, and gives the keys to its canvas.",
                   .key = shift(kKeyF2),
                   .menu = menus::kViewFocus,
                   .run = give_keys_to_shape,
                   .checked = [](S, const Ui& ui) { return ui.view.window.focus == Focus::shape; },
                   .words = "collision polygon slope"}},
                 in_scope(Scope::shape, joined({whole_polygon_commands(), point_commands(), move_commands(),
                                                snap_commands(), part_commands()}))});
}

}  // namespace talus
