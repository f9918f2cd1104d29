// A number to drag or to type, for panels that change the level.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "session/session.h"
#include "ui.h"

namespace talus {

struct NumberField {
  std::string_view name;  // of the widget
  const char* format;     // for printf, with one %g: "x %.8g"
  std::string_view help;
  float width = 84;                     // px at scale 1
  float speed = 1;                      // change for each px of the mouse
  std::optional<double> standard = {};  // its menu, by the right button, can go back to this
};

// The state that a panel keeps between frames for all of its fields.
struct NumberEdit {
  int stroke = 0;               // the edits of one drag
  std::optional<double> typed;  // used when the typing ends
};

// Draws the field. Returns whether the value has just changed; it may be infinite if the user types that
// much.
bool draw_number_field(const NumberField& field, double& value, const Session& session, NumberEdit& edit,
                       Ui& ui);

// The menu of the item before, by the right button: copies the number, or goes back to its standard. Its rows
// are registered as name + "_copy" and name + "_reset". Returns whether it shall get the standard.
bool draw_number_menu(const std::string& name, double value, std::optional<double> standard, Ui& ui);

}  // namespace talus
