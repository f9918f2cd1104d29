// The window of keys, made from the table of commands.
#include "help_panel.h"

#include <string>
#include <vector>

#include "panels/commands/commands.h"
#include "panels/ui/floating_window.h"

namespace talus {
namespace {

struct MouseHelp {
  std::string what;
  std::string how;
};

std::vector<MouseHelp> mouse_help(const Ui& ui) {
  const auto keys = [&](CommandId id) { return keys_of(id, ui); };
  const bool middle_picks = ui.view.preferences.middle_picks;
  return {
      {"left button on the map", "the chosen tool"},
      {"middle button on the map", middle_picks ? "picks the tiles of a dragged rectangle as the stamp"
                                                : "drags the view; a click picks the tile as the stamp"},
      {"Shift over the map", "shows the tile sheet there, to choose a stamp"},
      {"right button, or Space and left", "drags the view; Space does not while a player uses it"},
      {"wheel on the map, play view or sheet", "zooms at the mouse"},
      {"left button on a ball in the play view", "chooses it and holds it"},
      {"left button on the overlays' legend", "folds its names away, or shows them again"},
      {"wheel on the timeline or a plot", "zooms at the mouse; the middle button drags"},
      {"left and right button on the pixels", "draw with their two colours"},
      {"middle button on the pixels",
       middle_picks ? "picks the colour"
                    : "drags pixels that do not all have room; a click picks the colour"},
      {"wheel on the pixels", "a canvas of 8, 16, 32 or 64 px; up shows the tile at the mouse"},
      {"left button on a polygon's points or inside", "drags a point, or all of it; Alt does not snap"},
      {"left button on a side of a polygon", "inserts a point, which can be dragged on"},
      {"right button on a point of a polygon", "removes it"},
      {"mouse over the sprites or the map", "gives them the keys; so do a click, " +
                                                keys("view/sprites"_command) + " and " +
                                                keys("view/map"_command)},
      {"drag on the sheet", "selects tiles: the canvas, the flags and the stamp follow"},
      {"middle button on the sheet, or Space and left", "drags the sheet"},
      {"drag with Paint flags, on the sheet or the map",
       "sets the tinted flag, or clears it where the first tile has it"},
      {"without a mouse: " + keys("view/cursor"_command) + " on the map, the pixels or a shape",
       "shows a cursor for the arrows; see below"},
      {"a file dropped on the window", "is opened"},
  };
}

// Three columns: keys, what they do, and details.
bool begin_help_table(const char* id, Ui& ui) {
  if (!ImGui::BeginTable(id, 3, ImGuiTableFlags_RowBg)) return false;
  ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, ui.px(150));
  ImGui::TableSetupColumn("command", ImGuiTableColumnFlags_WidthFixed, ui.px(170));
  ImGui::TableSetupColumn("help", ImGuiTableColumnFlags_WidthStretch);
  return true;
}

void draw_help_row(std::string_view keys, std::string_view does, std::string_view help, Ui& ui) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushStyleColor(ImGuiCol_Text, theme::tone(theme::kAccent));
  draw_text(keys);
  ImGui::PopStyleColor();
  ImGui::TableNextColumn();
  draw_text(does);
  ImGui::TableNextColumn();
  ui.hint(help);
}

void draw_scope(Scope scope, Ui& ui) {
  ImGui::Spacing();
  std::string title(scope_label(scope));
  if (scope != Scope::everywhere) title += " (" + keys_of(focus_command(scope), ui) + ")";
  ui.heading(title);
  if (!begin_help_table(scope_label(scope).data(), ui)) return;
  for (const Command& command : commands()) {
    if (command.scope != scope) continue;
    draw_help_row(keys_of(command, ui), command.label, command.help, ui);
  }
  ImGui::EndTable();
}

void draw_mouse(Ui& ui) {
  ui.heading("The mouse");
  if (!ImGui::BeginTable("mouse", 2, ImGuiTableFlags_RowBg)) return;
  ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthFixed, ui.px(324));
  ImGui::TableSetupColumn("how", ImGuiTableColumnFlags_WidthStretch);
  for (const MouseHelp& row : mouse_help(ui)) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    draw_text(row.what);
    ImGui::TableNextColumn();
    ui.hint(row.how);
  }
  ImGui::EndTable();
}

void draw_control_keys(Ui& ui) {
  ImGui::Spacing();
  ui.heading("In dialogs, menus, windows such as the settings, and tabs that the command palette went to");
  if (!begin_help_table("controls", ui)) return;
  draw_help_row("Arrows, Tab, Shift+Tab", "To the next control",
                "The control gets a frame. In a list only the arrows move.", ui);
  draw_help_row("Space, Enter", "Press it", "Enter also presses the highlighted answer of a dialog.", ui);
  draw_help_row("Underlined letters", "Press a button", "While a text is typed, with Alt.", ui);
  draw_help_row(
      "Esc", "Cancel, close, end",
      "An open dialog or menu first; then a message about an error, or the mark of a found cell; then "
      "the selection.",
      ui);
  ImGui::EndTable();
}

}  // namespace

void HelpPanel::draw(const Session&, Actions&, Ui& ui) {
  if (!ui.view.window.help_open) return;
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  if (begin_floating_window({.title = "Keys and mouse",
                             .open = &ui.view.window.help_open,
                             .size = {std::min(ui.px(880), window.x - ui.px(64)), window.y - ui.px(96)}})) {
    draw_mouse(ui);
    draw_control_keys(ui);
    for (Scope scope : {Scope::play, Scope::everywhere, Scope::cursor, Scope::map, Scope::sprites,
                        Scope::shape, Scope::input})
      draw_scope(scope, ui);
    ui.place("help/window", ImGui::GetWindowPos(),
             {ImGui::GetWindowPos().x + ImGui::GetWindowWidth(),
              ImGui::GetWindowPos().y + ImGui::GetWindowHeight()});
  }
  ImGui::End();
}

}  // namespace talus
