// The dialog that gives commands other keys.
#pragma once

#include <string>

#include "commands.h"
#include "panel.h"

namespace talus {

class KeysPanel : public Panel {
 public:
  std::string_view id() const override { return "keys"; }
  std::string_view title() const override { return "Keys"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_table(Ui& ui);
  void draw_key(const Command& command, std::size_t index, Ui& ui);
  void draw_question(Ui& ui);  // of the key that was pressed, and the buttons below the table
  void take_pressed_key(Ui& ui);

  std::string typed_;        // that names must have
  bool asks_reset_ = false;  // a second click resets all
};

}  // namespace talus
