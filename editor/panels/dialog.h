// Modal dialogs: opened and closed by a condition of the caller's, so that nothing can get out of step.
#pragma once

#include "ui.h"

namespace talus {

// Begins the modal in the middle of the window while `wanted` holds; ImGui::EndPopup() must follow when it
// returns true. size: px, {0,0} fits the content.
bool begin_dialog(const char* title, bool wanted, ImVec2 size, const Ui& ui);

// Whether the key went down in this frame.
bool key_pressed(ImGuiKey key);

}  // namespace talus
