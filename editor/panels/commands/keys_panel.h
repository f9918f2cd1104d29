// The dialog that gives commands other keys.
#pragma once

#include <string>
#include <vector>

#include "commands.h"
#include "panels/panel.h"

namespace talus {

class KeysPanel : public Panel {
 public:
  std::string_view id() const override { return "keys"; }
  std::string_view title() const override { return "Keys"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void choose_by_keys(Ui& ui);
  void draw_table(Ui& ui);
  void draw_row(int row, Ui& ui);
  void draw_key(int row, std::size_t index, Ui& ui);
  void draw_question(Ui& ui);  // asks about the pressed key, or says what can be done
  void draw_taken_question(const Command& command, const Command* other, Ui& ui);
  void take_pressed_key(Ui& ui);
  void end_capture(Ui& ui);

  std::string typed_;                   // the text that names must contain
  std::vector<const Command*> listed_;  // the commands whose names contain it
  int row_ = 0;                         // the chosen row of the listed commands
  std::size_t column_ = 0;              // the chosen column: 0 the key, 1 the second key
  bool moved_ = false;                  // the choice has moved: scroll to it
  bool asks_for_taken_ = false;         // it asked already in the frame before, so that Enter is an answer
  bool wants_text_ = false;             // the text field gets the keys back
  bool asks_reset_ = false;             // the next click resets all keys
};

}  // namespace talus
