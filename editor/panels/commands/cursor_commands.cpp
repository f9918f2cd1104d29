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

template <int dx, int dy, Stride stride>
void move_cursor(S, A, U ui) {
  ui.view.cursor.move({dx, dy}, stride);
}

template <int button>
void press_button(S, A, U ui) {
  ui.view.cursor.press(button);
}

template <Stride stride>
std::vector<Command> arrows(const std::string_view (&ids)[4], const std::string_view (&labels)[4],
                            KeyChord (*chord)(int), std::string_view help) {
  return {
      repeating(command(ids[0], chord(kKeyLeft), labels[0], help, move_cursor<-1, 0, stride>)),
      repeating(command(ids[1], chord(kKeyRight), labels[1], help, move_cursor<1, 0, stride>)),
      repeating(command(ids[2], chord(kKeyUp), labels[2], help, move_cursor<0, -1, stride>)),
      repeating(command(ids[3], chord(kKeyDown), labels[3], help, move_cursor<0, 1, stride>)),
  };
}

KeyChord alone(int key) { return KeyChord{key}; }

Command with_any_modifiers(Command command) {
  command.any_modifiers = true;
  return command;
}

std::vector<Command> cursor_keys() {
  return {
      with_any_modifiers(command("cursor/press", KeyChord{' '}, "Press the left button",
                                 "Does what the left button does there, until the key goes up; with Ctrl, "
                                 "Shift and Alt as with the mouse.",
                                 press_button<KeyCursor::kLeft>)),
      with_any_modifiers(command("cursor/press_right", KeyChord{kKeyBackspace}, "Press the right button",
                                 "Does what the right button does there, until the key goes up.",
                                 press_button<KeyCursor::kRight>)),
      command("cursor/next", ctrl(kKeyTab), "To the next canvas",
              "Takes it to the next of the map, the play view, the sheet, the pixels and the shape.",
              [](S, A, U ui) { ui.view.cursor.go_to_next(); }),
      command("cursor/end", KeyChord{kKeyEscape}, "Pen up, or end",
              "Takes the pen up, and its drag back; then gives the arrows back to the view and to what is "
              "selected. So does a move of the mouse.",
              end_cursor),
  };
}

}  // namespace

std::vector<Command> cursor_commands() {
  std::vector<Command> all = {
      with_any_modifiers(toggle("view/cursor", KeyChord{kKeyEnter}, "Keyboard's cursor, pen down and up",
                                "Shows a cursor on the map or the pixels that the arrows move, and where "
                                "Space does what the left button "
                                "does. While it is shown, takes the pen down, which holds that button, and "
                                "up again: so one hand draws.",
                                show_or_draw, [](S, const Ui& ui) { return ui.view.cursor.on(); }))};
  const std::vector<Command> own = in_scope(
      Scope::cursor,
      joined({arrows<Stride::cell>({"cursor/left", "cursor/right", "cursor/up", "cursor/down"},
                                   {"Cursor left", "Cursor right", "Cursor up", "Cursor down"}, alone,
                                   "Goes to the next cell or pixel, and the view with it."),
              arrows<Stride::far>({"cursor/far_left", "cursor/far_right", "cursor/far_up", "cursor/far_down"},
                                  {"Cursor far left", "Cursor far right", "Cursor far up", "Cursor far down"},
                                  shift, "Goes over eight cells or pixels at once."),
              arrows<Stride::unit>(
                  {"cursor/px_left", "cursor/px_right", "cursor/px_up", "cursor/px_down"},
                  {"Cursor 1 px left", "Cursor 1 px right", "Cursor 1 px up", "Cursor 1 px down"}, ctrl_shift,
                  "Goes a px of the level, for the ends of lines and the places of bodies."),
              cursor_keys()}));
  return joined({all, own});
}

}  // namespace talus
