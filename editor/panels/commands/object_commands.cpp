// The commands of objects on the map.
#include <algorithm>

#include "command_table.h"
#include "panels/inspector/chosen_object.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;

// If the tool is chosen already, this chooses the next form.
void choose_object_tool(S session, A actions, U) {
  const Choices& choices = session.choices();
  if (choices.map_tool == MapTool::object) {
    const int next = (static_cast<int>(choices.object_kind) + 1) % kObjectKindCount;
    actions.push_back(action::SetObjectKind{static_cast<ObjectKind>(next)});
  }
  actions.push_back(action::SetPasted{});
  actions.push_back(action::SetMapTool{MapTool::object});
}

CommandRun draw_object(ObjectKind kind) {
  return [kind](S, A actions, U) {
    actions.push_back(action::SetObjectKind{kind});
    actions.push_back(action::SetPasted{});
    actions.push_back(action::SetMapTool{MapTool::object});
  };
}

CommandTest draws_object(ObjectKind kind) {
  return [kind](S session, const Ui&) {
    return session.choices().map_tool == MapTool::object && session.choices().object_kind == kind;
  };
}

ObjectRef object_after(S session) {
  const std::vector<ObjectLayer>& layers = session.level().objects;
  ObjectRef next = session.choices().object;
  next.layer = std::clamp(next.layer, 0, static_cast<int>(layers.size()) - 1);
  for (std::size_t tries = 0; tries <= layers.size(); ++tries) {
    if (find_object(session.level(), {next.layer, ++next.index}) != nullptr) return next;
    next = {(next.layer + 1) % static_cast<int>(layers.size()), -1};
  }
  return {};
}

bool has_object_to_choose(S session, const Ui&) {
  const std::vector<ObjectLayer>& layers = session.level().objects;
  return std::any_of(layers.begin(), layers.end(), [](const auto& layer) { return !layer.objects.empty(); });
}
bool shows_object(S session, const Ui&) {
  return session.choices().map_tool == MapTool::object && chosen_object(session) != nullptr;
}

void choose_next_object(S session, A actions, U ui) {
  actions.push_back(action::SetMapTool{MapTool::object});
  actions.push_back(action::SelectObject{object_after(session)});
  ui.ask(request::ShowTab(panel_id::kInspector));
}

// By so many px, or cells of the map.
CommandRun move_object_by(Vec2 by, bool cells) {
  return [=](S session, A actions, U) {
    const TileSize cell = cells ? session.level().map.tile_size() : TileSize{1, 1};
    move_chosen_object(session, actions, {by.x * cell.width, by.y * cell.height});
  };
}

Command move_command(const std::string& direction, Vec2 by, int key, bool cells) {
  const std::string far = cells ? " by a cell" : "";
  return {.id = "objects/" + direction + (cells ? "_cell" : ""),
          .label = "Move the object " + direction + far,
          .help = cells ? "Moves the chosen object by as much as a cell of the map."
                        : "Moves the chosen object by a px; with the object tool, the arrows do so, too.",
          .key = cells ? shift(key) : KeyChord(),
          .run = move_object_by(by, cells),
          .enabled = shows_object,
          .repeats = true,
          .words = "nudge"};
}

std::vector<Command> object_move_commands() {
  std::vector<Command> all;
  for (const bool cells : {false, true}) {
    all.push_back(move_command("left", {-1, 0}, kKeyLeft, cells));
    all.push_back(move_command("right", {1, 0}, kKeyRight, cells));
    all.push_back(move_command("up", {0, -1}, kKeyUp, cells));
    all.push_back(move_command("down", {0, 1}, kKeyDown, cells));
  }
  return all;
}

std::vector<Command> object_tool_commands() {
  return {
      {.id = "map/object",
       .label = "Edit objects",
       .help =
           "Drag to draw a rectangle and so on; press the key again for the next form. Drag an object to "
           "move it, or a handle of the chosen one to resize it; the middle of a polygon's side pulls out a "
           "point. With Shift, a drag always draws. The arrows move the chosen object. Places snap; with "
           "Ctrl to half pixels, with Alt not at all.",
       .key = KeyChord{'j'},
       .menu = menus::kMapTools,
       .icon = Icon::object,
       .run = choose_object_tool,
       .checked = is_map_tool(MapTool::object),
       .words = "object layer zone trigger rectangle polygon point"},
      {.id = "map/object_rectangle",
       .label = "Draw a rectangle",
       .help = "An object that is a rectangle.",
       .run = draw_object(ObjectKind::rectangle),
       .checked = draws_object(ObjectKind::rectangle)},
      {.id = "map/object_ellipse",
       .label = "Draw an ellipse",
       .help = "An object that is an ellipse.",
       .run = draw_object(ObjectKind::ellipse),
       .checked = draws_object(ObjectKind::ellipse)},
      {.id = "map/object_polygon",
       .label = "Draw a polygon of corners",
       .help = "Each click adds a corner; a click on the first one, or Enter, closes it. Backspace takes the "
               "last "
               "corner back, Escape all of them.",
       .run = draw_object(ObjectKind::polygon),
       .checked = draws_object(ObjectKind::polygon)},
      {.id = "map/object_point",
       .label = "Place a point",
       .help = "An object that is a point.",
       .run = draw_object(ObjectKind::point),
       .checked = draws_object(ObjectKind::point)},
  };
}

std::vector<Command> chosen_object_commands() {
  return {
      {.id = "objects/next",
       .label = "Choose the next object",
       .help = "Shows the object in the inspector, with the object tool.",
       .run = choose_next_object,
       .enabled = has_object_to_choose,
       .repeats = true,
       .words = "layer inspector"},
      {.id = "objects/name",
       .label = "Name the object...",
       .help = "Goes to the field of the chosen object's name.",
       .run = go_to_field(panel_id::kInspector, "inspector/object_name"),
       .enabled = shows_object,
       .words = "rename inspector"},
      {.id = "objects/class",
       .label = "Type the object's class...",
       .help = "Goes to the field of the chosen object's class.",
       .run = go_to_field(panel_id::kInspector, "inspector/object_class"),
       .enabled = shows_object,
       .words = "type inspector"},
      {.id = "objects/position",
       .label = "Type the object's place...",
       .help = "Goes to the chosen object's x; Tab goes on to its other numbers.",
       .run = go_to_field(panel_id::kInspector, "inspector/object_x"),
       .enabled = shows_object,
       .words = "x y width height rotation inspector"},
  };
}

}  // namespace

std::vector<Command> object_commands() {
  return in_scope(Scope::map,
                  joined({object_tool_commands(), chosen_object_commands(), object_move_commands()}));
}

}  // namespace talus
