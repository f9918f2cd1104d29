// The rows of the table of commands, and helpers for writing them.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "commands.h"
#include "panels/emit_edit.h"
#include "panels/panel_ids.h"

namespace talus {

std::vector<Command> general_commands();     // work everywhere
std::vector<Command> cursor_commands();      // one works everywhere, the others at the keyboard's cursor
std::vector<Command> debug_commands();       // work everywhere, too
std::vector<Command> program_commands();     // work everywhere, too
std::vector<Command> tool_commands();        // work in the sprites
std::vector<Command> map_commands();         // work in the map: its tools and its selection
std::vector<Command> brush_commands();       // work in the map: brushes, ground, minimap
std::vector<Command> layer_commands();       // work in the map, on its layers
std::vector<Command> flag_commands();        // work everywhere
std::vector<Command> picture_commands();     // work everywhere
std::vector<Command> export_commands();      // work everywhere
std::vector<Command> problem_commands();     // work everywhere: the problems, and the reach
std::vector<Command> curve_commands();       // work in the map, on curves and bodies
std::vector<Command> object_commands();      // work in the map, on objects
std::vector<Command> shape_commands();       // work everywhere, on the selected tiles
std::vector<Command> polygon_commands();     // work in the shape editor, and give it the keys
std::vector<Command> panel_commands();       // work everywhere: tabs and menus by keys
std::vector<Command> field_commands();       // work everywhere: values that are typed or chosen in a panel
std::vector<Command> input_roll_commands();  // work in the input roll, and give it the keys
std::vector<Command> player_commands();      // work in the play view

// Emits an action without parameters.
template <class T>
void emit(const Session&, Actions& actions, Ui&) {
  actions.push_back(T{});
}

// Toggles a bool of the view, given by the members that lead to it: toggle<&View::canvas,
// &CanvasesView::follow_body> toggles ui.view.canvas.follow_body.
template <auto... kMembers>
void toggle(const Session&, Actions&, Ui& ui) {
  bool& value = (ui.view.*....*kMembers);
  value = !value;
}
// Returns the value of such a bool.
template <auto... kMembers>
bool is_on(const Session&, const Ui& ui) {
  return (ui.view.*....*kMembers);
}

// Where a panel is: beside the map, where it is always shown, or among those of the debugger.
enum class PanelIn { window, debugger };

// Shows the tab of a panel, and gives the keys to one of its fields or lists by the widget's name; empty: to
// no widget.
inline CommandRun go_to_field(std::string_view panel, std::string field, PanelIn place = PanelIn::window) {
  return [panel, field = std::move(field), place](const Session&, Actions&, Ui& ui) {
    if (place == PanelIn::debugger) ui.view.window.dock_open = true;
    ui.ask(request::ShowTab(panel));
    ui.ask(request::FocusField(field));
  };
}

// Chooses the tool for the mouse on the map's canvas.
inline CommandRun choose_map_tool(MapTool tool) {
  return [tool](const Session&, Actions& actions, Ui&) { actions.push_back(action::SetMapTool{tool}); };
}
inline CommandTest is_map_tool(MapTool tool) {
  return [tool](const Session& session, const Ui& ui) {
    return session.choices().map_tool == tool && !ui.view.canvas.has_hand();
  };
}

inline std::vector<Command> in_scope(Scope scope, std::vector<Command> commands) {
  for (Command& command : commands) command.scope = scope;
  return commands;
}
inline std::vector<Command> joined(std::initializer_list<std::vector<Command>> parts) {
  std::vector<Command> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace talus
