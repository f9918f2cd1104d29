// The swatches and the sliders.
#include "palette_panel.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace talus {
namespace {

constexpr int kColorsInRow = 4;

// Black or white, whichever is read better on the colour.
ImU32 readable_on(Rgb c) {
  return theme::color(c.r * 3 + c.g * 6 + c.b > 1300 ? theme::kDark : theme::kText);
}

void draw_swatch(ImDrawList& list, const Choices& choices, int color, Rgb rgb, ImVec2 at, float side,
                 const Ui& ui) {
  const ImVec2 to{at.x + side, at.y + side};
  list.AddRectFilled(at, to, theme::color(rgb));
  list.AddRect(at, to, theme::color(theme::kLine));
  const bool left = color == choices.color, right = color == choices.secondary_color;
  if (left || right) {
    list.AddRect({at.x + 1, at.y + 1}, {to.x - 1, to.y - 1}, readable_on(rgb), 0, 0, ui.px(1));
    const float y = at.y + (side - ImGui::GetTextLineHeight()) / 2;
    if (left) list.AddText({at.x + ui.px(4), y}, readable_on(rgb), "L");
    if (right) list.AddText({to.x - ui.px(4) - ImGui::CalcTextSize("R").x, y}, readable_on(rgb), "R");
  }
  if (color == ui.view.palette_color)
    list.AddRectFilled({at.x, to.y - ui.px(3)}, to, theme::color(theme::kAccent));
}

struct Channel {
  const char* name;    // of its slider
  const char* format;  // of its number
  std::uint32_t color;
};
constexpr std::array<Channel, 3> kChannels = {{{"palette/red", "R %d", 0xe0546a},
                                               {"palette/green", "G %d", 0x6abf69},
                                               {"palette/blue", "B %d", 0x5a8cf0}}};
constexpr float kNumberWidth = 48;  // px at scale 1

// What the user does to the colour in this frame.
struct Touched {
  bool changed = false, begins = false;  // begins: a stroke, which is one undo
  Touched& operator|=(Touched other) {
    changed |= other.changed;
    begins |= other.begins;
    return *this;
  }
};

// A slider, and its number beside it, where the knob does not cover it.
Touched draw_channel(const Channel& channel, int& value, Ui& ui) {
  Touched touched;
  const std::string name = channel.name, hidden = "##" + name;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - ui.px(kNumberWidth + theme::kGap));
  ImGui::PushStyleColor(ImGuiCol_SliderGrab, theme::color(channel.color));
  ImGui::PushStyleColor(ImGuiCol_SliderGrabActive, theme::color(channel.color));
  touched.changed = ImGui::SliderInt(hidden.c_str(), &value, 0, 255, "", ImGuiSliderFlags_NoInput);
  ImGui::PopStyleColor(2);
  touched.begins = ImGui::IsItemActivated();
  ui.item(name, "Drag; undoable.");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  touched.changed |= ImGui::DragInt((hidden + "_number").c_str(), &value, 0.5f, 0, 255, channel.format,
                                    ImGuiSliderFlags_AlwaysClamp);
  touched.begins |= ImGui::IsItemActivated();
  ui.item(name + "_number", "From 0 to 255; undoable.", "drag, or double click to type");
  return touched;
}

}  // namespace

void PalettePanel::draw(const Session& session, Actions& actions, Ui& ui) {
  draw_swatches(session, actions, ui);
  draw_editor(session, actions, ui);
}

void PalettePanel::draw_swatches(const Session& session, Actions& actions, Ui& ui) {
  const float side = std::floor(ImGui::GetContentRegionAvail().x / kColorsInRow);
  const float height = std::min(side, ui.px(24));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  for (int color = 0; color < kColorCount; ++color) {
    const std::string number = std::to_string(color);
    if (color % kColorsInRow != 0) ImGui::SameLine();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton(number.c_str(), {height, height},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    const bool right = ImGui::IsItemHovered() && ImGui::IsMouseClicked(1);
    if (right || (ImGui::IsItemHovered() && ImGui::IsMouseClicked(0))) {
      actions.push_back(action::SetColor{color, right});
      ui.view.palette_color = color;
    }
    ui.item("palette/color" + number,
            "Colour " + number + ": click for the left button, right click for the right one.",
            "[ ]  Shift+[ ]");
    draw_swatch(*ImGui::GetWindowDrawList(), session.choices(), color,
                session.level().palette[static_cast<std::size_t>(color)], at, height, ui);
  }
  ImGui::PopStyleVar();
}

void PalettePanel::draw_editor(const Session& session, Actions& actions, Ui& ui) {
  const int color = ui.view.palette_color;
  const Rgb now = session.level().palette[static_cast<std::size_t>(color)];
  std::array<int, 3> rgb = {now.r, now.g, now.b};
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ui.px(4), ui.px(1)));
  Touched touched;
  for (std::size_t i = 0; i < kChannels.size(); ++i) touched |= draw_channel(kChannels[i], rgb[i], ui);
  std::array<char, 8> hex{};
  std::snprintf(hex.data(), hex.size(), "%02x%02x%02x", rgb[0], rgb[1], rgb[2]);
  unsigned typed = 0;
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputText("##hex", hex.data(), hex.size(),
                       ImGuiInputTextFlags_CharsHexadecimal | ImGuiInputTextFlags_EnterReturnsTrue) &&
      std::sscanf(hex.data(), "%6x", &typed) == 1) {
    rgb = {static_cast<int>(typed >> 16) & 255, static_cast<int>(typed >> 8) & 255,
           static_cast<int>(typed) & 255};
    touched = {true, true};
  }
  ui.item("palette/hex", "The colour as RRGGBB; Enter sets it.");
  ImGui::PopStyleVar();
  if (touched.begins) stroke_ = session.next_stroke();
  if (!touched.changed) return;
  const auto byte = [](int v) { return static_cast<std::uint8_t>(v); };
  actions.push_back(action::EditLevel{
      set_color(session.level(), color, {byte(rgb[0]), byte(rgb[1]), byte(rgb[2])}), stroke_});
}

}  // namespace talus
