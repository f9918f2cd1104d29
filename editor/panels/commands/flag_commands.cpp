// The commands of the flags: painting and finding them.
#include <array>

#include "command_table.h"
#include "edit/flag_lamps.h"
#include "edit/flag_tools.h"
#include "level/flag_search.h"
#include "panels/tiles/flag_label.h"

namespace talus {
namespace {

// The flag brush paints the tinted flag, so it tints one if there is none.
void toggle_brush(const Session& session, Actions& actions, Ui&) {
  const bool on = session.choices().map_tool != MapTool::flag;
  actions.push_back(action::SetMapTool{on ? MapTool::flag : MapTool::stamp});
  if (on && !session.choices().flag_overlay)
    actions.push_back(action::SetFlagOverlay{flag_patterns(session.level()).front()});
}

CommandRun go_to_flagged(bool forwards) {
  return [forwards](const Session& session, Actions&, Ui& ui) {
    const auto cell =
        find_flagged_cell(session.level(), *session.choices().flag_overlay, ui.view.canvas.search_start(),
                          forwards, -1, ui.view.level.flag_layers);
    if (cell) ui.view.show_on_map(*cell);
  };
}

SearchedLayers other_layers(SearchedLayers layers) {
  return layers == SearchedLayers::all ? SearchedLayers::chosen : SearchedLayers::all;
}

bool has_chosen_flag(const Session& session, const Ui&) { return session.choices().flag_overlay.has_value(); }

CommandRun switch_flag(int flag) {
  return [flag](const Session& session, Actions& actions, Ui& ui) {
    ui.ask(request::ShowTab(panel_id::kFlags));
    emit_edit(actions, toggle_flag(session.level(), session.choices().area, flag));
  };
}

CommandTest is_flag_set(int flag) {
  return [flag](const Session& session, const Ui&) {
    return flag_lamp(session.level(), session.choices().area, flag) == FlagLamp::all;
  };
}

// For a flag in a field, opens the menu of the field.
CommandRun open_flag_menu(int flag) {
  return [flag](const Session& session, Actions&, Ui& ui) {
    const FlagField* field = field_of_flag(session.level().flag_fields, flag);
    ui.ask(request::ShowTab(panel_id::kFlags));
    ui.ask(request::FocusField("flags/menu" + std::to_string(field != nullptr ? field->first : flag)));
  };
}

CommandRun tint_flag(int flag) {
  return [flag](const Session& session, Actions& actions, Ui&) {
    const FlagPattern pattern = pattern_of_flag(flag);
    const bool on = session.choices().flag_overlay == pattern;
    actions.push_back(action::SetFlagOverlay{on ? std::optional<FlagPattern>() : pattern});
  };
}

CommandTest is_flag_tinted(int flag) {
  return [flag](const Session& session, const Ui&) {
    return session.choices().flag_overlay == pattern_of_flag(flag);
  };
}

// Whether the flag has a lamp.
CommandTest is_flag_shown(int flag) {
  return [flag](const Session& session, const Ui&) { return flag < shown_flags(session.level()); };
}

std::vector<Command> commands_of_flag(int flag) {
  const std::string number = std::to_string(flag);
  return {
      {.id = "flags/switch" + number,
       .label = "Switch flag " + number,
       .help = "Sets the flag in the selected tiles, or clears it if any of them has it.",
       .run = switch_flag(flag),
       .enabled = is_flag_shown(flag),
       .checked = is_flag_set(flag),
       .words = "set clear toggle bit lamp property"},
      {.id = "flags/name" + number,
       .label = "Name flag " + number + "...",
       .help = "Opens its menu: its name, its role in the physics, its shape and its field.",
       .run = open_flag_menu(flag),
       .words = "rename role shape bit field lamp"},
      {.id = "flags/tint" + number,
       .label = "Tint flag " + number,
       .help = "Tints the cells and the tiles of the sheet that have it.",
       .run = tint_flag(flag),
       .enabled = is_flag_shown(flag),
       .checked = is_flag_tinted(flag),
       .words = "show colour bit map overlay"},
  };
}

std::vector<Command> commands_of_each_flag() {
  std::vector<Command> all;
  for (int flag = 0; flag < kMaxFlags; ++flag) all = joined({all, commands_of_flag(flag)});
  return all;
}

std::vector<Command> commands_of_all_flags() {
  return {
      {.id = "flags/brush",
       .label = "Paint flags",
       .help =
           "The left button paints the tinted flag: on the sheet, and on the map, where it changes the tile "
           "in all its cells. A drag that begins where the flag is set clears it; one over the map that "
           "begins on a drawn tile leaves out blank ones. Escape cancels the drag.",
       .key = ctrl_shift('f'),
       .menu = menus::kEditFlags,
       .run = toggle_brush,
       .checked = [](const Session& session,
                     const Ui&) { return session.choices().map_tool == MapTool::flag; }},
      {.id = "flags/find",
       .label = "Find flags",
       .help = "Lists the tiles that have a flag, and their cells.",
       .key = alt('g'),
       .menu = menus::kEditFlags,
       .run = [](const Session&, Actions&, Ui& ui) { ui.ask(request::ShowTab(panel_id::kFlagSearch)); }},
      {.id = "flags/next",
       .label = "Next cell with the flag",
       .help = "Shows the next cell of the map with a tile that has the tinted flag, in any layer.",
       .key = ctrl('g'),
       .menu = menus::kEditFlags,
       .run = go_to_flagged(true),
       .enabled = has_chosen_flag,
       .repeats = true},
      {.id = "flags/previous",
       .label = "Previous cell with the flag",
       .help = "Shows the previous cell of the map with a tile that has the tinted flag, in any layer.",
       .key = ctrl_shift('g'),
       .menu = menus::kEditFlags,
       .run = go_to_flagged(false),
       .enabled = has_chosen_flag,
       .repeats = true},
      {.id = "flags/chosen_layer",
       .label = "Find flags in the chosen layer alone",
       .help = "Counts and finds cells with the tinted flag in the chosen layer alone; else in all layers.",
       .run = [](const Session&, Actions&,
                 Ui& ui) { ui.view.level.flag_layers = other_layers(ui.view.level.flag_layers); },
       .enabled = [](const Session& session, const Ui&) { return session.level().layers.count() > 1; },
       .checked = [](const Session&,
                     const Ui& ui) { return ui.view.level.flag_layers == SearchedLayers::chosen; },
       .words = "search layers"},
      {.id = "flags/type_byte",
       .label = "Type the flags as a number...",
       .help = "Goes to the field of all flags, as hexadecimal digits; Enter sets them.",
       .run = go_to_field(panel_id::kFlags, "flags/byte"),
       .words = "hex bits byte lamps"},
  };
}

}  // namespace

std::vector<Command> flag_commands() { return joined({commands_of_all_flags(), commands_of_each_flag()}); }

}  // namespace talus
