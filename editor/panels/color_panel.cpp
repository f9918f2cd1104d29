// Sliders, hex and clipboard.
#include "color_panel.h"

#include <array>
#include <cstdio>
#include <string>

#include "commands.h"
#include "edit/level_settings.h"

namespace talus {
namespace {

constexpr float kRow = 20, kSwatch = 28, kHex = 72;  // px at scale 1

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

// The colour as RRGGBB; true when another one was typed.
bool draw_hex(std::array<int, 3>& rgb, Ui& ui) {
  std::array<char, 8> hex{};
  std::snprintf(hex.data(), hex.size(), "%02x%02x%02x", rgb[0], rgb[1], rgb[2]);
  unsigned typed = 0;
  ImGui::SetNextItemWidth(ui.px(kHex));
  const bool entered =
      ImGui::InputText("##hex", hex.data(), hex.size(),
                       ImGuiInputTextFlags_CharsHexadecimal | ImGuiInputTextFlags_EnterReturnsTrue);
  ui.item("palette/hex", "The colour as RRGGBB; Enter sets it.");
  if (!entered || std::sscanf(hex.data(), "%6x", &typed) != 1) return false;
  const auto byte = [&](int shift) { return static_cast<int>(typed >> shift) & 255; };
  rgb = {byte(16), byte(8), byte(0)};
  return true;
}

void draw_swatch(Rgb color, int number, Ui& ui) {
  const ImVec2 at = ImGui::GetCursorScreenPos(), size{ui.px(kSwatch), ui.px(kRow)};
  ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + size.x, at.y + size.y}, theme::color(color));
  ImGui::Dummy(size);
  ui.tooltip("Colour " + std::to_string(number) + ", which is edited here: click another one above.");
}

void draw_clipboard(std::string_view id, const char* label, const Session& session, Actions& actions,
                    Ui& ui) {
  const Command& command = find_command(id);
  ImGui::SameLine();
  if (ImGui::Button(label, {0, ui.px(kRow)})) command.run(session, actions, ui);
  ui.item(id, command.help, keys_of(command, ui));
}

}  // namespace

void ColorPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  const int color = ui.view.palette_color;
  const Rgb now = session.level().palette[static_cast<std::size_t>(color)];
  std::array<int, 3> rgb = {now.r, now.g, now.b};
  const float padding = (ui.px(kRow) - ImGui::GetFontSize()) / 2;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ui.px(6), padding));
  Touched touched;
  for (std::size_t i = 0; i < kChannels.size(); ++i) touched |= draw_channel(kChannels[i], rgb[i], ui);
  draw_swatch(now, color, ui);
  ImGui::SameLine();
  if (draw_hex(rgb, ui)) touched = {true, true};
  draw_clipboard("palette/copy", "Copy", session, actions, ui);
  draw_clipboard("palette/paste", "Paste", session, actions, ui);
  ImGui::PopStyleVar();
  if (touched.begins) stroke_ = session.next_stroke();
  if (!touched.changed) return;
  const auto byte = [](int v) { return static_cast<std::uint8_t>(v); };
  actions.push_back(action::EditLevel{
      set_color(session.level(), color, {byte(rgb[0]), byte(rgb[1]), byte(rgb[2])}), stroke_});
}

}  // namespace talus
