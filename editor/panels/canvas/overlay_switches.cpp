#include "overlay_switches.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "overlay_painter.h"
#include "panels/commands/commands.h"

namespace talus {
namespace {

constexpr float kSwatch = 14, kPad = 4, kTextGap = 6, kFirstGap = 8;  // px at scale 1
constexpr float kRowHeight = 22, kRowWidth = 190;                     // px at scale 1, of a group's menu

// A row of a group's menu, which stays open.
void draw_switch(const Overlay& overlay, const Session& session, Actions& actions, Ui& ui) {
  const std::string id = "overlay/" + std::string(overlay.key);
  const Command& command = find_command(CommandId{id});
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float swatch = ui.px(kSwatch), text = swatch + ui.px(kTextGap);
  const float width = text + ui.px(kRowWidth);
  if (selectable({}, id, false, ImGuiSelectableFlags_DontClosePopups, {width, ui.px(kRowHeight)}))
    command.run(session, actions, ui);
  std::string help(overlay.help);
  if (const auto why = why_nothing(overlay, session.level()); !why.empty()) help.append(" ").append(why);
  ui.item(id, help, keys_of(command, ui));
  if (ImGui::IsItemHovered()) ui.view.canvas.hovered_overlay = &overlay;
  const bool on = session.choices().overlays.has(overlay);
  const float middle = at.y + (ui.px(kRowHeight) - ImGui::GetTextLineHeight()) / 2;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  paint_overlay_swatch(list, overlay, {at.x, at.y + (ui.px(kRowHeight) - swatch) / 2}, swatch,
                       session.choices().overlay_palette);
  add_text(list, {at.x + text, middle}, theme::tone(on ? theme::kText : theme::kMuted), overlay.label);
  const std::string keys = on ? "shown" : keys_of(command, ui);
  add_text(list, {at.x + width - size_of_text(keys).x, middle},
           theme::tone(on ? theme::kAccent : theme::kMuted), keys);
}

// A button with the group's name, and a line in the colour of each of its overlays that is shown.
void draw_group(OverlayGroup group, const Session& session, Actions& actions, Ui& ui) {
  const OverlayGroupInfo& info = kOverlayGroups[static_cast<std::size_t>(group)];
  const std::string id = "overlay/group_" + std::string(info.key);
  const float width = size_of_text(info.label).x + 2 * ui.px(kPad + kPad);
  ui.same_line_if_fits(width);
  if (ui.text_button(id, info.label, false, info.help, {}, true, width)) ImGui::OpenPopup(id.c_str());
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  std::vector<const Overlay*> shown;
  for (const Overlay* overlay : all_overlays())
    if (overlay->group == group && session.choices().overlays.has(*overlay)) shown.push_back(overlay);
  const float part = (max.x - min.x) / static_cast<float>(std::max<std::size_t>(1, shown.size()));
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const float x = min.x + part * static_cast<float>(i);
    ImGui::GetWindowDrawList()->AddRectFilled(
        {x, max.y - ui.px(3)}, {x + part, max.y},
        theme::color(overlay_color(*shown[i], session.choices().overlay_palette)));
  }
  ImGui::SetNextWindowPos({min.x, min.y - ui.px(2)}, ImGuiCond_Always, {0, 1});  // it hides no other group
  if (!ImGui::BeginPopup(id.c_str())) return;
  for (const Overlay* overlay : all_overlays())
    if (overlay->group == group) draw_switch(*overlay, session, actions, ui);
  ImGui::EndPopup();
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

void draw_overlay_switches(const Session& session, Actions& actions, Ui& ui) {
  ui.view.canvas.hovered_overlay = nullptr;
  draw_presets(session, actions, ui);
  for (std::size_t group = 0; group < std::size(kOverlayGroups); ++group)
    draw_group(static_cast<OverlayGroup>(group), session, actions, ui);
}

}  // namespace talus
