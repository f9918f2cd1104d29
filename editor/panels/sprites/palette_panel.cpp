// Draws the 16 colours, to be chosen and changed.
#include "palette_panel.h"

#include <cmath>
#include <string>

#include "panels/commands/commands.h"

namespace talus {
namespace {

constexpr int kColorsInRow = 8;

// Black or white, whichever is easier to read on the colour.
ImU32 readable_on(Rgb c) {
  return theme::color(c.r * 3 + c.g * 6 + c.b > 1300 ? theme::kDark : theme::kText);
}

void draw_swatch(ImDrawList& list, const Choices& choices, int color, Rgb rgb, ImVec2 at, ImVec2 size,
                 const Ui& ui) {
  const ImVec2 to{at.x + size.x, at.y + size.y};
  list.AddRectFilled(at, to, theme::color(rgb));
  list.AddRect(at, to, theme::color(theme::kLine));
  const bool left = color == choices.color, right = color == choices.secondary_color;
  if (left || right) {
    list.AddRect({at.x + 1, at.y + 1}, {to.x - 1, to.y - 1}, readable_on(rgb), 0, 0, ui.px(1));
    const float y = at.y + (size.y - ImGui::GetTextLineHeight()) / 2;
    if (left) list.AddText({at.x + ui.px(4), y}, readable_on(rgb), "L");
    if (right) list.AddText({to.x - ui.px(4) - ImGui::CalcTextSize("R").x, y}, readable_on(rgb), "R");
  }
  if (color == ui.view.sprites.palette_color)
    list.AddRectFilled({at.x, to.y - ui.px(3)}, to, theme::color(theme::kAccent));
}

}  // namespace

void PalettePanel::draw(const Session& session, Actions& actions, Ui& ui) {
  const ImVec2 room = ImGui::GetContentRegionAvail();
  if (is_in_rgba(session.level(), session.choices().area.sheet))
    return rgba_.draw(session, actions, ui, room);
  const ImVec2 size{std::floor(room.x / kColorsInRow), std::floor(room.y * kColorsInRow / kColorCount)};
  const std::string keys =
      keys_of("palette/previous"_command, ui) + " " + keys_of("palette/next"_command, ui) + "  " +
      keys_of("palette/previous_right"_command, ui) + " " + keys_of("palette/next_right"_command, ui);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  for (int color = 0; color < kColorCount; ++color) {
    const std::string number = std::to_string(color);
    if (color % kColorsInRow != 0) ImGui::SameLine();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton(number.c_str(), size,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    const bool hovered = ImGui::IsItemHovered(), right = hovered && ImGui::IsMouseClicked(1);
    if (right || (hovered && ImGui::IsMouseClicked(0))) {
      actions.push_back(action::SetColor{color, right});
      ui.view.sprites.palette_color = color;
    }
    if (hovered && ImGui::IsMouseDoubleClicked(0)) ui.ask(request::ShowTab(panel_id::kColor));
    ui.item("palette/color" + number,
            "Colour " + number +
                ": click for the left button, right click for the right one; a double click edits it.",
            keys);
    draw_swatch(*ImGui::GetWindowDrawList(), session.choices(), color,
                session.level().palette[static_cast<std::size_t>(color)], at, size, ui);
  }
  ImGui::PopStyleVar();
}

}  // namespace talus
