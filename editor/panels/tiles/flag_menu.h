// The menu of a flag or a field of flags: names, role and shape, and the flags of the field.
#pragma once

#include <string>

#include "panels/ui/number_field.h"
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

class FlagMenu {
 public:
  // Shown from the next draw() on. `at_x`: px of the screen.
  void open_flag(const Level& level, int flag, float at_x);
  void open_field(int first_flag, float at_x);  // the field that begins there
  void draw(const Session& session, Actions& actions, Ui& ui);

 private:
  void show_flag(const Level& level, int flag);
  void show_field(int first_flag);
  void draw_flag(const Session& session, Actions& actions, Ui& ui);
  void draw_role(const Level& level, Actions& actions, Ui& ui) const;
  void draw_shape_of_flag(const Session& session, Actions& actions, Ui& ui);
  void draw_shape_of_tile(const Session& session, Actions& actions, Ui& ui) const;
  void draw_place_in_field(const Level& level, Actions& actions, Ui& ui);
  void draw_field(const Session& session, Actions& actions, Ui& ui, std::size_t index);
  void draw_bits(const Level& level, Actions& actions, Ui& ui, std::size_t index) const;
  void draw_values(const Session& session, Actions& actions, Ui& ui, std::size_t index);
  void draw_flags_of_field(const Level& level, Ui& ui, const FlagField& field);

  int flag_ = 0;  // the flag of the menu; for a field its first flag
  bool is_field_ = false;
  float x_ = 0;              // px of the screen, its left side
  bool opens_ = false;       // at the next draw()
  bool wants_keys_ = false;  // the name gets the focus, as the menu shows another one
  std::string new_name_;     // of the flag
  NumberEdit shape_edit_;    // for the numbers of a shape
  int text_stroke_ = 0;      // for what is typed about a field
};

}  // namespace talus
