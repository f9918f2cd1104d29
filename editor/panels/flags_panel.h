// The flags of the selected tiles: eight lamps with their names, and which role or shape each has in the
// physics.
#pragma once

#include <string>

#include "panel.h"

namespace talus {

class FlagsPanel : public Panel {
 public:
  std::string_view id() const override { return "flags"; }
  std::string_view title() const override { return "Flags"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_lamp(const Session& session, Actions& actions, Ui& ui, int flag, float width);
  void draw_menu(const Session& session, Actions& actions, Ui& ui, int flag);
  void draw_flag_shape(const Session& session, Actions& actions, Ui& ui, int flag);

  int menu_flag_ = -1;    // whose menu is open; -1: none
  float menu_x_ = 0;      // px of the screen, its left side
  std::string new_name_;  // in the menu
  int shape_stroke_ = 0;  // of the drag of a shape's number; 0: none
};

}  // namespace talus
