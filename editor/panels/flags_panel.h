// The flags of the selected tiles: eight lamps with their names, and which role each has in the physics.
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

  int menu_flag_ = -1;    // whose menu is open; -1: none
  std::string new_name_;  // in the menu
};

}  // namespace talus
