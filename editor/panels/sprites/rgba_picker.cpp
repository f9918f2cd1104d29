// A field of colours with bars, hexadecimal digits, and the colours that were painted with last.
#include "rgba_picker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "checkered.h"
#include "edit/picture_palette.h"
#include "formats/text/hex.h"

namespace talus {
namespace {

constexpr float kFields = 92;  // px at scale 1, width of the fields beside the picker
constexpr float kRecent = 18;  // px at scale 1, side of a recent colour
constexpr float kSquare = 5;   // px at scale 1, of what is seen through a colour

std::optional<std::uint8_t> byte_of(char high, char low) {
  const int a = hex_value(high), b = hex_value(low);
  if (a < 0 || b < 0) return std::nullopt;
  return static_cast<std::uint8_t>(16 * a + b);
}

// From RGB, RGBA, RRGGBB or RRGGBBAA, with or without '#'. Without opacity it is opaque.
std::optional<Rgba> rgba_of_hex(std::string_view hex) {
  if (hex.starts_with('#')) hex.remove_prefix(1);
  const bool is_short = hex.size() == 3 || hex.size() == 4;
  if (!is_short && hex.size() != 6 && hex.size() != 8) return std::nullopt;
  const std::size_t digits = is_short ? 1 : 2;
  std::array<std::uint8_t, 4> bytes{0, 0, 0, 255};
  for (std::size_t i = 0; i < hex.size() / digits; ++i) {
    const auto byte = byte_of(hex[i * digits], hex[i * digits + digits - 1]);
    if (!byte) return std::nullopt;
    bytes[i] = *byte;
  }
  return Rgba{bytes[0], bytes[1], bytes[2], bytes[3]};
}

Rgba chosen_color(const Session& session, bool right) {
  return right ? session.choices().secondary_rgba : session.choices().rgba;
}

}  // namespace

void RgbaPicker::draw(const Session& session, Actions& actions, Ui& ui, ImVec2 room) {
  const bool is_wide = room.y < ui.px(200);
  const float gap = ui.px(2 * theme::kGap), fields = is_wide ? ui.px(kFields) : room.x;
  const float bar = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x;
  ImGui::BeginGroup();
  draw_fields(session, actions, ui, fields);
  ImGui::EndGroup();
  if (is_wide) ImGui::SameLine(0, gap);
  const bool right = ui.view.sprites.picks_right;
  const Rgba now = chosen_color(session, right);
  std::array<float, 4> color = {now.r / 255.0f, now.g / 255.0f, now.b / 255.0f, now.a / 255.0f};
  const float high = is_wide ? room.y : room.y - ImGui::GetItemRectSize().y - gap;
  const float wide = is_wide ? room.x - fields - gap : room.x;
  ImGui::SetNextItemWidth(std::floor(std::max(ui.px(80), std::min(wide, high + 2 * bar))));
  const bool changed = ImGui::ColorPicker4(
      ("##" + name_).c_str(), color.data(),
      ImGuiColorEditFlags_AlphaBar | ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoSidePreview |
          ImGuiColorEditFlags_NoLabel | ImGuiColorEditFlags_NoOptions | ImGuiColorEditFlags_PickerHueBar);
  ui.place(name_ + "/picker", ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  if (!changed) return;
  const auto byte = [](float part) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(part, 0.0f, 1.0f) * 255));
  };
  actions.push_back(action::SetRgba{{byte(color[0]), byte(color[1]), byte(color[2]), byte(color[3])}, right});
}

void RgbaPicker::draw_fields(const Session& session, Actions& actions, Ui& ui, float width) {
  draw_button_choice(session, ui, width);
  draw_hex(chosen_color(session, ui.view.sprites.picks_right), actions, ui, width);
  draw_recent(actions, ui, width);
}

// Two swatches, of which one is edited.
void RgbaPicker::draw_button_choice(const Session& session, Ui& ui, float width) {
  const float gap = ui.px(theme::kGap);
  const ImVec2 size{std::floor((width - gap) / 2), ui.px(theme::kButton)};
  for (const bool right : {false, true}) {
    if (right) ImGui::SameLine(0, gap);
    const std::string name = name_ + (right ? "/right" : "/left");
    const ImVec2 at = ImGui::GetCursorScreenPos(), to{at.x + size.x, at.y + size.y};
    if (ImGui::InvisibleButton(name.c_str(), size)) ui.view.sprites.picks_right = right;
    ui.item(name, right ? "The picker shows the colour of the right mouse button, which erases at first."
                        : "The picker shows the colour of the left mouse button.");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_color(list, chosen_color(session, right), at, to, ui.px(kSquare));
    const bool is_shown = right == ui.view.sprites.picks_right;
    list.AddRect(at, to, is_shown ? theme::tone(theme::kAccent) : theme::color(theme::kLine), 0, 0,
                 ui.px(is_shown ? 2 : 1));
    const char* const letter = right ? "R" : "L";
    const ImVec2 text{at.x + ui.px(5), at.y + (size.y - ImGui::GetTextLineHeight()) / 2};
    add_text(list, {text.x + 1, text.y + 1}, theme::color(theme::kDark), letter);
    add_text(list, text, theme::color(theme::kText), letter);
  }
}

// Enter, Tab or a click elsewhere ends the typing and sets the colour; Escape restores it.
void RgbaPicker::draw_hex(Rgba chosen, Actions& actions, Ui& ui, float width) {
  if (!is_typing_) {
    typed_right_ = ui.view.sprites.picks_right;
    typed_ = hex_text(chosen);
  }
  ImGui::SetNextItemWidth(width);
  input_text("hex", "", typed_);
  is_typing_ = ImGui::IsItemActive();
  ui.item(name_ + "/hex", "The colour as RRGGBB, or RRGGBBAA with opacity; Enter or Tab sets it.");
  if (!ImGui::IsItemDeactivatedAfterEdit()) return;
  const auto typed = rgba_of_hex(typed_);
  if (typed)
    actions.push_back(action::SetRgba{*typed, typed_right_});
  else
    actions.push_back(action::ShowMessage{
        "\"" + shown_line(typed_) +
            "\" is not a colour: type six hexadecimal digits, or eight with opacity, such as ff880080.",
        true});
}

void RgbaPicker::draw_recent(Actions& actions, Ui& ui, float width) {
  const float gap = ui.px(2), side = ui.px(kRecent);
  const int columns = std::max(1, static_cast<int>((width + gap) / (side + gap)));
  int index = 0;
  for (const Rgba color : ui.view.sprites.recent_colors) {
    if (index % columns != 0) ImGui::SameLine(0, gap);
    const std::string name = name_ + "/recent" + std::to_string(index++);
    const ImVec2 at = ImGui::GetCursorScreenPos(), to{at.x + side, at.y + side};
    ImGui::InvisibleButton(name.c_str(), {side, side},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    const bool is_right = ImGui::IsItemHovered() && ImGui::IsMouseClicked(1);
    if (is_right || (ImGui::IsItemHovered() && ImGui::IsMouseClicked(0)))
      actions.push_back(action::SetRgba{color, is_right});
    ui.item(name,
            hex_text(color) + ", painted with before: click for the left button, right click for the right.");
    draw_color(*ImGui::GetWindowDrawList(), color, at, to, ui.px(kSquare));
    ImGui::GetWindowDrawList()->AddRect(at, to, theme::color(theme::kLine));
  }
}

}  // namespace talus
