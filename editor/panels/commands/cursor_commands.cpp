// The commands of the keyboard's cursor. While it is shown, their keys come before all others.
#include "command_table.h"
#include "panels/tiles/edited_shape.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;
using Stride = KeyCursor::Stride;

// In the shape editor, an unfinished polygon comes first.
void show_or_draw(S session, A actions, U ui) {
  View& view = ui.view;
  const bool at_shape = view.window.focus == Focus::shape || view.canvas.cursor.is_on("shape");
  if (at_shape && edited_shape(session, view).is_drawing &&
      (view.canvas.cursor.is_on("shape") || !view.shape.drawing->empty()))
    return close_drawing(session, actions, view);
  if (view.canvas.cursor.on()) return view.canvas.cursor.toggle_pen();
  if (view.window.focus == Focus::sprites) return view.canvas.cursor.go_to({"pixels"});
  if (at_shape) return view.canvas.cursor.go_to({"shape"});
  if (view.canvas.mode == CanvasMode::two_maps && view.canvas.second_map)
    return view.canvas.cursor.go_to({"second_map"});
  view.canvas.cursor.go_to({"map", "play"});
}

void end_cursor(S, A, U ui) {
  if (ui.view.canvas.cursor.pen_down())
    ui.view.canvas.cursor.lift();
  else
    ui.view.canvas.cursor.hide();
}

CommandRun move_cursor(int dx, int dy, Stride stride) {
  return [dx, dy, stride](S, A, U ui) { ui.view.canvas.cursor.move({dx, dy}, stride); };
}

CommandRun press_button(int button) {
  return [button](S, A, U ui) { ui.view.canvas.cursor.press(button); };
}

// Returns the four commands of the arrow keys. id "cursor/far_" and label "Cursor far " get "left" and so on
// added.
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
       .help = "Acts as the left button at the cursor until the key is released; Ctrl, Shift and Alt work as "
               "with the mouse.",
       .key = KeyChord{' '},
       .run = press_button(KeyCursor::kLeft),
       .any_modifiers = true},
      {.id = "cursor/press_right",
       .label = "Press the right button",
       .help = "Acts as the right button at the cursor until the key is released.",
       .key = KeyChord{kKeyBackspace},
       .run = press_button(KeyCursor::kRight),
       .any_modifiers = true},
      {.id = "cursor/next",
       .label = "To the next canvas",
       .help = "Moves the cursor to the next canvas: map, play view, sheet, pixels or shape.",
       .key = ctrl(kKeyTab),
       .run = [](S, A, U ui) { ui.view.canvas.cursor.go_to_next(); }},
      {.id = "cursor/end",
       .label = "Lift the pen, or hide the cursor",
       .help = "Lifts the pen and cancels its drag; then hides the cursor, so that the arrows move the view "
               "or the selection again. A move of the mouse hides it, too.",
       .key = KeyChord{kKeyEscape},
       .run = end_cursor},
  };
}

}  // namespace

std::vector<Command> cursor_commands() {
  std::vector<Command> all = {{.id = "view/cursor",
                               .label = "Keyboard's cursor, pen down and up",
                               .help =
                                   "Shows a cursor on the map or the pixels. The arrows move it, and "
                                   "Space acts as the left button. While it is shown, this puts the pen "
                                   "down, which holds that button, or lifts it: one hand can draw. In the "
                                   "shape editor it closes an unfinished polygon.",
                               .key = KeyChord{kKeyEnter},
                               .menu = menus::kViewFocus,
                               .run = show_or_draw,
                               .checked = [](S, const Ui& ui) { return ui.view.canvas.cursor.on(); },
                               .any_modifiers = true}};
  const std::vector<Command> own = in_scope(
      Scope::cursor,
      joined({arrows("cursor/", "Cursor ", Stride::cell, alone,
                     "Moves the cursor to the next cell or pixel; the view follows."),
              arrows("cursor/far_", "Cursor far ", Stride::far, shift,
                     "Moves the cursor by eight cells or pixels."),
              arrows("cursor/px_", "Cursor 1 px ", Stride::unit, ctrl_shift,
                     "Moves the cursor by one px of the level, to place bodies and the ends of lines."),
              cursor_keys()}));
  return joined({all, own});
}

}  // namespace talus
