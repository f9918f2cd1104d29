// The choice of what the program starts with, for the settings and the welcome page.
#pragma once

#include "panels/ui/ui.h"

namespace talus {

// widget: the name of the list. width: px of the screen.
void draw_start_choice(const std::string& widget, float width, Ui& ui);

}  // namespace talus
