// The bar below the canvas.
#include "transport_panel.h"

#include <string>

#include "branch_choice.h"
#include "panels/canvas/overlay_switches.h"
#include "panels/commands/commands.h"
#include "panels/ui/text_focus.h"

namespace talus {
namespace {

constexpr float kFrameWidth = 60;  // px at scale 1

std::string speed_text(double speed) {
  if (speed >= 1) return "x" + std::to_string(static_cast<int>(speed));
  return "x1/" + std::to_string(static_cast<int>(1 / speed));
}

void draw_speed(const Session& session, Actions& actions, Ui& ui) {
  const std::string now = speed_text(session.playback().speed);
  const bool open = ui.begin_combo(
      "transport/speed", now, ui.px(68), "How fast the simulation runs; x1 is 60 frames a second.",
      keys_of("play/slower"_command, ui) + "  " + keys_of("play/faster"_command, ui));
  if (!open) return;
  for (double speed : {0.125, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0})
    if (selectable(speed_text(speed), {}, speed == session.playback().speed))
      actions.push_back(action::SetSpeed{speed});
  ImGui::EndCombo();
}

}  // namespace

void TransportPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  command_button("play/reset"_command, session, actions, ui, "transport/reset");
  ImGui::SameLine();
  command_button("timeline/start"_command, session, actions, ui, "transport/first");
  ImGui::SameLine();
  command_button("timeline/back"_command, session, actions, ui, "transport/back");
  ImGui::SameLine();
  command_button("play/toggle"_command, session, actions, ui, "transport/play");
  ImGui::SameLine();
  command_button("play/step"_command, session, actions, ui, "transport/step");
  ImGui::SameLine();
  command_button("timeline/end"_command, session, actions, ui, "transport/last");
  ImGui::SameLine();
  draw_frame(session, actions, ui);
  ImGui::SameLine();
  draw_speed(session, actions, ui);
  draw_overlay_switches(session, actions, ui);
  draw_branch_choice(session, actions, ui);
}

void TransportPanel::draw_frame(const Session& session, Actions& actions, Ui& ui) {
  ui.begin_row();
  ImGui::TextUnformatted("frame");
  ImGui::SameLine();
  if (!typing_) typed_ = session.state().frame;
  ImGui::SetNextItemWidth(ui.px(kFrameWidth));
  take_text_focus("transport/frame", ui);
  ImGui::InputScalar("##frame", ImGuiDataType_S64, &typed_);
  typing_ = ImGui::IsItemActive();
  if (ImGui::IsItemDeactivatedAfterEdit()) actions.push_back(action::SeekFrame{typed_});
  ui.item("transport/frame", "Steps made since frame 0. Type the number of a recorded frame to show it.",
          keys_of("timeline/go_to"_command, ui));
  ui.end_row();
}

}  // namespace talus
