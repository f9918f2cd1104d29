// CommandRow: a toolbar that never breaks into a second row.
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "commands.h"

namespace talus {

// Buttons with icons, one after the other on the current line. Those that are folded, and those for which
// the window has no room, are in a menu behind a button at the end.
class CommandRow {
 public:
  // name: prefix of the menu's button: "canvas" has "canvas/more".
  CommandRow(std::string name, Ui& ui);

  // Leaves some room before the next button.
  void add_gap() { gap_ = kGroupGap; }
  // Commands that belong together: all have room, or all are in the menu.
  void add(std::initializer_list<CommandId> ids, const Session& session, Actions& actions);
  // Puts a command into the menu.
  void fold(CommandId id) { folded_.push_back(id); }
  // Must follow the last button. draw_last: draws one more control, `width` px of the screen wide, at the end
  // of the row or in the menu.
  void end(const Session& session, Actions& actions, const std::function<void()>& draw_last, float width);

 private:
  static constexpr float kGroupGap = 8;  // px at scale 1

  // Whether a control fits with the menu's button after it.
  bool takes(float width);

  std::string name_;
  Ui& ui_;
  float gap_ = 0;                  // px at scale 1, before the next button
  float end_;                      // px of the screen: the right side of the window
  std::vector<CommandId> folded_;  // those in the menu that fold() put there
  std::vector<CommandId> hidden_;  // those in the menu that have no room
};

}  // namespace talus
