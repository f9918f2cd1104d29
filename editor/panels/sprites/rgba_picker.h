// RgbaPicker: chooses the colours of the two buttons among all colours, with opacity.
#pragma once

#include <string>

#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

class RgbaPicker {
 public:
  // name: of its widgets, before "/hex" and others.
  explicit RgbaPicker(std::string name) : name_(std::move(name)) {}
  // Takes that much room, px of the screen. Wide room has the fields beside the picker, else they are above
  // it.
  void draw(const Session& session, Actions& actions, Ui& ui, ImVec2 room);

 private:
  void draw_fields(const Session& session, Actions& actions, Ui& ui, float width);
  void draw_button_choice(const Session& session, Ui& ui, float width);
  void draw_hex(Rgba chosen, Actions& actions, Ui& ui, float width);
  void draw_recent(Actions& actions, Ui& ui, float width);

  std::string name_;
  std::string typed_;         // text of the hexadecimal field
  bool typed_right_ = false;  // whether it belongs to the right button's colour
  bool is_typing_ = false;    // whether the user types in that field
};

}  // namespace talus
