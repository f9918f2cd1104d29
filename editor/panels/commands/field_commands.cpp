// The commands that go to a field or a list of a panel, where a value is typed or chosen.
#include "command_table.h"
#include "edit/brush_tools.h"
#include "panels/inspector/chosen_curve.h"
#include "panels/inspector/chosen_spawn.h"

#include <algorithm>

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;

std::vector<Command> color_fields() {
  return {
      {.id = "palette/type",
       .label = "Type the colour...",
       .help = "Goes to the field of the chosen colour, as RRGGBB or RGB; Enter sets it.",
       .run = go_to_field(panel_id::kColor, "palette/hex"),
       .words = "hex rgb edit color palette"},
      {.id = "palette/type_red",
       .label = "Type the colour's red...",
       .help = "Goes to the number of red, 0 to 255; Tab goes on to green and blue.",
       .run = go_to_field(panel_id::kColor, "palette/red_number"),
       .words = "edit color rgb slider palette"},
      {.id = "palette/type_green",
       .label = "Type the colour's green...",
       .help = "Goes to the number of green, 0 to 255.",
       .run = go_to_field(panel_id::kColor, "palette/green_number"),
       .words = "edit color rgb slider palette"},
      {.id = "palette/type_blue",
       .label = "Type the colour's blue...",
       .help = "Goes to the number of blue, 0 to 255.",
       .run = go_to_field(panel_id::kColor, "palette/blue_number"),
       .words = "edit color rgb slider palette"},
  };
}

constexpr const char* kBodyWords = "spawn object entity player ball start inspector";

// The inspector shows curves while a tool for curves is chosen, and objects with the object tool.
bool shows_spawn(S session, const Ui&) {
  const MapTool tool = session.choices().map_tool;
  return !draws_curves(tool) && tool != MapTool::object && chosen_spawn(session) >= 0;
}

CommandRun choose_body(int step) {
  return [step](S session, A actions, U ui) {
    const auto& bodies = session.state().bodies;
    std::size_t next = step > 0 ? 0 : bodies.size() - 1;
    for (std::size_t i = 0; i < bodies.size(); ++i)
      if (bodies[i].id == session.choices().body)
        next = (i + bodies.size() + static_cast<std::size_t>(step)) % bodies.size();
    actions.push_back(action::SelectBody{bodies[next].id});
    const MapTool tool = session.choices().map_tool;
    if (draws_curves(tool) || tool == MapTool::object) actions.push_back(action::SetMapTool{MapTool::body});
    ui.ask(request::ShowTab(panel_id::kInspector));
  };
}
bool has_body_to_choose(S session, const Ui&) { return !session.state().bodies.empty(); }

std::vector<Command> body_fields() {
  return {
      {.id = "bodies/next",
       .label = "Choose the next body",
       .help = "Shows the body in the inspector.",
       .run = choose_body(1),
       .enabled = has_body_to_choose,
       .repeats = true,
       .words = kBodyWords},
      {.id = "bodies/previous",
       .label = "Choose the previous body",
       .help = "Shows the body in the inspector.",
       .run = choose_body(-1),
       .enabled = has_body_to_choose,
       .repeats = true,
       .words = kBodyWords},
      {.id = "bodies/name",
       .label = "Name the body...",
       .help = "Goes to the field of the chosen body's name.",
       .run = go_to_field(panel_id::kInspector, "inspector/spawn_name"),
       .enabled = shows_spawn,
       .words = "spawn object entity rename inspector"},
      {.id = "bodies/kind",
       .label = "Kind of the body...",
       .help = "Opens the list of kinds for the chosen body.",
       .run = go_to_field(panel_id::kInspector, "inspector/kind"),
       .enabled = shows_spawn,
       .words = "spawn object entity type inspector"},
      {.id = "bodies/foot",
       .label = "Choose the body's foot...",
       .help = "Opens the list of what stands on slopes: the body's box, or its centre.",
       .run = go_to_field(panel_id::kInspector, "inspector/foot"),
       .enabled = shows_spawn,
       .words = "spawn foot centre box inspector"},
      {.id = "bodies/position",
       .label = "Type where the body starts...",
       .help = "Goes to where the chosen body starts, its x; Tab goes on to its y.",
       .run = go_to_field(panel_id::kInspector, "inspector/start_x"),
       .enabled = shows_spawn,
       .words = "spawn object position x y coordinates"},
      {.id = "bodies/velocity",
       .label = "Type the body's velocity at the start...",
       .help = "Goes to the chosen body's velocity at the start, its vx; Tab goes on to its vy.",
       .run = go_to_field(panel_id::kInspector, "inspector/start_vx"),
       .enabled = shows_spawn,
       .words = "spawn object speed initial vx vy"},
  };
}

constexpr const char* kCurveWords = "line segment arc polyline inspector";

bool has_curve_to_choose(S session, const Ui&) { return !session.level().curves.empty(); }
bool shows_curve(S session, const Ui&) {
  return draws_curves(session.choices().map_tool) && chosen_curve(session) >= 0;
}

void choose_next_curve(S session, A actions, U ui) {
  const int count = static_cast<int>(session.level().curves.size());
  const int next = (chosen_curve(session) + 1) % count;
  if (!draws_curves(session.choices().map_tool)) actions.push_back(action::SetMapTool{MapTool::curve});
  actions.push_back(action::SelectCurve{next});
  ui.ask(request::ShowTab(panel_id::kInspector));
}

std::vector<Command> curve_fields() {
  return {
      {.id = "curves/next",
       .label = "Choose the next curve",
       .help = "Shows the curve in the inspector, with the curve tool.",
       .run = choose_next_curve,
       .enabled = has_curve_to_choose,
       .repeats = true,
       .words = kCurveWords},
      {.id = "curves/name",
       .label = "Name the curve...",
       .help = "Goes to the field of the chosen curve's name.",
       .run = go_to_field(panel_id::kInspector, "inspector/curve_name"),
       .enabled = shows_curve,
       .words = "rename line segment inspector"},
      {.id = "curves/faces",
       .label = "Choose the way that the curve faces...",
       .help = "Opens the list: up, down or both ways.",
       .run = go_to_field(panel_id::kInspector, "inspector/curve_faces"),
       .enabled = shows_curve,
       .words = "line segment one-way floor ceiling"},
  };
}

bool has_tile_to_shape(S session, const Ui&) { return session.choices().area.sheet == SheetId::tiles; }
bool has_shape_to_copy(S session, const Ui& ui) {
  const auto tile = static_cast<TileNumber>(session.choices().area.tile_at(session.level(), 0, 0));
  return has_tile_to_shape(session, ui) && shape_of_tile(session.level(), tile).kind != TileShape::Kind::none;
}

// Returns the index of the brush that is the stamp, or of the last one.
int brush_to_name(S session) {
  const auto& brushes = session.level().brushes;
  for (std::size_t i = 0; i < brushes.size(); ++i)
    if (stamp_of_brush(brushes[i]) == session.choices().stamp) return static_cast<int>(i);
  return static_cast<int>(brushes.size()) - 1;
}
bool has_brush_to_take(S session, const Ui&) { return !session.level().brushes.empty(); }

void name_brush(S session, A, U ui) {
  ui.ask(request::ShowTab(panel_id::kBrushes));
  ui.ask(request::FocusField("brushes/" + std::to_string(brush_to_name(session)) + "/name"));
}

void take_next_brush(S session, A actions, U) {
  const auto& brushes = session.level().brushes;
  std::size_t next = 0;
  for (std::size_t i = 0; i + 1 < brushes.size(); ++i)
    if (stamp_of_brush(brushes[i]) == session.choices().stamp) next = i + 1;
  actions.push_back(action::SetStamp{stamp_of_brush(brushes[next])});
  actions.push_back(action::SetRandomStamp{brushes[next].random, session.choices().random_seed});
  actions.push_back(action::SetMapTool{MapTool::stamp});
}

// The field exists only while such problems are listed.
void type_seam(S session, A actions, U ui) {
  const auto rules = lint_rules();
  const auto rule =
      std::find_if(rules.begin(), rules.end(), [](const LintRule* other) { return other->has_seam; });
  ui.view.level.problems.kind = rule == rules.end() ? nullptr : *rule;
  go_to_field(panel_id::kProblems, "problems/seam")(session, actions, ui);
}

std::vector<Command> other_fields() {
  return {
      {.id = "shape/choose",
       .label = "Choose the tile's shape...",
       .help = "Opens the list: none, solid, slope, profile or polygon.",
       .run = go_to_field(panel_id::kShape, "shape/kind"),
       .enabled = has_tile_to_shape,
       .words = "collision ground kind full slope heights polygon"},
      {.id = "shape/turn_copy",
       .label = "Copy the tile turned or mirrored...",
       .help = "Opens the list of turns; Tab goes on to the tile that gets the copy.",
       .run = go_to_field(panel_id::kShape, "shape/turn"),
       .enabled = has_shape_to_copy,
       .words = "mirror flip rotate shape duplicate"},
      {.id = "tile/type_class",
       .label = "Type the tile's class...",
       .help = "Goes to the field of the class that games take the selected tiles for.",
       .run = go_to_field(panel_id::kTile, "tile/class"),
       .enabled = has_tile_to_shape,
       .words = "type data note"},
      {.id = "tile/type_probability",
       .label = "Type the tile's probability...",
       .help = "Goes to how often random painting takes the selected tiles.",
       .run = go_to_field(panel_id::kTile, "tile/probability"),
       .enabled = has_tile_to_shape,
       .words = "weight random dice"},
      {.id = "tile/new_property",
       .label = "Add a property to the tile...",
       .help = "Goes to the field of a new property's name; Enter adds it.",
       .run = go_to_field(panel_id::kTile, "tile/tile_new_property"),
       .enabled = has_tile_to_shape,
       .words = "custom data value"},
      {.id = "tile/animate",
       .label = "Add a frame to the tile's animation",
       .help = "Adds the selected tiles as frames of the animation that the tab Tile shows.",
       .run = go_to_field(panel_id::kTile, "tile/add_frame"),
       .enabled = has_tile_to_shape,
       .words = "animation frame duration ms"},
      {.id = "problems/choose",
       .label = "List problems of one kind...",
       .help = "Opens the list of kinds of problems.",
       .run = go_to_field(panel_id::kProblems, "problems/kind"),
       .words = "lint filter rule check"},
      {.id = "problems/type_seam",
       .label = "Type the allowed jump of floors...",
       .help = "Goes to the number of px that a floor may jump without being listed.",
       .run = type_seam,
       .words = "lint seam tolerance step"},
      {.id = "brushes/next",
       .label = "Take the next brush",
       .help = "Makes the next of the level's brushes the stamp.",
       .run = take_next_brush,
       .enabled = has_brush_to_take,
       .repeats = true,
       .words = "stamp pattern"},
      {.id = "brushes/type_name",
       .label = "Name the brush...",
       .help = "Goes to the name of the brush that is the stamp, or else of the last one.",
       .run = name_brush,
       .enabled = has_brush_to_take,
       .words = "stamp pattern rename"},
      {.id = "compare/type_parting",
       .label = "Type the distance that counts as parted...",
       .help = "Goes to the distance in px from which on the two sides count as parted.",
       .run = go_to_field(panel_id::kCompare, "compare/threshold", PanelIn::debugger),
       .words = "parting threshold difference"},
      {.id = "compare/choose",
       .label = "Compare with...",
       .help = "Opens the list of solvers and branches to compare with.",
       .run = go_to_field(panel_id::kCompare, "compare/with", PanelIn::debugger),
       .words = "solver branch difference"},
  };
}

}  // namespace

std::vector<Command> field_commands() {
  return joined({color_fields(), body_fields(), curve_fields(), other_fields()});
}

}  // namespace talus
