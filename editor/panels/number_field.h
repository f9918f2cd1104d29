// A number to drag or to type, for panels that change the level by it.
#pragma once

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

// Draws it. Whether the value has just been changed. stroke: kept between frames; of the edits of one drag.
bool draw_number_field(const NumberField& field, double& value, const Session& session, int& stroke, Ui& ui);

}  // namespace talus
