// The commands of the flags: painting them, and finding where they are.
#include "command_table.h"
#include "flag_label.h"
#include "level/flag_search.h"

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
      find_flagged_cell(session.level(), *session.choices().flag_overlay, ui.view.marked_cell, forwards);
  if (!cell) return;
  ui.view.centre_on = ui.view.marked_cell = cell;
  if (ui.view.canvas == CanvasMode::play) ui.view.canvas = CanvasMode::both;
}

bool has_chosen_flag(const Session& session, const Ui&) { return session.choices().flag_overlay.has_value(); }

}  // namespace

std::vector<Command> flag_commands() {
  return {
      toggle(
          "flags/brush", ctrl_shift('f'), "Paint flags",
          "The left button paints the tinted flag: on the sheet, and on the map, where it changes the tile "
          "in all its cells. A drag that begins where the flag is set clears it.",
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
  };
}

}  // namespace talus
