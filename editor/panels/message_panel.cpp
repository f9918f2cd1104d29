// A strip over the bottom of the canvas.
#include "message_panel.h"

namespace talus {

void MessagePanel::draw(const Session& session, Actions& actions, Ui& ui) {
  if (!session.message()) return;
  const Message message = *session.message();
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({window.x / 2, window.y - ui.px(72)}, ImGuiCond_Always, {0.5f, 1});
  ImGui::SetNextWindowSizeConstraints({ui.px(240), 0}, {window.x - ui.px(32), window.y / 2});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, theme::tone(message.is_error ? theme::kErrorNote : theme::kNote));
  ImGui::PushStyleColor(ImGuiCol_Border, theme::tone(message.is_error ? theme::kError : theme::kAccent));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::Begin("message", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
  if (ui.icon_button("message/dismiss", Icon::close, false, "Dismisses the message.", {}))
    actions.push_back(action::DismissMessage{});
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::PushTextWrapPos(window.x - ui.px(64));
  ImGui::TextUnformatted(message.text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::End();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(2);
}

}  // namespace talus
