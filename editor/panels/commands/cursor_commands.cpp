// The commands of the keyboard's cursor. While it is shown, their keys come before all others.
#include "command_table.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;
using Stride = KeyCursor::Stride;

void show_or_draw(S, A, U ui) {
  View& view = ui.view;
  if (view.cursor.on()) return view.cursor.toggle_pen();
  if (view.focus == Focus::sprites) return view.cursor.go_to({"pixels"});
  if (view.canvas == CanvasMode::two_maps && view.second_map) return view.cursor.go_to({"second_map"});
  view.cursor.go_to({"map", "play"});
}

void end_cursor(S, A, U ui) {
  if (ui.view.cursor.pen_down())
    ui.view.cursor.lift();
  else
    ui.view.cursor.hide();
}

CommandRun move_cursor(int dx, int dy, Stride stride) {
  return [dx, dy, stride](S, A, U ui) { ui.view.cursor.move({dx, dy}, stride); };
}

CommandRun press_button(int button) {
  return [button](S, A, U ui) { ui.view.cursor.press(button); };
}

// The four commands of the arrow keys: "cursor/far_" and "Cursor far " with "left" and so on.
std::vector<Command> arrows(const std::string& id, const std::string& label, Stride stride,
                            KeyChord (*chord)(int), const std::string& help) {
  struct Arrow {
    const char* name;
    int key, dx, dy;
  };
  constexpr Arrow kArrows[] = {
      {"left", kKeyLeft, -1, 0}, {"right", kKeyRight, 1, 0}, {"up", kKeyUp, 0, -1}, {"down", kKeyDown, 0, 1}};
  std::vector<Command> all;
  for (const Arrow& arrow : kArrows)
    all.push_back({.id = id + arrow.name,
                   .label = label + arrow.name,
                   .help = help,
                   .key = chord(arrow.key),
                   .run = move_cursor(arrow.dx, arrow.dy, stride),
                   .repeats = true});
  return all;
}

KeyChord alone(int key) { return KeyChord{key}; }

std::vector<Command> cursor_keys() {
  return {
      {.id = "cursor/press",
       .label = "Press the left button",
       .help = "Does what the left button does there, until the key goes up; with Ctrl, "
               "Shift and Alt as with the mouse.",
       .key = KeyChord{' '},
       .run = press_button(KeyCursor::kLeft),
       .any_modifiers = true},
      {.id = "cursor/press_right",
       .label = "Press the right button",
       .help = "Does what the right button does there, until the key goes up.",
       .key = KeyChord{kKeyBackspace},
       .run = press_button(KeyCursor::kRight),
       .any_modifiers = true},
      {.id = "cursor/next",
       .label = "To the next canvas",
       .help = "Takes it to the next of the map, the play view, the sheet, the pixels and the shape.",
       .key = ctrl(kKeyTab),
       .run = [](S, A, U ui) { ui.view.cursor.go_to_next(); }},
      {.id = "cursor/end",
       .label = "Pen up, or end",
       .help = "Takes the pen up, and its drag back; then gives the arrows back to the view and to what is "
               "selected. So does a move of the mouse.",
       .key = KeyChord{kKeyEscape},
       .run = end_cursor},
  };
}

}  // namespace

std::vector<Command> cursor_commands() {
  std::vector<Command> all = {
      {.id = "view/cursor",
       .label = "Keyboard's cursor, pen down and up",
       .help = "Shows a cursor on the map or the pixels that the arrows move, and where "
               "Space does what the left button "
               "does. While it is shown, takes the pen down, which holds that button, and "
               "up again: so one hand draws.",
       .key = KeyChord{kKeyEnter},
       .menu = menus::kViewFocus,
       .run = show_or_draw,
       .checked = [](S, const Ui& ui) { return ui.view.cursor.on(); },
       .any_modifiers = true}};
  const std::vector<Command> own =
      in_scope(Scope::cursor,
               joined({arrows("cursor/", "Cursor ", Stride::cell, alone,
                              "Goes to the next cell or pixel, and the view with it."),
                       arrows("cursor/far_", "Cursor far ", Stride::far, shift,
                              "Goes over eight cells or pixels at once."),
                       arrows("cursor/px_", "Cursor 1 px ", Stride::unit, ctrl_shift,
                              "Goes a px of the level, for the ends of lines and the places of bodies."),
                       cursor_keys()}));
  return joined({all, own});
}

}  // namespace talus
