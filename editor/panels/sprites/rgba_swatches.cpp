// Draws colours with opacity in rows, to be chosen.
#include "rgba_swatches.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "checkered.h"
#include "edit/picture_palette.h"
#include "panels/commands/commands.h"

namespace talus {
namespace {

constexpr float kButtonColors = 44;                    // px at scale 1, width of the colours of the buttons
constexpr float kWidest = 24;                          // px at scale 1, of a swatch
constexpr float kSquareSide = 5;                       // px at scale 1, of what is seen through a colour
constexpr float kPickerWide = 232, kPickerHigh = 252;  // px at scale 1
constexpr int kSwatchRows = 3;
constexpr const char* kAllColors = "all colours";

// Black or white, whichever is easier to read on the colour.
ImU32 mark_on(Rgba c) {
  return theme::color(c.a > 127 && c.r * 3 + c.g * 6 + c.b > 1300 ? theme::kDark : theme::kText);
}

}  // namespace

void RgbaSwatches::draw(const Session& session, Actions& actions, Ui& ui, ImVec2 room) {
  count_colors(session);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  draw_buttons(session, ui, {ui.px(kButtonColors), room.y});
  ImGui::SameLine(0, ui.px(2 * theme::kGap));
  draw_grid(session, actions, ui, {room.x - ui.px(kButtonColors + 2 * theme::kGap), room.y});
  ImGui::PopStyleVar();
  draw_popup(session, actions, ui);
}

// A stroke can wait for its end.
void RgbaSwatches::count_colors(const Session& session) {
  const SpriteArea& area = session.choices().area;
  const bool is_new_area = !counted_revision_ || !(counted_area_ == area);
  if (!is_new_area && (counted_revision_ == session.revision() || ImGui::IsAnyMouseDown())) return;
  colors_ = picture_palette(session.level(), area);
  counted_area_ = area;
  counted_revision_ = session.revision();
}

// The left button's colour lies over that of the right one. A click opens all colours.
void RgbaSwatches::draw_buttons(const Session& session, Ui& ui, ImVec2 size) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 swatch{std::floor(size.x * 0.66f), std::floor(size.y * 0.66f)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const bool right : {true, false}) {
    const ImVec2 at = right ? ImVec2{corner.x + size.x - swatch.x, corner.y + size.y - swatch.y} : corner;
    const ImVec2 to{at.x + swatch.x, at.y + swatch.y};
    const Rgba color = right ? session.choices().secondary_rgba : session.choices().rgba;
    draw_color(list, color, at, to, ui.px(kSquareSide));
    list.AddRect(at, to, theme::tone(theme::kText), 0, 0, ui.px(1));
    add_text(list, {at.x + ui.px(3), right ? to.y - ImGui::GetTextLineHeight() : at.y + ui.px(1)},
             mark_on(color), right ? "R" : "L");
  }
  for (const bool right : {false, true}) {  // the first one that the mouse is on takes the click
    const std::string name = right ? "palette/right" : "palette/left";
    ImGui::SetCursorScreenPos(right ? ImVec2{corner.x + size.x - swatch.x, corner.y + size.y - swatch.y}
                                    : corner);
    const bool is_pressed = ImGui::InvisibleButton(name.c_str(), swatch);
    ui.item(name, right
                      ? "The colour of the right mouse button, at first clear, which erases: click to choose "
                        "any colour."
                      : "The colour of the left mouse button: click to choose any colour, also a clear one.");
    if (!is_pressed) continue;
    ui.view.sprites.picks_right = right;
    ImGui::OpenPopup(kAllColors);
  }
  ImGui::SetCursorScreenPos(corner);
  ImGui::Dummy(size);
}

void RgbaSwatches::draw_grid(const Session& session, Actions& actions, Ui& ui, ImVec2 room) {
  const int count = static_cast<int>(colors_.size()) + 2;  // with the eraser, and all colours
  const int columns = (count + kSwatchRows - 1) / kSwatchRows;
  const ImVec2 size{std::min(std::floor(room.x / static_cast<float>(columns)), ui.px(kWidest)),
                    std::floor(room.y / kSwatchRows)};
  ImGui::BeginGroup();
  for (int i = 0; i < count - 1; ++i) {
    if (i % columns != 0) ImGui::SameLine();
    draw_swatch(session, actions, ui, i - 1, size);
  }
  if ((count - 1) % columns != 0) ImGui::SameLine();
  const ImVec2 at = ImGui::GetCursorScreenPos(), middle{at.x + size.x / 2, at.y + size.y / 2};
  const bool is_pressed = ImGui::InvisibleButton("palette/more", size);
  ui.item("palette/more", "All colours: choose one by its hue, lightness and opacity, or by its digits.");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 color = theme::tone(ImGui::IsItemHovered() ? theme::kAccent : theme::kText);
  const float arm = std::floor(std::min(size.x, size.y) / 4), half = ui.px(1);
  list.AddRectFilled({middle.x - arm, middle.y - half}, {middle.x + arm, middle.y + half}, color);
  list.AddRectFilled({middle.x - half, middle.y - arm}, {middle.x + half, middle.y + arm}, color);
  ImGui::EndGroup();
  if (is_pressed) ImGui::OpenPopup(kAllColors);
}

// index: of colors_; -1: the eraser.
void RgbaSwatches::draw_swatch(const Session& session, Actions& actions, Ui& ui, int index, ImVec2 size) {
  const Rgba color = index < 0 ? Rgba{} : colors_[static_cast<std::size_t>(index)];
  const std::string name = index < 0 ? "palette/eraser" : "palette/picture" + std::to_string(index);
  const ImVec2 at = ImGui::GetCursorScreenPos(), to{at.x + size.x, at.y + size.y};
  ImGui::InvisibleButton(name.c_str(), size,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  const bool is_hovered = ImGui::IsItemHovered(), is_right = is_hovered && ImGui::IsMouseClicked(1);
  if (is_right || (is_hovered && ImGui::IsMouseClicked(0)))
    actions.push_back(action::SetRgba{color, is_right});
  if (is_hovered && ImGui::IsMouseDoubleClicked(0)) {
    ui.view.sprites.picks_right = false;
    ImGui::OpenPopup(kAllColors);
  }
  const std::string use =
      ": click for the left button, right click for the right one; a double click shows all colours.";
  ui.item(name, (index < 0 ? "Clear, the eraser" : hex_text(color) + ", of the picture") + use,
          keys_of("palette/previous"_command, ui) + " " + keys_of("palette/next"_command, ui));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_color(list, color, at, to, ui.px(kSquareSide));
  list.AddRect(at, to, theme::color(theme::kLine));
  const Choices& choices = session.choices();
  const bool is_left = pixel_color(choices.rgba) == pixel_color(color);
  if (!is_left && pixel_color(choices.secondary_rgba) != pixel_color(color)) return;
  list.AddRect({at.x + 1, at.y + 1}, {to.x - 1, to.y - 1}, mark_on(color), 0, 0, ui.px(1));
  const char* const letter = is_left ? "L" : "R";
  const ImVec2 text = ImGui::CalcTextSize(letter);
  add_text(list, {at.x + (size.x - text.x) / 2, at.y + (size.y - text.y) / 2}, mark_on(color), letter);
}

void RgbaSwatches::draw_popup(const Session& session, Actions& actions, Ui& ui) {
  if (!ImGui::BeginPopup(kAllColors)) return;
  picker_.draw(session, actions, ui, {ui.px(kPickerWide), ui.px(kPickerHigh)});
  ImGui::EndPopup();
}

}  // namespace talus
