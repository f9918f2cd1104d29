// The commands of curves and bodies on the map, and Duplicate.
#include "command_table.h"
#include "edit/spawn_tools.h"
#include "panels/inspector/chosen_curve.h"
#include "panels/inspector/chosen_object.h"
#include "panels/inspector/chosen_spawn.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;

// If the tool is chosen already, this chooses the next kind of curve.
void choose_curve_tool(S session, A actions, U) {
  const Choices& choices = session.choices();
  if (choices.map_tool == MapTool::curve) {
    const int next = (static_cast<int>(choices.curve_kind) + 1) % kCurveKindCount;
    actions.push_back(action::SetCurveKind{static_cast<CurveKind>(next)});
  }
  actions.push_back(action::SetPasted{});
  actions.push_back(action::SetMapTool{MapTool::curve});
}

CommandRun draw_kind(CurveKind kind) {
  return [kind](S, A actions, U) {
    actions.push_back(action::SetCurveKind{kind});
    actions.push_back(action::SetPasted{});
    actions.push_back(action::SetMapTool{MapTool::curve});
  };
}

CommandTest draws_kind(CurveKind kind) {
  return [kind](S session, const Ui&) {
    return session.choices().map_tool == MapTool::curve && session.choices().curve_kind == kind;
  };
}

// The inspector shows what is duplicated: a curve while a tool draws curves, an object with the object tool,
// or else a body.
bool can_duplicate(S session, const Ui&) {
  if (session.choices().map_tool == MapTool::object) return chosen_object(session) != nullptr;
  return (draws_curves(session.choices().map_tool) ? chosen_curve(session) : chosen_spawn(session)) >= 0;
}

void duplicate(S session, A actions, U) {
  const Level& level = session.level();
  if (session.choices().map_tool == MapTool::object) {
    const ObjectRef chosen = session.choices().object;
    if (const auto problem = problem_of_layer(level, chosen.layer))
      return actions.push_back(action::ShowMessage{*problem, true});
    actions.push_back(action::EditLevel{duplicate_object(level, chosen)});
    actions.push_back(action::SelectObject{place_of_added(level, chosen.layer)});
    return;
  }
  if (!draws_curves(session.choices().map_tool)) {
    actions.push_back(action::EditLevel{duplicate_spawn(level, chosen_spawn(session))});
    actions.push_back(action::SelectSpawn{static_cast<int>(level.spawns.size())});
    return;
  }
  auto edit = duplicate_curve(level, chosen_curve(session));
  if (!edit) return actions.push_back(action::ShowMessage{"No copy: " + edit.error() + ".", true});
  actions.push_back(action::EditLevel{*std::move(edit)});
  actions.push_back(action::SelectCurve{static_cast<int>(level.curves.size())});
}

}  // namespace

std::vector<Command> curve_commands() {
  return in_scope(
      Scope::map,
      {
          {.id = "map/curve",
           .label = "Draw curves",
           .help = "Drag from end to end to draw an arc, a parabola and so on; press the key again for the "
                   "next kind. Drag a curve to move it, or a handle of the chosen one to bend it; with "
                   "Shift, a drag always draws. Ends snap; with Ctrl to half pixels, with Alt not at all.",
           .key = KeyChord{'c'},
           .menu = menus::kMapTools,
           .icon = Icon::curve,
           .run = choose_curve_tool,
           .checked = is_map_tool(MapTool::curve)},
          {.id = "map/curve_arc",
           .label = "Draw an arc",
           .help = "A part of a circle between two ends.",
           .run = draw_kind(CurveKind::arc),
           .checked = draws_kind(CurveKind::arc)},
          {.id = "map/curve_parabola",
           .label = "Draw a parabola",
           .help = "A hill or a bowl whose control point is half way between its ends.",
           .run = draw_kind(CurveKind::parabola),
           .checked = draws_kind(CurveKind::parabola)},
          {.id = "map/curve_cubic",
           .label = "Draw a cubic",
           .help = "A curve with a slope at each end.",
           .run = draw_kind(CurveKind::cubic),
           .checked = draws_kind(CurveKind::cubic)},
          {.id = "map/curve_sine",
           .label = "Draw a sine",
           .help = "Waves between two ends.",
           .run = draw_kind(CurveKind::sine),
           .checked = draws_kind(CurveKind::sine)},
          {.id = "map/curve_polyline",
           .label = "Draw a polyline",
           .help = "A line through heights at equal distances.",
           .run = draw_kind(CurveKind::polyline),
           .checked = draws_kind(CurveKind::polyline)},
          {.id = "map/duplicate",
           .label = "Duplicate",
           .help =
               "Copies what the inspector shows to a place one tile further on: the chosen curve, with a "
               "tool that draws curves, the chosen object, with the object tool, or else the chosen body.",
           .key = ctrl('d'),
           .menu = menus::kMapBrushes,
           .run = duplicate,
           .enabled = can_duplicate},
      });
}

}  // namespace talus
