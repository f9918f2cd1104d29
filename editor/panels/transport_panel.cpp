// The bar below the canvas.
#include "transport_panel.h"

#include <array>
#include <cstdio>
#include <string>

#include "commands.h"
#include "overlay_painter.h"

namespace talus {
namespace {

std::string speed_text(double speed) {
  if (speed >= 1) return "x" + std::to_string(static_cast<int>(speed));
  return "x1/" + std::to_string(static_cast<int>(1 / speed));
}

void draw_speed(const Session& session, Actions& actions, Ui& ui) {
  const std::string now = speed_text(session.playback().speed);
  const bool open = ui.begin_combo(
      "transport/speed", now, ui.px(68), "How fast the simulation runs; x1 is 60 frames a second.",
      keys_of(find_command("play/slower")) + "  " + keys_of(find_command("play/faster")));
  if (!open) return;
  for (double speed : {0.125, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0})
    if (ImGui::Selectable(speed_text(speed).c_str(), speed == session.playback().speed))
      actions.push_back(action::SetSpeed{speed});
  ImGui::EndCombo();
}

void draw_overlay_switch(const OverlayInfo& info, const Session& session, Actions& actions, Ui& ui) {
  const std::string id = "overlay/" + std::string(info.key), label(info.label);
  const Command& command = find_command(id);
  const bool on = session.choices().overlays.has(info.id);
  const float height = ui.px(theme::kButton), icon = ui.px(14);
  const ImVec2 text = ImGui::CalcTextSize(label.c_str());
  const float width = text.x + icon + ui.px(16);
  ui.same_line_if_fits(width, info.id == OverlayId::boxes ? ui.px(8) : 0);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushStyleColor(ImGuiCol_Button, theme::color(on ? theme::kControlHot : theme::kPanel));
  if (ImGui::Button(("##" + id).c_str(), {width, height})) command.run(session, actions, ui);
  ImGui::PopStyleColor();
  ui.item(id, info.help, keys_of(command));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  paint_overlay_swatch(list, info.id, {at.x + ui.px(4), at.y + (height - icon) / 2}, icon);
  list.AddText({at.x + icon + ui.px(10), at.y + (height - text.y) / 2},
               theme::color(on ? theme::kText : theme::kMuted), label.c_str());
}

}  // namespace

void TransportPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  command_button("transport/reset", "play/reset", Icon::reset, session, actions, ui);
  ImGui::SameLine();
  command_button("transport/play", "play/toggle", session.playback().running ? Icon::pause : Icon::play,
                 session, actions, ui);
  ImGui::SameLine();
  command_button("transport/step", "play/step", Icon::step, session, actions, ui);
  ImGui::SameLine();
  std::array<char, 32> frame{};
  std::snprintf(frame.data(), frame.size(), "frame %05lld", static_cast<long long>(session.state().frame));
  const float row = ImGui::GetCursorPosY();
  ui.label(frame.data());
  ui.tooltip("Steps made since frame 0.");
  ImGui::SameLine();
  ImGui::SetCursorPosY(row);
  draw_speed(session, actions, ui);
  for (const OverlayInfo& info : overlay_infos()) draw_overlay_switch(info, session, actions, ui);
}

}  // namespace talus
