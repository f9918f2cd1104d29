// Modals that follow a condition.
#include "dialog.h"

namespace talus {

bool begin_dialog(const char* title, bool wanted, ImVec2 size, const Ui& ui) {
  if (wanted && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  if (size.x > 0) ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(12), ui.px(12)));
  const ImGuiWindowFlags flags = ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove |
                                 ImGuiWindowFlags_NoResize |
                                 (size.x > 0 ? 0 : ImGuiWindowFlags_AlwaysAutoResize);
  const bool open = ImGui::BeginPopupModal(title, nullptr, flags);
  ImGui::PopStyleVar();
  if (open && !wanted) ImGui::CloseCurrentPopup();
  return open;
}

bool key_pressed(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), false); }

}  // namespace talus
