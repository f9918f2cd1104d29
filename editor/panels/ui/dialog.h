// Modal dialogs: opened and closed by a condition of the caller's, so that nothing can get out of step.
#pragma once

#include "ui.h"

namespace talus {

// How a dialog goes with the keys: the arrows and Tab go from control to control, and show it; Space and
// Enter press the one that has the keys.
enum class DialogKeys { from_control_to_control, its_own };

// Begins the modal in the middle of the window while `wanted` holds; ImGui::EndPopup() must follow when it
// returns true. size: px, {0,0} fits the content.
bool begin_dialog(const char* title, bool wanted, ImVec2 size, const Ui& ui,
                  DialogKeys keys = DialogKeys::from_control_to_control);

struct DialogButton {
  std::string_view widget;
  std::string_view label;
  std::string_view help;
  char letter = 0;          // of the label, underlined: this key presses it, in a text with Alt; 0: none
  bool is_default = false;  // highlighted: Enter presses it, unless another control has the keys
  bool is_cancel = false;   // Escape presses it
  bool enabled = true;
  float width = 0;             // px of the screen; 0 fits the text
  bool gets_the_keys = false;  // when the dialog opens; for dialogs that do not begin with a text
};
// Whether it was pressed by the mouse or a key.
bool dialog_button(const DialogButton& button, Ui& ui);

// Whether the key went down in this frame. In a dialog's first frame nothing did: what opened it, such as the
// Enter that chose a command, is no answer to it.
bool key_pressed(ImGuiKey key);
// The same, or whether it is held down and counts again.
bool key_repeats(ImGuiKey key);

// The name of the window that everything is in but dialogs, menus and what floats.
inline constexpr const char* kWorkspaceWindow = "workspace";
// Whether a window that floats, such as the settings, was used last, and so has the arrows, Tab, Space and
// Enter.
bool floating_window_has_focus();
// Takes them from it, unless something is being typed or dragged there.
void leave_windows();

}  // namespace talus
