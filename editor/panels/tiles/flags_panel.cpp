// The lamps in two columns, with the fields below. Each has a menu for its names and its role.
#include "flags_panel.h"

#include <imgui_internal.h>

#include <array>
#include <charconv>
#include <cstdio>

#include "edit/flag_lamps.h"
#include "edit/flag_tools.h"
#include "flag_label.h"
#include "panels/canvas/canvas_layers.h"
#include "panels/commands/commands.h"
#include "shape_editor.h"

namespace talus {
namespace {

constexpr float kFlagRow = 20;  // px at scale 1

void draw_lamp_light(ImDrawList& list, ImVec2 centre, float radius, FlagLamp lamp, int flag) {
  const ImU32 unlit = theme::is_light() ? theme::tone(theme::kBackground) : theme::color(theme::kDark);
  list.AddCircleFilled(centre, radius, unlit, 20);
  if (lamp == FlagLamp::all) list.AddCircleFilled(centre, radius - 1, flag_color(flag, 255), 20);
  if (lamp == FlagLamp::some) {  // half lit
    list.PathArcTo(centre, radius - 1, 1.5707963f, 4.7123890f, 12);
    list.PathFillConvex(flag_color(flag, 255));
  }
  list.AddCircle(centre, radius, flag_color(flag, 200), 20);
}

std::string lamp_help(const Level& level, FlagLamp lamp, int flag) {
  const FlagRoleInfo* role = role_of_flag(level.roles, flag);
  const TileShape& shape = level.flag_shapes[static_cast<std::size_t>(flag)];
  const std::string name = shown_line(level.flag_names[static_cast<std::size_t>(flag)]);
  std::string help = "Flag " + std::to_string(flag) + (name.empty() ? "" : ", \"" + name + "\"") + ", ";
  help += lamp == FlagLamp::all    ? "set"
          : lamp == FlagLamp::some ? "set in some of the selected tiles"
                                   : "not set";
  if (role != nullptr)
    help += "; its role is " + std::string(role->label) + ".";
  else if (shape.kind != TileShape::Kind::none)
    help += "; its shape is " + std::string(kind_label(shape)) + ".";
  else
    help += "; it has no role.";
  return help +
         " A click sets it, or clears it where any tile has it. A right click names it and chooses its "
         "role or shape.";
}

std::string hex_byte(std::uint8_t byte) {
  std::array<char, 3> text{};
  std::snprintf(text.data(), text.size(), "%02x", byte);
  return text.data();
}

std::vector<int> single_flags(const Level& level) {
  std::vector<int> flags;
  for (int flag = 0; flag < kFlagCount; ++flag)
    if (field_of_flag(level.flag_fields, flag) == nullptr) flags.push_back(flag);
  return flags;
}

// A button as high as a row, at its right end, which opens a menu.
bool draw_menu_button(const std::string& name, const std::string& help, float width, Ui& ui) {
  const bool wanted = ui.view.requests.take<request::FocusField>(name);  // a command opens it
  const bool pressed = button("...", name, {width, ui.px(kFlagRow)});
  ui.item(name, help);
  return pressed || wanted;
}

}  // namespace

void FlagsPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  draw_header(session, actions, ui);
  const float width = (ImGui::GetContentRegionAvail().x - ui.px(4)) / 2;
  const std::vector<int> flags = single_flags(session.level());
  const std::size_t rows = (flags.size() + 1) / 2;
  for (std::size_t row = 0; row < rows; ++row) {
    draw_lamp(session, actions, ui, flags[row], width);
    if (row + rows >= flags.size()) continue;
    ImGui::SameLine();
    draw_lamp(session, actions, ui, flags[row + rows], width);
  }
  for (const FlagField& field : session.level().flag_fields) draw_field(session, actions, ui, field);
  menu_.draw(session, actions, ui);
}

// In line with the panel's tab.
void FlagsPanel::draw_header(const Session& session, Actions& actions, Ui& ui) {
  const Command& brush = find_command("flags/brush"_command);
  const float byte = ui.px(28), width = ui.px(80), gap = ui.px(theme::kGap);
  const float hex = ImGui::CalcTextSize("hex").x;
  ImGui::SameLine(ImGui::GetWindowWidth() - ui.px(8) - byte - width - hex - 2 * gap);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ui.px(4), ui.px(1)));
  const bool on = brush.is_checked(session, ui);
  if (on) ImGui::PushStyleColor(ImGuiCol_Button, theme::tone(theme::kAccent, 150));
  const bool pressed = ImGui::Button("Paint flags##brush", {width, 0});
  if (on) ImGui::PopStyleColor();
  if (pressed) brush.run(session, actions, ui);
  ui.item("flags/brush", brush.help, keys_of(brush, ui));
  ImGui::SameLine(0, gap);
  const ImVec2 at = ImGui::GetCursorScreenPos();  // a text item would be lowered as the text of tabs is
  ImGui::GetWindowDrawList()->AddText({at.x, at.y + ui.px(1)}, theme::tone(theme::kMuted), "hex");
  ImGui::Dummy({hex, 1});
  ImGui::SameLine(0, gap);
  ImGui::SetNextItemWidth(byte);
  draw_byte(session, actions, ui);
  ImGui::PopStyleVar();
}

void FlagsPanel::draw_byte(const Session& session, Actions& actions, Ui& ui) {
  const Level& level = session.level();
  const SpriteArea& area = session.choices().area;
  const auto flags = common_flags(level, area, 0xff);
  if (!byte_active_) byte_ = flags ? hex_byte(*flags) : "";
  const bool entered =
      input_text("byte", "..", byte_,
                 ImGuiInputTextFlags_CharsHexadecimal | ImGuiInputTextFlags_EnterReturnsTrue |
                     ImGuiInputTextFlags_AutoSelectAll);
  byte_active_ = ImGui::IsItemActive();
  ui.item("flags/byte",
          "All eight flags as two hexadecimal digits, flag 0 the lowest bit; empty where the selected tiles "
          "differ. Enter sets them.");
  if (!entered) return;
  unsigned value = 0;
  const char* end = byte_.data() + byte_.size();
  const auto [rest, code] = std::from_chars(byte_.data(), end, value, 16);
  if (code == std::errc() && rest == end && value <= 0xff)
    actions.push_back(action::EditLevel{set_all_flags(level, area, static_cast<std::uint8_t>(value))});
  else
    actions.push_back(action::ShowMessage{
        "\"" + byte_ + "\" is not a byte of flags: type two hexadecimal digits, 00 to ff.", true});
}

void FlagsPanel::draw_lamp(const Session& session, Actions& actions, Ui& ui, int flag, float width) {
  const Level& level = session.level();
  const std::string number = std::to_string(flag), name = "flags/lamp" + number;
  const FlagRoleInfo* role = role_of_flag(level.roles, flag);
  const TileShape& shape = level.flag_shapes[static_cast<std::size_t>(flag)];
  const FlagLamp lamp = flag_lamp(level, session.choices().area, flag);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ui.px(kFlagRow), menu = ui.px(kFlagRow);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, ui.px(4)));
  if (button("", name, {width - menu, height}))
    actions.push_back(action::EditLevel{toggle_flag(level, session.choices().area, flag)});
  bool opens = ImGui::IsItemClicked(1);
  ui.item(name, lamp_help(level, lamp, flag));
  ImGui::SameLine();
  opens |= draw_menu_button("flags/menu" + number, "Names flag " + number + " and chooses its role or shape.",
                            menu, ui);
  ImGui::PopStyleVar();
  if (opens) menu_.open_flag(level, flag, at.x);

  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_lamp_light(list, {at.x + ui.px(11), at.y + height / 2}, ui.px(6), lamp, flag);
  const std::string label = number + " " + flag_name(level, flag);
  const bool has_physics = role != nullptr || shape.kind != TileShape::Kind::none;
  const float y = at.y + (height - ImGui::GetTextLineHeight()) / 2, right = at.x + width - menu;
  add_short_text(list, {at.x + ui.px(22), y}, right, theme::tone(has_physics ? theme::kText : theme::kMuted),
                 label);
}

void FlagsPanel::draw_field(const Session& session, Actions& actions, Ui& ui, const FlagField& field) {
  const Level& level = session.level();
  const SpriteArea& area = session.choices().area;
  const std::string number = std::to_string(field.first);
  const auto now = common_flags(level, area, field.mask());
  const std::string preview =
      field_name(field) + ": " + (now ? value_name(field, field.value_of(*now)) : "differs");
  const float menu = ui.px(kFlagRow);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, ui.px(4)));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      ImVec2(ui.px(6), (ui.px(kFlagRow) - ImGui::GetFontSize()) / 2));
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - menu);
  const ImVec2 at = ImGui::GetCursorScreenPos(), to{at.x + ImGui::CalcItemWidth(), at.y + ui.px(kFlagRow)};
  const bool open = begin_combo("field" + number, preview);
  const std::string name = "flags/field" + number;
  if (open) {
    ui.place(name, at, to);
    for (int value = 0; value < field.value_count(); ++value) {
      const bool chosen = now && field.value_of(*now) == value;
      if (selectable(value_name(field, value), std::to_string(value), chosen))
        actions.push_back(action::EditLevel{paint_flags(level, area, field.pattern(value), true)});
      ui.item("flags/choice" + std::to_string(value));
    }
    ImGui::EndCombo();
  } else {
    ui.item(name, "The flags " + number + " to " + std::to_string(field.last()) +
                      " of the selected tiles, as one number: choose its value.");
  }
  ImGui::PopStyleVar();
  ImGui::SameLine();
  const bool opens = draw_menu_button("flags/menu" + number, "Names this field and its values.", menu, ui);
  ImGui::PopStyleVar();
  if (opens) menu_.open_field(field.first, at.x);
}

}  // namespace talus
