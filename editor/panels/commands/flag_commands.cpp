// The commands of the flags: painting them, and finding where they are.
#include <array>

#include "command_table.h"
#include "edit/flag_lamps.h"
#include "edit/flag_tools.h"
#include "level/flag_search.h"
#include "panels/tiles/flag_label.h"

namespace talus {
namespace {

// The flag brush paints what is tinted, so something must be.
void toggle_brush(const Session& session, Actions& actions, Ui&) {
  const bool on = session.choices().map_tool != MapTool::flag;
  actions.push_back(action::SetMapTool{on ? MapTool::flag : MapTool::stamp});
  if (on && !session.choices().flag_overlay)
    actions.push_back(action::SetFlagOverlay{flag_patterns(session.level()).front()});
}

template <bool forwards>
void go_to_flagged(const Session& session, Actions&, Ui& ui) {
  const auto cell =
      find_flagged_cell(session.level(), *session.choices().flag_overlay, ui.view.search_start(), forwards);
  if (!cell) return;
  ui.view.centre_on = ui.view.marked_cell = cell;
  if (ui.view.canvas == CanvasMode::play) ui.view.canvas = CanvasMode::both;
}

bool has_chosen_flag(const Session& session, const Ui&) { return session.choices().flag_overlay.has_value(); }

template <int flag>
void switch_flag(const Session& session, Actions& actions, Ui& ui) {
  ui.view.wants_tab = "flags";
  emit_edit(actions, toggle_flag(session.level(), session.choices().area, flag));
}

template <int flag>
bool is_flag_set(const Session& session, const Ui&) {
  return flag_lamp(session.level(), session.choices().area, flag) == FlagLamp::all;
}

// Of a flag in a field, the field's.
template <int flag>
void open_flag_menu(const Session& session, Actions&, Ui& ui) {
  const FlagField* field = field_of_flag(session.level().flag_fields, flag);
  ui.view.wants_tab = "flags";
  ui.view.wants_text = "flags/menu" + std::to_string(field != nullptr ? field->first : flag);
}

template <int flag>
void tint_flag(const Session& session, Actions& actions, Ui&) {
  const FlagPattern pattern = pattern_of_flag(flag);
  const bool on = session.choices().flag_overlay == pattern;
  actions.push_back(action::SetFlagOverlay{on ? std::optional<FlagPattern>() : pattern});
}

template <int flag>
bool is_flag_tinted(const Session& session, const Ui&) {
  return session.choices().flag_overlay == pattern_of_flag(flag);
}

struct FlagCommandIds {
  std::string_view toggle, toggle_label, name, name_label, tint, tint_label;
};
constexpr std::array<FlagCommandIds, kFlagCount> kFlagCommandIds = {
    {{"flags/switch0", "Switch flag 0", "flags/name0", "Name flag 0...", "flags/tint0", "Tint flag 0"},
     {"flags/switch1", "Switch flag 1", "flags/name1", "Name flag 1...", "flags/tint1", "Tint flag 1"},
     {"flags/switch2", "Switch flag 2", "flags/name2", "Name flag 2...", "flags/tint2", "Tint flag 2"},
     {"flags/switch3", "Switch flag 3", "flags/name3", "Name flag 3...", "flags/tint3", "Tint flag 3"},
     {"flags/switch4", "Switch flag 4", "flags/name4", "Name flag 4...", "flags/tint4", "Tint flag 4"},
     {"flags/switch5", "Switch flag 5", "flags/name5", "Name flag 5...", "flags/tint5", "Tint flag 5"},
     {"flags/switch6", "Switch flag 6", "flags/name6", "Name flag 6...", "flags/tint6", "Tint flag 6"},
     {"flags/switch7", "Switch flag 7", "flags/name7", "Name flag 7...", "flags/tint7", "Tint flag 7"}}};

template <int flag>
std::vector<Command> commands_of_flag() {
  const FlagCommandIds& ids = kFlagCommandIds[flag];
  return {
      also_called("set clear toggle bit lamp property",
                  toggle(ids.toggle, {}, ids.toggle_label,
                         "Sets it in the selected tiles, or clears it where any has it.", switch_flag<flag>,
                         is_flag_set<flag>)),
      also_called("rename role shape bit field lamp",
                  command(ids.name, {}, ids.name_label,
                          "Opens its menu: its name, its role in the physics, its shape and its field.",
                          open_flag_menu<flag>)),
      also_called(
          "show colour bit map overlay",
          toggle(ids.tint, {}, ids.tint_label, "Tints the cells and the tiles of the sheet that have it.",
                 tint_flag<flag>, is_flag_tinted<flag>)),
  };
}

std::vector<Command> commands_of_each_flag() {
  return joined({commands_of_flag<0>(), commands_of_flag<1>(), commands_of_flag<2>(), commands_of_flag<3>(),
                 commands_of_flag<4>(), commands_of_flag<5>(), commands_of_flag<6>(), commands_of_flag<7>()});
}

std::vector<Command> commands_of_all_flags() {
  return {
      toggle(
          "flags/brush", ctrl_shift('f'), "Paint flags",
          "The left button paints the tinted flag: on the sheet, and on the map, where it changes the tile "
          "in all its cells. A drag that begins where the flag is set clears it; one over the map that "
          "begins on a drawn tile leaves out blank ones. Escape takes the drag back.",
          toggle_brush,
          [](const Session& session, const Ui&) { return session.choices().map_tool == MapTool::flag; }),
      command("flags/find", alt('g'), "Find flags", "Lists the tiles that have a flag, and their cells.",
              [](const Session&, Actions&, Ui& ui) { ui.view.wants_tab = "flag_search"; }),
      repeating(command("flags/next", ctrl('g'), "Next cell with the flag",
                        "Shows the next cell of the map whose tile has the tinted flag.", go_to_flagged<true>,
                        has_chosen_flag)),
      repeating(command("flags/previous", ctrl_shift('g'), "Previous cell with the flag",
                        "Shows the cell before whose tile has the tinted flag.", go_to_flagged<false>,
                        has_chosen_flag)),
      also_called("hex bits byte lamps",
                  command("flags/type_byte", {}, "Type the flags as a byte...",
                          "Goes to the field of all eight flags, as two hexadecimal digits; Enter sets them.",
                          [](const Session&, Actions&, Ui& ui) {
                            ui.view.wants_tab = "flags";
                            ui.view.wants_text = "flags/byte";
                          })),
  };
}

}  // namespace

std::vector<Command> flag_commands() { return joined({commands_of_all_flags(), commands_of_each_flag()}); }

}  // namespace talus
