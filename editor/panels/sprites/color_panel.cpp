// Sliders, hex and clipboard.
#include "color_panel.h"

#include <imgui_internal.h>

#include <array>
#include <cstdio>
#include <optional>
#include <string>

#include "edit/level_settings.h"
#include "formats/text/hex.h"
#include "panels/canvas/drag_cancel.h"
#include "panels/commands/commands.h"

namespace talus {
namespace {

constexpr float kColorRow = 20, kSwatch = 28, kHex = 72;  // px at scale 1

struct Channel {
  const char* name;    // name of its slider
  const char* format;  // format of its number
  std::uint32_t color;
};
constexpr std::array<Channel, 3> kChannels = {{{"palette/red", "R %d", 0xe0546a},
                                               {"palette/green", "G %d", 0x6abf69},
                                               {"palette/blue", "B %d", 0x5a8cf0}}};
constexpr float kNumberWidth = 48;  // px at scale 1

// What the user does with the colour in this frame.
struct Touched {
  bool changed = false, begins = false;  // begins: a stroke, which is one undo
  bool cancelled = false;                // Escape has cancelled the stroke
  Touched& operator|=(Touched other) {
    changed |= other.changed;
    begins |= other.begins;
    cancelled |= other.cancelled;
    return *this;
  }
};

// About ImGui's last item. A cancelled drag ends with it.
Touched touched_item(bool changed) {
  Touched touched{changed, ImGui::IsItemActivated()};
  touched.cancelled = (ImGui::IsItemActive() || ImGui::IsItemDeactivated()) && is_drag_cancelled();
  if (touched.cancelled && ImGui::IsItemActive()) ImGui::ClearActiveID();
  return touched;
}

// A slider with its number beside it, where the knob does not cover the number.
Touched draw_channel(const Channel& channel, int& value, Ui& ui) {
  const std::string name = channel.name, hidden = "##" + name;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - ui.px(kNumberWidth + theme::kGap));
  ImGui::PushStyleColor(ImGuiCol_SliderGrab, theme::color(channel.color));
  ImGui::PushStyleColor(ImGuiCol_SliderGrabActive, theme::color(channel.color));
  Touched touched =
      touched_item(ImGui::SliderInt(hidden.c_str(), &value, 0, 255, "", ImGuiSliderFlags_NoInput));
  ImGui::PopStyleColor(2);
  ui.item(name, "Drag; undoable.", "Esc cancels");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  touched |= touched_item(ImGui::DragInt((hidden + "_number").c_str(), &value, 0.5f, 0, 255, channel.format,
                                         ImGuiSliderFlags_AlwaysClamp));
  ui.item(name + "_number", "From 0 to 255; undoable.", "drag, or double click to type");
  return touched;
}

std::string hex_of(Rgb color) {
  std::array<char, 8> hex{};
  std::snprintf(hex.data(), hex.size(), "%02x%02x%02x", color.r, color.g, color.b);
  return hex.data();
}

// From six hexadecimal digits, or from three that each stand for two.
std::optional<Rgb> color_of(std::string_view hex) {
  if (hex.size() != 3 && hex.size() != 6) return std::nullopt;
  const std::size_t digits = hex.size() / 3;
  const auto channel = [&](std::size_t i) {
    const int high = hex_value(hex[i * digits]), low = hex_value(hex[i * digits + digits - 1]);
    return static_cast<std::uint8_t>(16 * high + low);
  };
  return Rgb{channel(0), channel(1), channel(2)};
}

void draw_swatch(Rgb color, int number, Ui& ui) {
  const ImVec2 at = ImGui::GetCursorScreenPos(), size{ui.px(kSwatch), ui.px(kColorRow)};
  ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + size.x, at.y + size.y}, theme::color(color));
  ImGui::Dummy(size);
  ui.tooltip("Colour " + std::to_string(number) + ", which is edited here: click another one above.");
}

}  // namespace

void ColorPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  if (is_in_rgba(session.level(), session.choices().area.sheet))
    return rgba_.draw(session, actions, ui, ImGui::GetContentRegionAvail());
  const int color = ui.view.sprites.palette_color;
  const float padding = (ui.px(kColorRow) - ImGui::GetFontSize()) / 2;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ui.px(6), padding));
  draw_swatch(session.level().palette[static_cast<std::size_t>(color)], color, ui);
  ImGui::SameLine();
  const Rgb now = draw_hex(session, actions, ui);
  ImGui::SameLine();
  command_text_button("palette/copy"_command, session, actions, ui, {.label = "Copy"});
  ImGui::SameLine();
  command_text_button("palette/paste"_command, session, actions, ui, {.label = "Paste"});
  std::array<int, 3> rgb = {now.r, now.g, now.b};
  Touched touched;
  for (std::size_t i = 0; i < kChannels.size(); ++i) touched |= draw_channel(kChannels[i], rgb[i], ui);
  ImGui::PopStyleVar();
  if (touched.begins) {
    stroke_ = session.next_stroke();
    before_ = now;
  }
  if (!touched.changed && !touched.cancelled) return;
  const auto byte = [](int v) { return static_cast<std::uint8_t>(v); };
  const Rgb wanted = touched.cancelled ? before_ : Rgb{byte(rgb[0]), byte(rgb[1]), byte(rgb[2])};
  actions.push_back(action::EditLevel{set_color(session.level(), color, wanted), stroke_});
}

// Enter, Tab or a click elsewhere ends the typing and sets the colour; Escape restores it. The text belongs
// to the colour with which the typing began, as the click may choose another colour.
Rgb ColorPanel::draw_hex(const Session& session, Actions& actions, Ui& ui) {
  const Palette& palette = session.level().palette;
  const Rgb chosen = palette[static_cast<std::size_t>(ui.view.sprites.palette_color)];
  if (!typing_) {
    typed_color_ = ui.view.sprites.palette_color;
    typed_ = hex_of(chosen);
  }
  ImGui::SetNextItemWidth(ui.px(kHex));
  input_text("hex", "", typed_, ImGuiInputTextFlags_CharsHexadecimal);
  typing_ = ImGui::IsItemActive();
  ui.item("palette/hex", "The colour as RRGGBB, or RGB for short; Enter or Tab sets it.");
  if (!ImGui::IsItemDeactivatedAfterEdit()) return chosen;
  const auto typed = color_of(typed_);
  if (!typed) {
    actions.push_back(action::ShowMessage{
        "\"" + typed_ + "\" is not a colour: type six hexadecimal digits, or three, such as f80 for ff8800.",
        true});
    return chosen;
  }
  if (*typed != palette[static_cast<std::size_t>(typed_color_)])
    actions.push_back(action::EditLevel{set_color(session.level(), typed_color_, *typed)});
  return typed_color_ == ui.view.sprites.palette_color ? *typed : chosen;
}

}  // namespace talus
