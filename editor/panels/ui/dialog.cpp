// Modals that follow a condition, and their keys.
#include "dialog.h"

#include <imgui_internal.h>

#include <cctype>
#include <utility>

namespace talus {
namespace {

// The focused control; 0: none.
ImGuiID shown_focus() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  return ImGui::GetIO().NavVisible ? context.NavId : 0;
}

bool letter_pressed(char letter, const View& view) {
  const KeyChord chord = view.window.dialog_key;
  if (letter == 0 || chord.ctrl || (ImGui::GetIO().WantTextInput && !chord.alt)) return false;
  return chord.key == std::tolower(static_cast<unsigned char>(letter));
}

// Under the first occurrence of the letter in the label, which is in the middle of ImGui's last item.
void underline(std::string_view label, char letter, bool enabled) {
  const std::size_t at = label.find(letter);
  if (letter == 0 || at == std::string_view::npos) return;
  const char* text = label.data();
  const ImVec2 whole = ImGui::CalcTextSize(text, text + label.size());
  const float before = ImGui::CalcTextSize(text, text + at).x;
  const float width = ImGui::CalcTextSize(text + at, text + at + 1).x;
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  const float x = (min.x + max.x - whole.x) / 2 + before, y = (min.y + max.y + whole.y) / 2;
  ImGui::GetWindowDrawList()->AddRectFilled({x, y - 1}, {x + width, y},
                                            theme::tone(enabled ? theme::kText : theme::kMuted));
}

std::string keys_of_button(const DialogButton& button) {
  std::string keys = button.is_default ? "Enter" : button.is_cancel ? "Esc" : "";
  if (button.letter != 0) keys += (keys.empty() ? "" : ", ") + std::string(1, button.letter);
  return keys;
}

// Whether another dialog has the place of this one, and waits for its answer.
bool is_place_taken(std::string_view title, const Session& session, const Ui& ui) {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  const int level = context.BeginPopupStack.Size;
  if (context.OpenPopupStack.Size <= level) return false;
  const ImGuiWindow* shown = context.OpenPopupStack[level].Window;
  return shown != nullptr && (shown->Flags & ImGuiWindowFlags_Modal) != 0 && shown->Name != title &&
         ui.wants_dialog(shown->Name, session);
}

}  // namespace

bool begin_dialog(const char* title, DialogTest wanted, ImVec2 size, const Session& session, Ui& ui,
                  DialogKeys keys) {
  const bool is_wanted = wanted(session, ui.view);
  ui.add_dialog(title, std::move(wanted));
  if (is_wanted && !ImGui::IsPopupOpen(title) && !is_place_taken(title, session, ui)) ImGui::OpenPopup(title);
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  if (size.x > 0) ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(12), ui.px(12)));
  const ImGuiWindowFlags own =
      ImGuiWindowFlags_NoNavInputs | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
  const ImGuiWindowFlags flags =
      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
      (size.x > 0 ? 0 : ImGuiWindowFlags_AlwaysAutoResize) | (keys == DialogKeys::its_own ? own : 0);
  const bool open = ImGui::BeginPopupModal(title, nullptr, flags);
  ImGui::PopStyleVar();
  if (open && !is_wanted) ImGui::CloseCurrentPopup();
  return open;
}

bool dialog_button(const DialogButton& button, Ui& ui) {
  const bool clicked = ui.text_button(button.widget, button.label, button.is_default, button.help,
                                      keys_of_button(button), button.enabled, button.width);
  if (button.gets_the_keys && button.enabled && ImGui::IsWindowAppearing()) {
    ImGui::SetItemDefaultFocus();
    ImGui::GetCurrentContext()->NavDisableHighlight = false;
  }
  underline(button.label, button.letter, button.enabled);
  const bool by_enter = button.is_default && shown_focus() == 0 && key_pressed(ImGuiKey_Enter);
  const bool by_escape = button.is_cancel && key_pressed(ImGuiKey_Escape);
  return button.enabled && (clicked || by_enter || by_escape || letter_pressed(button.letter, ui.view));
}

bool key_pressed(ImGuiKey key) {
  return !ImGui::IsWindowAppearing() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), false);
}

bool key_repeats(ImGuiKey key) {
  return !ImGui::IsWindowAppearing() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), true);
}

bool floating_window_has_focus() {
  const ImGuiWindow* window = ImGui::GetCurrentContext()->NavWindow;
  if (window == nullptr || !window->WasActive) return false;
  const ImGuiWindow* root = window->RootWindow;
  return std::string_view(root->Name) != kWorkspaceWindow &&
         (root->Flags & ImGuiWindowFlags_NoNavInputs) == 0;
}

void leave_windows() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  if (context.ActiveId == 0 && context.OpenPopupStack.empty() && floating_window_has_focus())
    ImGui::SetWindowFocus(kWorkspaceWindow);
}

}  // namespace talus
