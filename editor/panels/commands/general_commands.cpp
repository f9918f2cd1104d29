// The commands that work everywhere.
#include <algorithm>

#include "command_table.h"
#include "panels/canvas/opening_area.h"
#include "panels/canvas/play_keys.h"
#include "panels/layout_presets.h"
#include "panels/tiles/edited_shape.h"
#include "panels/tiles/flag_label.h"
#include "panels/ui/dialog.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;

CommandRun show_canvas(CanvasMode mode) {
  return [mode](S, A, U ui) { ui.view.canvas.mode = mode; };
}

CommandTest shows_canvas(CanvasMode mode) {
  return [mode](S, const Ui& ui) { return ui.view.canvas.mode == mode; };
}

CommandRun toggle_overlay(const Overlay& overlay) {
  return [&overlay](S session, A actions, U) {
    actions.push_back(action::SetOverlay{&overlay, !session.choices().overlays.has(overlay)});
  };
}

CommandTest has_overlay(const Overlay& overlay) {
  return [&overlay](S session, const Ui&) { return session.choices().overlays.has(overlay); };
}

void cycle_flag_overlay(S session, A actions, U) {
  const std::vector<FlagPattern> patterns = flag_patterns(session.level());
  std::size_t next = 0;
  if (const auto now = session.choices().flag_overlay)
    next = static_cast<std::size_t>(std::find(patterns.begin(), patterns.end(), *now) - patterns.begin()) + 1;
  actions.push_back(action::SetFlagOverlay{next < patterns.size() ? std::optional(patterns[next])
                                                                  : std::optional<FlagPattern>()});
}

CommandRun change_speed(int direction) {
  return [direction](S session, A actions, U) {
    const double now = session.playback().speed;
    actions.push_back(action::SetSpeed{direction > 0 ? now * 2 : now / 2});
  };
}

// For commands that start playing: the user then wants to steer, so the players get the keys.
template <class T>
void emit_and_steer(S session, A actions, U ui) {
  actions.push_back(T{});
  let_keys_steer(session, ui.view);
}

void run_from_start(S session, A actions, U ui) {
  actions.push_back(action::ResetPlay{});
  emit_and_steer<action::Play>(session, actions, ui);
}

// The keyboard's cursor moves with the focus.
void show_sprites(S, A, U ui) {
  show_left_column(ui.view.window);
  leave_windows();
  ui.view.window.keys_in_panel = false;
  ui.view.window.focus = Focus::sprites;
  if (ui.view.canvas.cursor.on()) ui.view.canvas.cursor.go_to({"pixels"});
}

void show_map(S, A, U ui) {
  leave_windows();
  ui.view.window.keys_in_panel = false;
  ui.view.window.focus = Focus::map;
  if (ui.view.canvas.mode == CanvasMode::play) ui.view.canvas.mode = CanvasMode::map;
  if (ui.view.canvas.cursor.on()) ui.view.canvas.cursor.go_to({"map"});
}

// A drawn polygon that is not in the level yet comes first, where it is drawn.
void undo(S session, A actions, U ui) {
  if (ui.view.window.focus == Focus::shape && take_back_unfinished(session, ui.view)) return;
  if (session.history().can_undo()) actions.push_back(action::Undo{});
}
bool can_undo(S session, const Ui& ui) {
  const EditedShape edited = edited_shape(session, ui.view);
  const bool is_unfinished = edited.is_drawing || edited.is_draft;
  return session.history().can_undo() || (ui.view.window.focus == Focus::shape && is_unfinished);
}

// A tour that was left goes on in the open level.
void take_tour(S, A actions, U ui) {
  TourView& tour = ui.view.tour;
  if (tour.open) {
    tour.open = false;
    return;
  }
  ui.view.window.welcome_open = false;
  if (tour.step > 0) {
    tour.open = true;
    return;
  }
  tour.opens_after = ui.view.canvas.level_number;
  actions.push_back(action::OpenFile{ui.view.files.tour_level, true});
}

// A tool takes the play view from the hand, but not beside the map: there the same key gives it back.
void choose_hand(S, A, U ui) {
  CanvasesView& canvas = ui.view.canvas;
  canvas.paint_in_play = canvas.mode == CanvasMode::both && !canvas.paint_in_play;
}

std::vector<Command> file_commands() {
  return {
      {.id = "file/new_sized",
       .label = "New level...",
       .help = "Asks for the size of the tiles and of the map, and whether there are ground and a player.",
       .key = ctrl('n'),
       .menu = menus::kFileOpen,
       .run = [](S, A, U ui) { ui.view.level.new_level_open = true; }},
      {.id = "file/new",
       .label = "New empty level",
       .help = "Starts an empty level with blank tiles of 8x8 px and 16 colours.",
       .menu = menus::kFileOpen,
       .run = emit<action::NewLevel>},
      {.id = "file/new_from_tiles",
       .label = "New level from tiles...",
       .help = "Cuts a PNG into tiles, and starts an empty level with them.",
       .menu = menus::kFileOpen,
       .run = [](S, A, U ui) { ui.ask(request::ShowFileDialog{FileDialog::new_from_tiles}); },
       .words = "tileset png picture"},
      {.id = "file/open",
       .label = "Open...",
       .help = "Opens a level or a TIC-80 cart.",
       .key = ctrl('o'),
       .menu = menus::kFileOpen,
       .run = [](S, A, U ui) { ui.ask(request::ShowFileDialog{FileDialog::open}); }},
      {.id = "file/next_map",
       .label = "Next map",
       .help = "Opens the next map of those that were dropped or opened together, or of the file's folder.",
       .key = ctrl(kKeyPageDown),
       .menu = menus::kFileOpen,
       .run = [](S, A actions, U) { actions.push_back(action::OpenNextMap{}); },
       .words = "folder following level"},
      {.id = "file/previous_map",
       .label = "Previous map",
       .help = "Opens the map before: see Next map.",
       .key = ctrl(kKeyPageUp),
       .menu = menus::kFileOpen,
       .run = [](S, A actions, U) { actions.push_back(action::OpenNextMap{-1}); },
       .words = "folder level before"},
      {.id = "file/save",
       .label = "Save",
       .help = "Saves to the level's own file, in its own format; what a cart cannot hold, in a companion "
               "beside it.",
       .key = ctrl('s'),
       .menu = menus::kFileSave,
       .run = emit<action::SaveFile>},
      {.id = "file/save_as",
       .label = "Save as...",
       .help = "Saves under another name; the ending chooses the format.",
       .key = ctrl_shift('s'),
       .menu = menus::kFileSave,
       .run = [](S, A, U ui) { ui.ask(request::ShowFileDialog{FileDialog::save_as}); }},
      {.id = "file/ldtk_mapping",
       .label = "LDtk mapping...",
       .help = "Chooses what values, tags and entities of the level's LDtk project stand for.",
       .menu = menus::kFilePrograms,
       .run = emit<action::AskLdtkMapping>,
       .enabled = [](S session,
                     const Ui&) { return session.level().ldtk != nullptr && !session.path().empty(); },
       .words = "intgrid enum entity import"},
      {.id = "file/quit",
       .label = "Quit",
       .help = "Ends the program; unsaved changes are asked about.",
       .key = ctrl('q'),
       .menu = menus::kFileQuit,
       .run = emit<action::Quit>},
      {.id = "edit/undo",
       .label = "Undo",
       .help = "Takes back the last change; a stroke is one change.",
       .key = ctrl('z'),
       .menu = menus::kEditUndo,
       .run = undo,
       .enabled = can_undo,
       .repeats = true},
      {.id = "edit/redo",
       .label = "Redo",
       .help = "Repeats the change that Undo took back.",
       .key = ctrl('y'),
       .other_key = ctrl_shift('z'),
       .menu = menus::kEditUndo,
       .run = emit<action::Redo>,
       .enabled = [](S s, const Ui&) { return s.history().can_redo(); },
       .repeats = true},
  };
}

std::vector<Command> view_commands() {
  return {
      {.id = "view/sprites",
       .label = "Sprites",
       .help = "Gives the keys to the sheet and the pixels.",
       .key = KeyChord{kKeyF2},
       .menu = menus::kViewFocus,
       .run = show_sprites,
       .checked = [](S, const Ui& ui) { return ui.view.window.focus == Focus::sprites; }},
      {.id = "view/map",
       .label = "Map",
       .help = "Gives the keys to the map, and shows it.",
       .key = KeyChord{kKeyF3},
       .menu = menus::kViewFocus,
       .run = show_map,
       .checked = [](S, const Ui& ui) { return ui.view.window.focus == Focus::map; }},
      {.id = "view/reset_layout",
       .label = "Reset layout",
       .help = "Puts every panel back to its first place and size, and shows the level in one canvas.",
       .key = ctrl('0'),
       .menu = menus::kViewLayouts,
       .run =
           [](S, A, U ui) {
             ui.view.window.layout = Layout{};
             ui.view.window.moved_tabs.clear();
             ui.view.sprites.pixels.enlarged = false;
             show_layout(layout_presets().front(), ui.view);
           }},
      {.id = "help/welcome",
       .label = "Welcome page",
       .help = "Shows recent levels, new ones, and examples that move.",
       .menu = menus::kHelp,
       .run = toggle<&View::window, &WindowView::welcome_open>,
       .checked = is_on<&View::window, &WindowView::welcome_open>,
       .words = "start recent examples gallery home"},
      {.id = "help/tour",
       .label = "Tour",
       .help = "Shows in eight steps what Talus does, on a copy of the meadow; or goes on with the step "
               "at which it was left.",
       .menu = menus::kHelp,
       .run = take_tour,
       .checked = is_on<&View::tour, &TourView::open>,
       .words = "start learn tutorial introduction first steps"},
      {.id = "help/keys",
       .label = "Keys and mouse",
       .help = "Shows every key.",
       .key = KeyChord{kKeyF1},
       .menu = menus::kHelp,
       .run = toggle<&View::window, &WindowView::help_open>,
       .checked = is_on<&View::window, &WindowView::help_open>},
      {.id = "help/commands",
       .label = "Find a command...",
       .help = "Lists every command; type to find one.",
       .key = ctrl('p'),
       .menu = menus::kHelp,
       .run = [](S, A, U ui) { ui.view.commands.palette_open = true; }},
  };
}

std::vector<Command> canvas_commands() {
  return {
      {.id = "canvas/map",
       .label = "Show the map",
       .help = "Shows only the map, as it is drawn.",
       .key = ctrl('1'),
       .menu = menus::kViewCanvases,
       .run = show_canvas(CanvasMode::map),
       .checked = shows_canvas(CanvasMode::map)},
      {.id = "canvas/play",
       .label = "Show the level",
       .help =
           "Shows the level as it plays. The hand holds bodies; the other tools paint, also while it plays.",
       .key = ctrl('2'),
       .menu = menus::kViewCanvases,
       .run = show_canvas(CanvasMode::play),
       .checked = shows_canvas(CanvasMode::play)},
      {.id = "canvas/both",
       .label = "Show map and play view",
       .help = "Shows the map beside the play view, or above it where the window is narrow.",
       .key = ctrl('3'),
       .menu = menus::kViewCanvases,
       .run = show_canvas(CanvasMode::both),
       .checked = shows_canvas(CanvasMode::both)},
      {.id = "canvas/two_maps",
       .label = "Show two maps",
       .help = "Shows two places of the map, each with its own zoom.",
       .key = ctrl('4'),
       .menu = menus::kViewCanvases,
       .run = show_canvas(CanvasMode::two_maps),
       .checked = shows_canvas(CanvasMode::two_maps)},
      {.id = "canvas/grid",
       .label = "Grid",
       .help = "Shows the borders of the cells.",
       .key = KeyChord{'`'},
       .menu = menus::kViewMarks,
       .icon = Icon::grid,
       .run = [](S s, A actions, U) { actions.push_back(action::SetGrid{!s.choices().grid}); },
       .checked = [](S s, const Ui&) { return s.choices().grid; },
       .words = "lines cells"},
      {.id = "canvas/borders",
       .label = "Screen borders",
       .help = "Shows the border of the map, and with tiles of 8x8 px those of the screens, every 30 by 17 "
               "cells.",
       .key = KeyChord{'b'},
       .menu = menus::kViewMarks,
       .icon = Icon::borders,
       .run = [](S s, A actions,
                 U) { actions.push_back(action::SetScreenBorders{!s.choices().screen_borders}); },
       .checked = [](S s, const Ui&) { return s.choices().screen_borders; }},
      {.id = "canvas/flag_tint",
       .label = "Next flag tint",
       .help = "Tints the cells whose tile has the next flag; after the last flag, no cells.",
       .key = KeyChord{'f'},
       .menu = menus::kViewMarks,
       .run = cycle_flag_overlay,
       .checked = [](S s, const Ui&) { return s.choices().flag_overlay.has_value(); },
       .repeats = true},
      {.id = "canvas/legend",
       .label = "Names in the legend",
       .help = "Shows the names of the overlays in the play view's corner, or swatches alone.",
       .key = alt('l'),
       .menu = menus::kPlayOverlays,
       .run = toggle<&View::canvas, &CanvasesView::legend_folded>,
       .checked = [](S, const Ui& ui) { return !ui.view.canvas.legend_folded; }},
      {.id = "canvas/labels",
       .label = "Labels of every body",
       .help =
           "Lets the overlays label every body. Else they label the chosen one and the one under the mouse.",
       .menu = menus::kPlayOverlays,
       .run = toggle<&View::canvas, &CanvasesView::labels_all>,
       .checked = is_on<&View::canvas, &CanvasesView::labels_all>,
       .words = "numbers text"},
      {.id = "canvas/follow",
       .label = "Follow the player",
       .help = "Lets the play view go with the chosen body, or else with the player. Moving the view by hand "
               "lets go.",
       .key = alt('f'),
       .menu = menus::kPlayBody,
       .icon = Icon::follow,
       .run = toggle<&View::canvas, &CanvasesView::follow_body>,
       .checked = is_on<&View::canvas, &CanvasesView::follow_body>,
       .words = "chosen body camera scroll"},
      {.id = "canvas/paint_in_play",
       .label = "Hand",
       .help = "Chooses, holds and throws bodies in the play view. Else the chosen tool works there.",
       .key = KeyChord{'p'},
       .menu = menus::kPlayBody,
       .icon = Icon::hand,
       .run = choose_hand,
       .checked = [](S, const Ui& ui) { return !ui.view.canvas.paint_in_play; },
       .words = "paint in the play view pointer arrow grab"},
  };
}

// These keys zoom in the map alone: in the sprites they choose the brush.
std::vector<Command> zoom_commands() {
  return in_scope(Scope::map,
                  {
                      {.id = "canvas/zoom_in",
                       .label = "Zoom in",
                       .help = "Zooms in; the wheel zooms at the mouse.",
                       .key = KeyChord{'='},
                       .other_key = shift('='),
                       .menu = menus::kViewZoom,
                       .icon = Icon::zoom_in,
                       .run = [](S, A, U ui) { ui.ask(request::Zoom{1}); },
                       .repeats = true},
                      {.id = "canvas/zoom_out",
                       .label = "Zoom out",
                       .help = "Zooms out; the wheel zooms at the mouse.",
                       .key = KeyChord{'-'},
                       .menu = menus::kViewZoom,
                       .icon = Icon::zoom_out,
                       .run = [](S, A, U ui) { ui.ask(request::Zoom{-1}); },
                       .repeats = true},
                      {.id = "canvas/fit",
                       .label = "Show the player",
                       .help = "Shows the player, as when the level was opened; of a level without one, its "
                               "bodies, or its ground.",
                       .key = alt(kKeyHome),
                       .run = [](S, A, U ui) { ui.ask(request::ShowOpening{}); },
                       .words = "fit first screen home reset view zoom level bodies"},
                  });
}

std::vector<Command> play_commands() {
  return {
      {.id = "play/toggle",
       .label = "Play or pause",
       .help = "Runs the simulation, or pauses it. While it runs, players have the keys that run and jump.",
       .key = KeyChord{kKeyF5},
       .menu = menus::kPlayRun,
       .icon = Icon::play,
       .checked_icon = Icon::pause,
       .run = emit_and_steer<action::TogglePlay>,
       .checked = [](S s, const Ui&) { return s.playback().running; },
       .words = "start stop simulate"},
      {.id = "play/step",
       .label = "Step one frame",
       .help = "Pauses and makes exactly one step, with the players' keys that are held.",
       .key = KeyChord{kKeyF10},
       .menu = menus::kPlayRun,
       .icon = Icon::step,
       .run = emit_and_steer<action::StepFrame>,
       .repeats = true},
      {.id = "play/run",
       .label = "Run from the start",
       .help = "Goes back to frame 0 and runs.",
       .key = ctrl('r'),
       .menu = menus::kPlayRun,
       .run = run_from_start},
      {.id = "play/reset",
       .label = "New branch from frame 0",
       .help = "Puts every body back where the level has it, in a new branch; the one before stays.",
       .key = shift(kKeyHome),
       .menu = menus::kPlayRun,
       .icon = Icon::restart,
       .run = emit<action::ResetPlay>,
       .words = "restart"},
      {.id = "play/slower",
       .label = "Slower",
       .help = "Halves the speed, down to 1/8.",
       .key = KeyChord{','},
       .menu = menus::kPlaySpeed,
       .run = change_speed(-1),
       .enabled = [](S s, const Ui&) { return s.playback().speed > 0.125; },
       .repeats = true},
      {.id = "play/faster",
       .label = "Faster",
       .help = "Doubles the speed, up to 8.",
       .key = KeyChord{'.'},
       .menu = menus::kPlaySpeed,
       .run = change_speed(1),
       .enabled = [](S s, const Ui&) { return s.playback().speed < 8; },
       .repeats = true},
      {.id = "play/choose_player",
       .label = "Choose the player",
       .help = "Chooses the body that the keys steer: the inspector and Why are about it then.",
       .key = ctrl_shift('p'),
       .menu = menus::kPlayBody,
       .run = [](S session, A actions,
                 U) { actions.push_back(action::SelectBody{followed_body(session.state(), 0)->id}); },
       .enabled = [](S session, const Ui&) { return followed_body(session.state(), 0) != nullptr; },
       .words = "select body hero inspect"},
      {.id = "play/no_body",
       .label = "Choose no body",
       .help = "Empties the inspector.",
       .key = ctrl_shift('d'),
       .menu = menus::kPlayBody,
       .run = [](S, A actions, U) { actions.push_back(action::SelectBody{0}); },
       .enabled = [](S s, const Ui&) { return s.choices().body != 0; }},
  };
}

OverlaySet set_of(const OverlayPreset& preset) {
  OverlaySet set;
  for (const Overlay* overlay : preset.overlays) set.set(*overlay, true);
  return set;
}

std::vector<Command> overlay_commands() {
  std::vector<Command> all;
  for (const Overlay* overlay : all_overlays()) {
    all.push_back({.id = "overlay/" + std::string(overlay->key),
                   .label = std::string(overlay->label),
                   .help = std::string(overlay->help),
                   .key = overlay->digit == 0 ? KeyChord{}
                          : overlay->shift    ? alt_shift(overlay->digit)
                                              : alt(overlay->digit),
                   .menu = menus::kPlayOverlays,
                   .run = toggle_overlay(*overlay),
                   .checked = has_overlay(*overlay)});
  }
  for (const OverlayPreset& preset : overlay_presets()) {
    all.push_back({.id = "overlays/" + std::string(preset.key),
                   .label = std::string(preset.label),
                   .help = std::string(preset.help),
                   .menu = menus::kPlayOverlays,
                   .run =
                       [set = set_of(preset)](S, A actions, U) {
                         for (const Overlay* overlay : all_overlays())
                           actions.push_back(action::SetOverlay{overlay, set.has(*overlay)});
                       },
                   .checked = [set = set_of(preset)](S s, const Ui&) { return s.choices().overlays == set; },
                   .words = "preset overlays show hide"});
  }
  return all;
}

}  // namespace

std::vector<Command> general_commands() {
  return joined({file_commands(), view_commands(), canvas_commands(), zoom_commands(), play_commands(),
                 overlay_commands()});
}

}  // namespace talus
