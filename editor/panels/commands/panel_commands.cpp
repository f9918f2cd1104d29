// The commands that show tabs, and that give the keys to parts of a panel or a menu.
#include "command_table.h"
#include "panels/ui/dialog.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;

CommandRun give_keys_to_panel(std::string_view panel, PanelIn place = PanelIn::window) {
  return [panel, place](S, A, U ui) {
    if (place == PanelIn::debugger) ui.view.window.dock_open = true;
    ui.ask(request::ShowTab(panel));
    ui.ask(request::FocusPanel(panel));
  };
}

std::vector<Command> tab_commands() {
  return {
      {.id = "tabs/flags",
       .label = "Tab: Flags",
       .help = "The lamps of the selected tiles; the arrows go from one to the next.",
       .run = give_keys_to_panel(panel_id::kFlags),
       .words = "bits lamps properties role field"},
      {.id = "tabs/color",
       .label = "Tab: Colour",
       .help = "The chosen colour's red, green and blue.",
       .run = give_keys_to_panel(panel_id::kColor),
       .words = "color palette rgb sliders"},
      {.id = "tabs/inspector",
       .label = "Tab: Inspector",
       .help = "The chosen body's or curve's numbers, and its contacts.",
       .run = give_keys_to_panel(panel_id::kInspector),
       .words = "body spawn object properties contacts position velocity curve"},
      {.id = "tabs/why",
       .label = "Tab: Why",
       .help = "The stages of the chosen body's step.",
       .run = give_keys_to_panel(panel_id::kWhy),
       .words = "explain reason stage"},
      {.id = "tabs/shape",
       .label = "Tab: Shape",
       .help = "The selected tile's shape as ground.",
       .run = give_keys_to_panel(panel_id::kShape),
       .words = "slope profile collision heights one-way ceiling"},
      {.id = "tabs/tile",
       .label = "Tab: Tile",
       .help = "The selected tile's class, probability, properties and animation.",
       .run = give_keys_to_panel(panel_id::kTile),
       .words = "data custom properties class type probability weight animation frames"},
      {.id = "tabs/tuning",
       .label = "Tab: Tuning",
       .help = "The solver and its numbers.",
       .run = give_keys_to_panel(panel_id::kTuning),
       .words = "physics gravity friction speed solver settings"},
      {.id = "tabs/brushes",
       .label = "Tab: Brushes",
       .help = "The named brushes and the ground's tiles.",
       .run = give_keys_to_panel(panel_id::kBrushes),
       .words = "stamps auto-tile ground pattern"},
      {.id = "tabs/problems",
       .label = "Tab: Problems",
       .help = "What is likely wrong in the level.",
       .run = give_keys_to_panel(panel_id::kProblems),
       .words = "lint warnings errors seams check"},
      {.id = "tabs/history",
       .label = "Tab: History",
       .help = "All changes; Enter goes back to one.",
       .run = give_keys_to_panel(panel_id::kHistory),
       .words = "undo steps changes"},
      {.id = "tabs/flag_search",
       .label = "Tab: Find",
       .help = "The tiles that have a flag.",
       .run = give_keys_to_panel(panel_id::kFlagSearch),
       .words = "search tiles bits"},
      {.id = "tabs/layers",
       .label = "Tab: Layers",
       .help = "The layers of the map, and how they look.",
       .run = give_keys_to_panel(panel_id::kLayers),
       .words = "tile layers front back parallax opacity"},
      {.id = "tabs/input_roll",
       .label = "Tab: Input",
       .help = "The keys and the mouse of every frame.",
       .run = give_keys_to_panel(panel_id::kInputRoll, PanelIn::debugger),
       .words = "recording roll keys"},
      {.id = "tabs/plots",
       .label = "Tab: Plots",
       .help = "Expressions as curves over the frames.",
       .run = give_keys_to_panel(panel_id::kPlots, PanelIn::debugger),
       .words = "watch expression graph"},
      {.id = "tabs/breakpoints",
       .label = "Tab: Breakpoints",
       .help = "The conditions at which the game stops.",
       .run = give_keys_to_panel(panel_id::kBreakpoints, PanelIn::debugger),
       .words = "stop condition pause"},
      {.id = "tabs/compare",
       .label = "Tab: Compare",
       .help = "The shown branch beside another one, or beside another solver.",
       .run = give_keys_to_panel(panel_id::kCompare, PanelIn::debugger),
       .words = "difference solver ghosts parting"},
      {.id = "tabs/reach",
       .label = "Tab: Reach",
       .help = "Where the player gets to.",
       .run = give_keys_to_panel(panel_id::kReach, PanelIn::debugger),
       .words = "reachable jump explore"},
  };
}

std::vector<Command> bar_commands() {
  return {
      {.id = "panels/sheet",
       .label = "Keys to the sheet's buttons",
       .help = "The arrows and Tab move over the buttons above the sheet; Esc ends.",
       .run = give_keys_to_panel(panel_id::kSheet),
       .words = "tiles sprites spritesheet"},
      {.id = "panels/pixels",
       .label = "Keys to the pixels' buttons",
       .help = "The arrows and Tab move over the tools and sizes of the pixels; Esc ends.",
       .run = give_keys_to_panel(panel_id::kPixels),
       .words = "toolbar brush canvas size"},
      {.id = "panels/canvas",
       .label = "Keys to the map's buttons",
       .help = "The arrows and Tab move over the buttons above and below the map; Esc ends.",
       .run = give_keys_to_panel(panel_id::kCanvas),
       .words = "toolbar tools overlays"},
      {.id = "panels/transport",
       .label = "Keys to the buttons of play",
       .help = "The arrows and Tab move over the buttons that play, step and go back; Esc ends.",
       .run = give_keys_to_panel(panel_id::kTransport),
       .words = "toolbar transport speed frame"},
      {.id = "view/dismiss",
       .label = "Dismiss the message",
       .help = "Closes the note over the map; Esc does it, too.",
       .run = emit<action::DismissMessage>,
       .enabled = [](S session, const Ui&) { return session.message().has_value(); }},
  };
}

CommandRun open_menu(std::string_view menu) {
  return [menu](S, A, U ui) {
    leave_windows();
    ui.ask(request::FocusField(menu));
  };
}

std::vector<Command> menu_commands() {
  return {
      {.id = "menus/file",
       .label = "Menu: File",
       .help = "Opens the menu, with the recent files and the hard cases; the arrows move in it.",
       .run = open_menu("menu/File"),
       .words = "menu bar recent files hard cases"},
      {.id = "menus/edit",
       .label = "Menu: Edit",
       .help = "Opens the menu; the arrows move in it, Enter runs the chosen row.",
       .run = open_menu("menu/Edit"),
       .words = "menu bar"},
      {.id = "menus/map",
       .label = "Menu: Map",
       .help = "Opens the menu; the arrows move in it, Enter runs the chosen row.",
       .run = open_menu("menu/Map"),
       .words = "menu bar"},
      {.id = "menus/sprites",
       .label = "Menu: Sprites",
       .help = "Opens the menu; the arrows move in it, Enter runs the chosen row.",
       .run = open_menu("menu/Sprites"),
       .words = "menu bar"},
      {.id = "menus/view",
       .label = "Menu: View",
       .help = "Opens the menu, with the overlays and the size of text; the arrows move in it.",
       .run = open_menu("menu/View"),
       .words = "menu bar size of text scale zoom"},
      {.id = "menus/play",
       .label = "Menu: Play",
       .help = "Opens the menu; the arrows move in it, Enter runs the chosen row.",
       .run = open_menu("menu/Play"),
       .words = "menu bar"},
      {.id = "menus/debug",
       .label = "Menu: Debug",
       .help = "Opens the menu; the arrows move in it.",
       .run = open_menu("menu/Debug"),
       .words = "menu bar when the level is edited rule"},
      {.id = "menus/help",
       .label = "Menu: Help",
       .help = "Opens the menu; the arrows move in it, Enter runs the chosen row.",
       .run = open_menu("menu/Help"),
       .words = "menu bar"},
  };
}

}  // namespace

std::vector<Command> panel_commands() { return joined({tab_commands(), bar_commands(), menu_commands()}); }

}  // namespace talus
