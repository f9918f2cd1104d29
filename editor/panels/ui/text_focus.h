// Lets a command focus a text field that its panel draws later.
#pragma once

#include "ui.h"

namespace talus {

// Call it before the field of this name is drawn.
inline void take_text_focus(std::string_view name, Ui& ui) {
  if (ui.view.requests.take<request::FocusField>(name)) ImGui::SetKeyboardFocusHere();
}

}  // namespace talus
