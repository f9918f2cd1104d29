// The commands that work everywhere.
#include <algorithm>

#include "command_table.h"
#include "panels/canvas/play_keys.h"
#include "panels/tiles/flag_label.h"
#include "panels/ui/dialog.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;

template <CanvasMode mode>
void show_canvas(S, A, U ui) {
  ui.view.canvas = mode;
}

template <CanvasMode mode>
bool shows_canvas(S, const Ui& ui) {
  return ui.view.canvas == mode;
}

template <OverlayId id>
void toggle_overlay(S session, A actions, U) {
  actions.push_back(action::SetOverlay{id, !session.choices().overlays.has(id)});
}

template <OverlayId id>
bool has_overlay(S session, const Ui&) {
  return session.choices().overlays.has(id);
}

void cycle_flag_overlay(S session, A actions, U) {
  const std::vector<FlagPattern> patterns = flag_patterns(session.level());
  std::size_t next = 0;
  if (const auto now = session.choices().flag_overlay)
    next = static_cast<std::size_t>(std::find(patterns.begin(), patterns.end(), *now) - patterns.begin()) + 1;
  actions.push_back(action::SetFlagOverlay{next < patterns.size() ? std::optional(patterns[next])
                                                                  : std::optional<FlagPattern>()});
}

template <int direction>
void change_speed(S session, A actions, U) {
  const double now = session.playback().speed;
  actions.push_back(action::SetSpeed{direction > 0 ? now * 2 : now / 2});
}

// For the commands that play: whoever plays means to steer.
template <class T>
void emit_and_steer(S session, A actions, U ui) {
  actions.push_back(T{});
  let_keys_steer(session, ui.view);
}

void run_from_start(S session, A actions, U ui) {
  actions.push_back(action::ResetPlay{});
  emit_and_steer<action::Play>(session, actions, ui);
}

// The keyboard's cursor goes with the keys.
void show_sprites(S, A, U ui) {
  leave_windows();
  ui.view.keys_in_panel = false;
  ui.view.focus = Focus::sprites;
  if (ui.view.cursor.on()) ui.view.cursor.go_to({"pixels"});
}

void show_map(S, A, U ui) {
  leave_windows();
  ui.view.keys_in_panel = false;
  ui.view.focus = Focus::map;
  if (ui.view.canvas == CanvasMode::play) ui.view.canvas = CanvasMode::map;
  if (ui.view.cursor.on()) ui.view.cursor.go_to({"map"});
}

std::vector<Command> file_commands() {
  return {
      command("file/new", ctrl('n'), "New level", "Starts an empty level.", emit<action::NewLevel>),
      command("file/open", ctrl('o'), "Open...", "Opens a level or a TIC-80 cart.",
              [](S, A, U ui) { ui.view.dialog = FileDialog::open; }),
      command("file/save", ctrl('s'), "Save",
              "Saves to the level's own file, in its own format; what a cart cannot hold, in a companion "
              "beside it.",
              emit<action::SaveFile>),
      command("file/save_as", ctrl_shift('s'), "Save as...",
              "Saves under another name; the ending chooses the format.",
              [](S, A, U ui) { ui.view.dialog = FileDialog::save_as; }),
      command("file/quit", ctrl('q'), "Quit", "Ends the program; unsaved changes are asked about.",
              emit<action::Quit>),
      repeating(command("edit/undo", ctrl('z'), "Undo", "Takes back the last change; a stroke is one.",
                        emit<action::Undo>, [](S s, const Ui&) { return s.history().can_undo(); })),
      repeating(also_on(ctrl_shift('z'),
                        command("edit/redo", ctrl('y'), "Redo", "Makes again what Undo took back.",
                                emit<action::Redo>, [](S s, const Ui&) { return s.history().can_redo(); }))),
  };
}

std::vector<Command> view_commands() {
  return {
      toggle("view/sprites", KeyChord{kKeyF2}, "Sprites", "Gives the keys to the sheet and the pixels.",
             show_sprites, [](S, const Ui& ui) { return ui.view.focus == Focus::sprites; }),
      toggle("view/map", KeyChord{kKeyF3}, "Map", "Gives the keys to the map, and shows it.", show_map,
             [](S, const Ui& ui) { return ui.view.focus == Focus::map; }),
      command("view/reset_layout", ctrl('0'), "Reset layout",
              "Puts every panel back to its first size, and shows map and play view.",
              [](S, A, U ui) {
                ui.view.layout = Layout{};
                ui.view.pixels.enlarged = false;
                ui.view.canvas = CanvasMode::both;
              }),
      command("help/commands", ctrl('p'), "Find a command...", "Lists every command; type to find one.",
              [](S, A, U ui) { ui.view.command_palette_open = true; }),
      toggle(
          "help/keys", KeyChord{kKeyF1}, "Keys and mouse", "Shows every key.",
          [](S, A, U ui) { ui.view.help_open = !ui.view.help_open; },
          [](S, const Ui& ui) { return ui.view.help_open; }),
  };
}

std::vector<Command> canvas_commands() {
  return {
      toggle("canvas/map", ctrl('1'), "Show the map", "Shows the map alone.", show_canvas<CanvasMode::map>,
             shows_canvas<CanvasMode::map>),
      toggle("canvas/play", ctrl('2'), "Show the play view", "Shows the play view alone.",
             show_canvas<CanvasMode::play>, shows_canvas<CanvasMode::play>),
      toggle("canvas/both", ctrl('3'), "Show map and play view", "Shows the map above the play view.",
             show_canvas<CanvasMode::both>, shows_canvas<CanvasMode::both>),
      toggle("canvas/two_maps", ctrl('4'), "Show two maps",
             "Shows two places of the map, each with its own zoom.", show_canvas<CanvasMode::two_maps>,
             shows_canvas<CanvasMode::two_maps>),
      also_called("lines cells",
                  toggle(
                      "canvas/grid", KeyChord{'`'}, "Grid", "Shows the borders of the cells.",
                      [](S s, A actions, U) { actions.push_back(action::SetGrid{!s.choices().grid}); },
                      [](S s, const Ui&) { return s.choices().grid; })),
      toggle(
          "canvas/borders", KeyChord{'b'}, "Screen borders",
          "Shows the borders of the screens, every 30 by 17 cells.",
          [](S s, A actions, U) { actions.push_back(action::SetScreenBorders{!s.choices().screen_borders}); },
          [](S s, const Ui&) { return s.choices().screen_borders; }),
      repeating(toggle("canvas/flag_tint", KeyChord{'f'}, "Next flag tint",
                       "Tints the cells whose tile has a flag: the next flag, or none.", cycle_flag_overlay,
                       [](S s, const Ui&) { return s.choices().flag_overlay.has_value(); })),
      toggle(
          "canvas/legend", alt('l'), "Names in the legend",
          "Shows the names of the overlays in the play view's corner, or swatches alone.",
          [](S, A, U ui) { ui.view.debugger.legend_folded = !ui.view.debugger.legend_folded; },
          [](S, const Ui& ui) { return !ui.view.debugger.legend_folded; }),
      toggle(
          "canvas/follow", alt('f'), "Follow the chosen body",
          "Keeps the chosen body in the play view's sight.",
          [](S, A, U ui) { ui.view.debugger.follow_body = !ui.view.debugger.follow_body; },
          [](S, const Ui& ui) { return ui.view.debugger.follow_body; }),
      toggle(
          "canvas/paint_in_play", KeyChord{'p'}, "Paint in the play view",
          "The left button paints in the play view, instead of holding balls.",
          [](S, A, U ui) { ui.view.paint_in_play = !ui.view.paint_in_play; },
          [](S, const Ui& ui) { return ui.view.paint_in_play; }),
  };
}

// In the map alone: in the sprites these keys choose the brush.
std::vector<Command> zoom_commands() {
  return in_scope(Scope::map,
                  {
                      repeating(also_on(shift('='), command("canvas/zoom_in", KeyChord{'='}, "Zoom in",
                                                            "Zooms in; the wheel does it at the mouse.",
                                                            [](S, A, U ui) { ++ui.view.zoom_by; }))),
                      repeating(command("canvas/zoom_out", KeyChord{'-'}, "Zoom out",
                                        "Zooms out; the wheel does it at the mouse.",
                                        [](S, A, U ui) { --ui.view.zoom_by; })),
                      also_called("home reset view zoom level",
                                  command("canvas/fit", alt(kKeyHome), "Fit the first screen",
                                          "Shows the level as when it was opened: its first screen, as large "
                                          "as there is room for.",
                                          [](S, A, U ui) { ui.view.fit_first_screen = true; })),
                  });
}

std::vector<Command> play_commands() {
  return {
      also_called(
          "start stop simulate",
          toggle("play/toggle", KeyChord{kKeyF5}, "Play or pause",
                 "Runs the simulation, or stops it where it is. A player runs with Left and Right, and jumps "
                 "with Up, Space or Z.",
                 emit_and_steer<action::TogglePlay>, [](S s, const Ui&) { return s.playback().running; })),
      repeating(command("play/step", KeyChord{kKeyF10}, "Step one frame",
                        "Pauses and makes exactly one step, with the players' keys that are held.",
                        emit_and_steer<action::StepFrame>)),
      command("play/run", ctrl('r'), "Run from the start", "Goes back to frame 0 and runs.", run_from_start),
      also_called(
          "restart",
          command(
              "play/reset", shift(kKeyHome), "New run from frame 0",
              "Puts every body back where the level has it, for a new run; the one before stays as a branch.",
              emit<action::ResetPlay>)),
      repeating(command("play/slower", KeyChord{','}, "Slower", "Halves the speed, down to 1/8.",
                        change_speed<-1>, [](S s, const Ui&) { return s.playback().speed > 0.125; })),
      repeating(command("play/faster", KeyChord{'.'}, "Faster", "Doubles the speed, up to 8.",
                        change_speed<1>, [](S s, const Ui&) { return s.playback().speed < 8; })),
      command(
          "play/no_body", ctrl_shift('d'), "Choose no body", "Empties the inspector.",
          [](S, A actions, U) { actions.push_back(action::SelectBody{0}); },
          [](S s, const Ui&) { return s.choices().body != 0; }),
  };
}

template <OverlayId id>
Command overlay_command(std::string_view command_id) {
  const OverlayInfo& info = overlay_infos()[static_cast<std::size_t>(id)];
  constexpr int kNumber = static_cast<int>(id), kDigits = 9;
  const KeyChord key = kNumber < kDigits ? alt('1' + kNumber) : alt_shift('1' + kNumber - kDigits);
  return toggle(command_id, key, info.label, info.help, toggle_overlay<id>, has_overlay<id>);
}

std::vector<Command> overlay_commands() {
  return {
      overlay_command<OverlayId::boxes>("overlay/boxes"),
      overlay_command<OverlayId::normals>("overlay/normals"),
      overlay_command<OverlayId::touch_points>("overlay/touch_points"),
      overlay_command<OverlayId::velocity>("overlay/velocity"),
      overlay_command<OverlayId::slope_delta>("overlay/slope_delta"),
      overlay_command<OverlayId::floor_height>("overlay/floor_height"),
      overlay_command<OverlayId::tested_tiles>("overlay/tested_tiles"),
      overlay_command<OverlayId::answer>("overlay/answer"),
      overlay_command<OverlayId::outline>("overlay/outline"),
      overlay_command<OverlayId::removed_edges>("overlay/removed_edges"),
      overlay_command<OverlayId::one_way>("overlay/one_way"),
      overlay_command<OverlayId::swept_path>("overlay/swept_path"),
      overlay_command<OverlayId::trails>("overlay/trails"),
      overlay_command<OverlayId::penetration>("overlay/penetration"),
      overlay_command<OverlayId::shapes>("overlay/shapes"),
      overlay_command<OverlayId::reach>("overlay/reach"),
  };
}

}  // namespace

std::vector<Command> general_commands() {
  return joined({file_commands(), view_commands(), canvas_commands(), zoom_commands(), play_commands(),
                 overlay_commands()});
}

}  // namespace talus
