// The commands of curves and bodies on the map.
#include "command_table.h"
#include "edit/spawn_tools.h"
#include "panels/inspector/chosen_curve.h"
#include "panels/inspector/chosen_spawn.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;

// Chosen again, it goes on to the next kind.
void choose_curve_tool(S session, A actions, U) {
  const Choices& choices = session.choices();
  if (choices.map_tool == MapTool::curve) {
    const int next = (static_cast<int>(choices.curve_kind) + 1) % kCurveKindCount;
    actions.push_back(action::SetCurveKind{static_cast<CurveKind>(next)});
  }
  actions.push_back(action::SetPasted{});
  actions.push_back(action::SetMapTool{MapTool::curve});
}

template <CurveKind kind>
void draw_kind(S, A actions, U) {
  actions.push_back(action::SetCurveKind{kind});
  actions.push_back(action::SetPasted{});
  actions.push_back(action::SetMapTool{MapTool::curve});
}

template <CurveKind kind>
bool draws_kind(S session, const Ui&) {
  return session.choices().map_tool == MapTool::curve && session.choices().curve_kind == kind;
}

template <CurveKind kind>
Command curve_kind(std::string_view id, std::string_view label, std::string_view help) {
  return toggle(id, KeyChord{}, label, help, draw_kind<kind>, draws_kind<kind>);
}

bool can_duplicate(S session, const Ui&) {
  const MapTool tool = session.choices().map_tool;
  return (tool == MapTool::body && chosen_spawn(session) >= 0) ||
         (draws_curves(tool) && chosen_curve(session) >= 0);
}

void duplicate(S session, A actions, U) {
  const Level& level = session.level();
  if (session.choices().map_tool == MapTool::body) {
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
          toggle(
              "map/curve", KeyChord{'c'}, "Draw curves",
              "Drag from end to end: an arc, a parabola and so on; press the key again for the next kind. "
              "Drag a line to move it, a chosen one's handles to bend it; with Shift, a drag always draws. "
              "Ends snap; Ctrl: to half pixels, Alt: not at all.",
              choose_curve_tool, is_map_tool<MapTool::curve>),
          curve_kind<CurveKind::arc>("map/curve_arc", "Draw an arc", "A part of a circle between two ends."),
          curve_kind<CurveKind::parabola>("map/curve_parabola", "Draw a parabola",
                                          "A hill or a bowl whose control point is half way."),
          curve_kind<CurveKind::cubic>("map/curve_cubic", "Draw a cubic",
                                       "A curve with a slope at each end."),
          curve_kind<CurveKind::sine>("map/curve_sine", "Draw a sine", "Waves between two ends."),
          curve_kind<CurveKind::polyline>("map/curve_polyline", "Draw a polyline",
                                          "A line through heights at equal distances."),
          command("map/duplicate", ctrl('d'), "Duplicate",
                  "Copies the chosen body, with the body tool, or the chosen curve, a tile further on.",
                  duplicate, can_duplicate),
      });
}

}  // namespace talus
