// Modal dialogs that open and close by a condition of the caller, so the two cannot disagree.
#pragma once

#include "ui.h"

namespace talus {

// How keys work in dialogs: arrows and Tab move between controls and highlight them; Space and Enter press
// the highlighted one.
enum class DialogKeys { from_control_to_control, its_own };

// Begins the modal in the middle of the window while `wanted` holds. ImGui::EndPopup() must follow if it
// returns true. size: px; {0,0} fits the content. Call this in every frame, also while the dialog is closed:
// `wanted` is asked again after the frame's actions, see Ui::wanted_dialogs(). Of several wanted dialogs, one
// is shown until it is answered, and then the next one.
bool begin_dialog(const char* title, DialogTest wanted, ImVec2 size, const Session& session, Ui& ui,
                  DialogKeys keys = DialogKeys::from_control_to_control);

struct DialogButton {
  std::string_view widget;
  std::string_view label;
  std::string_view help;
  // Of the label, underlined: this key presses the button, with Alt while a text is typed; 0: no letter.
  char letter = 0;
  bool is_default = false;  // highlighted: Enter presses it, unless another control has the focus
  bool is_cancel = false;   // Escape presses it
  bool enabled = true;
  float width = 0;  // px of the screen; 0 fits the text
  // Gets the focus when the dialog opens; for dialogs that do not begin with a text.
  bool gets_the_keys = false;
};
// Whether the mouse or a key pressed it.
bool dialog_button(const DialogButton& button, Ui& ui);

// Whether the key went down in this frame. Never true in a dialog's first frame: the key that opened it, such
// as the Enter that chose a command, does not answer it.
bool key_pressed(ImGuiKey key);
// The same, but also true when a held key repeats.
bool key_repeats(ImGuiKey key);

// The name of the window that holds everything except dialogs, menus and floating windows.
inline constexpr const char* kWorkspaceWindow = "workspace";
// Whether a floating window, such as the settings, was used last, and so has the arrows, Tab, Space and
// Enter.
bool floating_window_has_focus();
// Takes the keys from it, unless the user is typing or dragging there.
void leave_windows();

}  // namespace talus
