// The rows of the settings about gamepads.
#pragma once

#include "panels/ui/ui.h"

namespace talus {

// names, width: px of the screen, of the names of the rows and of what is beside them.
void draw_gamepad_settings(float names, float width, Ui& ui);

}  // namespace talus
