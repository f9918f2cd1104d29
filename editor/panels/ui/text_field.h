// A text in a row of a form, for panels that change the level.
#pragma once

#include <string>
#include <string_view>

#include "ui.h"

namespace talus {

struct TextField {
  std::string_view label;  // in the left column of the form
  std::string_view name;   // of the widget
  std::string_view hint;   // shown while there is no text
  std::string_view help;
};

// Draws the field, within Ui::begin_row(). typed: what is in it; it follows `now`, the text of the level,
// while nobody types. Returns whether the typing has just ended with another text.
bool draw_text_field(const TextField& field, std::string& typed, const std::string& now, Ui& ui);

}  // namespace talus
