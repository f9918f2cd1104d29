#include "gamepad_settings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <tuple>

namespace talus {
namespace {

struct NamedButton {
  std::string_view name, label;  // SDL's name, and that on the screen
};
constexpr std::array kNamedButtons = {NamedButton{"a", "A"},
                                      NamedButton{"b", "B"},
                                      NamedButton{"x", "X"},
                                      NamedButton{"y", "Y"},
                                      NamedButton{"dpleft", "D-pad left"},
                                      NamedButton{"dpright", "D-pad right"},
                                      NamedButton{"dpup", "D-pad up"},
                                      NamedButton{"dpdown", "D-pad down"},
                                      NamedButton{"leftshoulder", "left shoulder"},
                                      NamedButton{"rightshoulder", "right shoulder"},
                                      NamedButton{"leftstick", "left stick down"},
                                      NamedButton{"rightstick", "right stick down"}};

std::string label_of_button(const std::string& name) {
  if (name.empty()) return "none";
  const auto* known = std::ranges::find(kNamedButtons, name, &NamedButton::name);
  return known != kNamedButtons.end() ? std::string(known->label) : shown_line(name, kMaxLabel);
}

void pad_row(std::string_view name, float names) {
  ImGui::AlignTextToFramePadding();
  draw_text(name);
  ImGui::SameLine(names);
}

// A press waits for a button of the gamepad; a second press leaves it without one.
void draw_pad_button(PadButtons PadBindings::*buttons, std::size_t index, const std::string& widget,
                     float width, Ui& ui) {
  auto& capture = ui.view.commands.pad_capture;
  const bool waits = capture && capture->buttons == buttons && capture->index == index;
  std::string& name = (ui.view.preferences.pad.*buttons)[index];
  if (!ui.text_button(widget, waits ? "press a button" : label_of_button(name), waits,
                      "Press this, and then a button of the gamepad. A second press leaves it without one.",
                      {}, true, width))
    return;
  if (waits) {
    name.clear();
    capture.reset();
  } else {
    capture = PadCapture{buttons, index};
  }
}

}  // namespace

void draw_gamepad_settings(float names, float width, Ui& ui) {
  PadBindings& pad = ui.view.preferences.pad;
  const auto& connected = ui.view.commands.gamepads;
  pad_row("Gamepad", names);
  std::string text = connected.empty() ? "none is connected" : "";
  for (const std::string& name : connected) text += (text.empty() ? "" : ", ") + name;
  draw_short_text(text, width, theme::tone(theme::kMuted));
  ui.item("settings/gamepads");
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  constexpr std::array kRows = {std::tuple{"Run left", "left", &PadBindings::left},
                                std::tuple{"Run right", "right", &PadBindings::right},
                                std::tuple{"Jump", "jump", &PadBindings::jump}};
  for (const auto& [label, key, buttons] : kRows) {
    pad_row(label, names);
    for (std::size_t i = 0; i < PadButtons().size(); ++i) {
      if (i > 0) ImGui::SameLine();
      draw_pad_button(buttons, i, std::string("settings/pad_") + key + std::to_string(i), (width - gap) / 2,
                      ui);
    }
  }
  pad_row("Left stick", names);
  checkbox("Runs, beyond", "pad_stick", pad.stick);
  ui.item("settings/pad_stick", "The left stick of a gamepad runs to its side.");
  ImGui::SameLine();
  int percent = static_cast<int>(std::lround(pad.dead_zone * 100));
  ImGui::SetNextItemWidth(std::max(ui.px(60), width - (ImGui::GetCursorPosX() - names)));
  if (ImGui::SliderInt("##dead_zone", &percent, 5, 95, "%d %% of its way", ImGuiSliderFlags_AlwaysClamp))
    pad.dead_zone = percent / 100.0;
  ui.item("settings/pad_dead_zone", "How far the stick is moved before it counts.",
          "Ctrl+click types a number");
}

}  // namespace talus
