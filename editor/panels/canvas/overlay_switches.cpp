#include "overlay_switches.h"

#include <algorithm>
#include <string>

#include "overlay_painter.h"
#include "panels/commands/commands.h"
#include "panels/debugger/branch_choice.h"

namespace talus {
namespace {

constexpr float kSwatch = 14;                    // px at scale 1
constexpr float kPad = 4, kTextGap = 6;          // px at scale 1
constexpr float kFirstGap = 8, kControls = 402;  // px at scale 1: width without the switches on their line

float text_width(std::string_view text) { return size_of_text(text).x; }

void draw_switch(const Overlay& overlay, bool named, const Session& session, Actions& actions, Ui& ui) {
  const std::string id = "overlay/" + std::string(overlay.key), label(overlay.label);
  const Command& command = find_command(CommandId{id});
  const bool on = session.choices().overlays.has(overlay);
  const float height = ui.px(theme::kButton), swatch = ui.px(kSwatch), pad = ui.px(kPad);
  const float width = swatch + 2 * pad + (named ? text_width(label) + ui.px(kTextGap) : 0);
  ui.same_line_if_fits(width);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushStyleColor(ImGuiCol_Button, theme::tone(on ? theme::kControlHot : theme::kPanel));
  if (button("", id, {width, height})) command.run(session, actions, ui);
  ImGui::PopStyleColor();
  ui.item(id, named ? std::string(overlay.help) : label + ": " + std::string(overlay.help),
          keys_of(command, ui));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  paint_overlay_swatch(list, overlay, {at.x + pad, at.y + (height - swatch) / 2}, swatch,
                       session.choices().overlay_palette);
  if (named)
    add_text(list, {at.x + pad + swatch + ui.px(kTextGap), at.y + (height - ImGui::GetTextLineHeight()) / 2},
             theme::tone(on ? theme::kText : theme::kMuted), label);
  if (!named && on)
    list.AddRectFilled({at.x, at.y + height - ui.px(2)}, {at.x + width, at.y + height},
                       theme::tone(theme::kAccent));
}

void draw_item(const std::string& id, const Session& session, Actions& actions, Ui& ui) {
  const Command& command = find_command(CommandId{id});
  if (menu_item(command.label, id, keys_of(command, ui), command.checked(session, ui)))
    command.run(session, actions, ui);
  ui.item(id, command.help, keys_of(command, ui));
}

void draw_presets(const Session& session, Actions& actions, Ui& ui) {
  ui.same_line_if_fits(ui.px(theme::kButton), ui.px(kFirstGap));
  if (ui.icon_button("overlay/presets", Icon::eye, false, "Overlays that answer one question together.", ""))
    ImGui::OpenPopup("presets");
  if (!ImGui::BeginPopup("presets")) return;
  for (const OverlayPreset& preset : overlay_presets())
    draw_item("overlays/" + std::string(preset.key), session, actions, ui);
  ImGui::Separator();
  draw_item("canvas/labels", session, actions, ui);
  ImGui::EndPopup();
}

}  // namespace

bool overlay_names_fit(const Ui& ui) {
  float width = ui.px(kControls + kBranchWidth + kProgressWidth);
  for (const Overlay* overlay : all_overlays())
    width +=
        text_width(overlay->label) + ui.px(kSwatch + 2 * kPad + kTextGap) + ImGui::GetStyle().ItemSpacing.x;
  return width <= ImGui::GetIO().DisplaySize.x;
}

void draw_overlay_switches(const Session& session, Actions& actions, Ui& ui) {
  const bool named = overlay_names_fit(ui);
  draw_presets(session, actions, ui);
  for (const Overlay* overlay : all_overlays()) draw_switch(*overlay, named, session, actions, ui);
}

}  // namespace talus
