// A strip over the bottom of the canvas.
#include "message_panel.h"

#include <algorithm>

namespace talus {

void MessagePanel::draw(const Session& session, Actions& actions, Ui& ui) {
  if (!session.message()) return;
  const Message message = *session.message();
  // Over the canvas: there it covers no field and no table.
  const ImVec2 min = ui.canvas_min, max = ui.canvas_max;
  const float width = max.x - min.x - ui.px(16);
  ImGui::SetNextWindowPos({(min.x + max.x) / 2, max.y - ui.px(8)}, ImGuiCond_Always, {0.5f, 1});
  ImGui::SetNextWindowSizeConstraints({std::min(ui.px(240), width), 0}, {width, max.y - min.y});
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
  ImGui::PushTextWrapPos(width - ui.px(8));
  ImGui::TextUnformatted(message.text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::End();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(2);
}

}  // namespace talus
