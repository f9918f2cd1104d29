// The commands that show the tabs, and give the keys to what is in a panel or a menu.
#include "command_table.h"
#include "panels/ui/dialog.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;

// Where a panel is: beside the map, where it is always shown, or among those of the debugger.
enum class PanelIn { window, debugger };

template <const std::string_view& panel, PanelIn place>
void give_keys_to_panel(S, A, U ui) {
  if (place == PanelIn::debugger) ui.view.dock_open = true;
  ui.view.wants_tab = ui.view.wants_keys = panel;
}

template <const std::string_view& panel, PanelIn place = PanelIn::window>
Command panel_command(std::string_view id, std::string_view label, std::string_view help,
                      std::string_view words) {
  return also_called(words, command(id, {}, label, help, give_keys_to_panel<panel, place>));
}

// Ids of panels.
constexpr std::string_view kFlagsPanel = "flags", kColorPanel = "color", kInspectorPanel = "inspector",
                           kWhyPanel = "why", kShapePanel = "shape", kTuningPanel = "tuning",
                           kBrushesPanel = "brushes", kProblemsPanel = "problems", kHistoryPanel = "history",
                           kFlagSearchPanel = "flag_search", kInputRollPanel = "input_roll",
                           kWatchPanel = "watch", kStopsPanel = "stops", kComparePanel = "compare",
                           kReachPanel = "reach", kSheetPanel = "sheet", kPixelsPanel = "pixels",
                           kCanvasPanel = "canvas", kTransportPanel = "transport";
constexpr PanelIn kInDebugger = PanelIn::debugger;

std::vector<Command> tab_commands() {
  return {
      panel_command<kFlagsPanel>("tabs/flags", "Tab: Flags",
                                 "The lamps of the selected tiles; the arrows go from one to the next.",
                                 "bits lamps properties role field"),
      panel_command<kColorPanel>("tabs/color", "Tab: Colour", "The chosen colour's red, green and blue.",
                                 "color palette rgb sliders"),
      panel_command<kInspectorPanel>("tabs/inspector", "Tab: Inspector",
                                     "The chosen body's or curve's numbers, and its contacts.",
                                     "body spawn object properties contacts position velocity curve"),
      panel_command<kWhyPanel>("tabs/why", "Tab: Why", "The stages of the chosen body's step.",
                               "explain reason stage"),
      panel_command<kShapePanel>("tabs/shape", "Tab: Shape", "The ground that the selected tile is.",
                                 "slope profile collision heights one-way ceiling"),
      panel_command<kTuningPanel>("tabs/tuning", "Tab: Tuning", "The solver and its numbers.",
                                  "physics gravity friction speed solver settings"),
      panel_command<kBrushesPanel>("tabs/brushes", "Tab: Brushes",
                                   "The named brushes and the ground's tiles.",
                                   "stamps auto-tile ground pattern"),
      panel_command<kProblemsPanel>("tabs/problems", "Tab: Problems", "What the level has that may be wrong.",
                                    "lint warnings errors seams check"),
      panel_command<kHistoryPanel>("tabs/history", "Tab: History", "All changes; Enter goes back to one.",
                                   "undo steps changes"),
      panel_command<kFlagSearchPanel>("tabs/flag_search", "Tab: Find flags", "The tiles that have a flag.",
                                      "search tiles bits"),
      panel_command<kInputRollPanel, kInDebugger>(
          "tabs/input_roll", "Tab: Input", "The keys and the mouse of every frame.", "recording roll keys"),
      panel_command<kWatchPanel, kInDebugger>(
          "tabs/watch", "Tab: Plots", "Expressions as curves over the frames.", "watch expression graph"),
      panel_command<kStopsPanel, kInDebugger>("tabs/stops", "Tab: Breakpoints", "What a run stops at.",
                                              "stop condition pause"),
      panel_command<kComparePanel, kInDebugger>("tabs/compare", "Tab: Compare", "The run beside another one.",
                                                "difference solver ghosts parting"),
      panel_command<kReachPanel, kInDebugger>("tabs/reach", "Tab: Reach", "Where the player gets to.",
                                              "reachable jump explore"),
  };
}

std::vector<Command> bar_commands() {
  return {
      panel_command<kSheetPanel>("panels/sheet", "Keys to the sheet's buttons",
                                 "The arrows and Tab go over what is above the sheet; Esc ends.",
                                 "tiles sprites spritesheet"),
      panel_command<kPixelsPanel>("panels/pixels", "Keys to the pixels' buttons",
                                  "The arrows and Tab go over the tools and sizes of the pixels; Esc ends.",
                                  "toolbar brush canvas size"),
      panel_command<kCanvasPanel>("panels/canvas", "Keys to the map's buttons",
                                  "The arrows and Tab go over what is above and below the map; Esc ends.",
                                  "toolbar tools overlays"),
      panel_command<kTransportPanel>("panels/transport", "Keys to the buttons of play",
                                     "The arrows and Tab go over what plays, steps and goes back; Esc ends.",
                                     "toolbar transport speed frame"),
      command("view/dismiss", {}, "Dismiss the message", "Closes the note over the map; Esc does it, too.",
              emit<action::DismissMessage>,
              [](S session, const Ui&) { return session.message().has_value(); }),
  };
}

template <const std::string_view& menu>
void open_menu(S, A, U ui) {
  leave_windows();
  ui.view.wants_text = menu;
}

template <const std::string_view& menu>
Command menu_command(std::string_view id, std::string_view label) {
  return also_called("menu bar",
                     command(id, {}, label, "Opens it; the arrows go through it, Enter takes what is chosen.",
                             open_menu<menu>));
}

// Widgets of menus.
constexpr std::string_view kFileMenu = "menu/File", kEditMenu = "menu/Edit", kMapMenu = "menu/Map",
                           kSpritesMenu = "menu/Sprites", kViewMenu = "menu/View", kPlayMenu = "menu/Play",
                           kDebugMenu = "menu/Debug", kHelpMenu = "menu/Help";

std::vector<Command> menu_commands() {
  return {
      also_called("menu bar recent files hard cases",
                  command("menus/file", {}, "Menu: File",
                          "Opens it, with the recent files and the hard cases; the arrows go through it.",
                          open_menu<kFileMenu>)),
      menu_command<kEditMenu>("menus/edit", "Menu: Edit"),
      menu_command<kMapMenu>("menus/map", "Menu: Map"),
      menu_command<kSpritesMenu>("menus/sprites", "Menu: Sprites"),
      also_called("menu bar size of text scale zoom",
                  command("menus/view", {}, "Menu: View",
                          "Opens it, with the overlays and the size of text; the arrows go through it.",
                          open_menu<kViewMenu>)),
      menu_command<kPlayMenu>("menus/play", "Menu: Play"),
      also_called("menu bar when the level is edited rule",
                  command("menus/debug", {}, "Menu: Debug", "Opens it; the arrows go through it.",
                          open_menu<kDebugMenu>)),
      menu_command<kHelpMenu>("menus/help", "Menu: Help"),
  };
}

}  // namespace

std::vector<Command> panel_commands() { return joined({tab_commands(), bar_commands(), menu_commands()}); }

}  // namespace talus
