// A number to drag or to type, for panels that change the level by it.
#pragma once

#include <optional>
#include <string_view>

#include "session/session.h"
#include "ui.h"

namespace talus {

struct NumberField {
  std::string_view name;  // of the widget
  const char* format;     // as printf has it, with one %g: "x %.8g"
  std::string_view help;
  float width = 84;  // px at scale 1
  float speed = 1;   // how much it changes for each px of the mouse
};

// What a panel keeps between frames for all of its fields.
struct NumberEdit {
  int stroke = 0;               // of the edits of one drag
  std::optional<double> typed;  // not taken before the typing ends
};

// Draws it. Whether the value has just been changed; to an infinite one where so much is typed.
bool draw_number_field(const NumberField& field, double& value, const Session& session, NumberEdit& edit,
                       Ui& ui);

}  // namespace talus
