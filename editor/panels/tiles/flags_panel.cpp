// The lamps in two columns, with the fields below. Each has a menu for its names and its role.
#include "flags_panel.h"

#include <imgui_internal.h>

#include <algorithm>
#include <charconv>

#include "edit/flag_lamps.h"
#include "edit/flag_tools.h"
#include "flag_label.h"
#include "panels/canvas/canvas_layers.h"
#include "panels/commands/commands.h"
#include "shape_editor.h"

namespace talus {
namespace {

constexpr float kFlagRow = 20, kRowGap = 4, kMoreWidth = 20;  // px at scale 1

// A cart has no more flags. Those that it gets from its companion have lamps, too.
bool has_lamps_to_add(const Level& level) { return level.cart == nullptr && shown_flags(level) < kMaxFlags; }

// The ring of an unlit lamp; on light ground a tint is too pale.
ImU32 ring_color(int flag) {
  if (!theme::is_light()) return flag_color(flag, 200);
  constexpr float kDarker = 0.6f;
  const ImVec4 tint = ImGui::ColorConvertU32ToFloat4(flag_color(flag, 255));
  return ImGui::GetColorU32({tint.x * kDarker, tint.y * kDarker, tint.z * kDarker, 1});
}

void draw_lamp_light(ImDrawList& list, ImVec2 centre, float radius, FlagLamp lamp, int flag) {
  const ImU32 unlit = theme::is_light() ? theme::tone(theme::kBackground) : theme::color(theme::kDark);
  list.AddCircleFilled(centre, radius, unlit, 20);
  if (lamp == FlagLamp::all) list.AddCircleFilled(centre, radius - 1, flag_color(flag, 255), 20);
  if (lamp == FlagLamp::some) {  // half lit
    list.PathArcTo(centre, radius - 1, 1.5707963f, 4.7123890f, 12);
    list.PathFillConvex(flag_color(flag, 255));
  }
  list.AddCircle(centre, radius, ring_color(flag), 20);
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

// As many digits as the shown flags need.
std::string hex_digits(FlagSet flags, int shown) {
  std::string text;
  for (int bit = shown - 4; bit >= 0; bit -= 4) text += "0123456789abcdef"[flags >> bit & 15];
  return text;
}

// The flags of eight that are in no field.
std::vector<int> single_flags(const Level& level, int first) {
  std::vector<int> flags;
  for (int flag = first; flag < first + kCartFlags; ++flag)
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

float height_of_more_flags(const Level& level, const Ui& ui) {
  const auto& fields = level.flag_fields;
  auto rows = std::count_if(fields.begin(), fields.end(),
                            [](const FlagField& field) { return field.first >= kCartFlags; });
  for (int first = kCartFlags; first < shown_flags(level); first += kCartFlags)
    rows += (std::ssize(single_flags(level, first)) + 1) / 2;
  return static_cast<float>(rows) * ui.px(kFlagRow + kRowGap);
}

void FlagsPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  const Level& level = session.level();
  const int shown = shown_flags(level);
  now_ = flags_in(level, session.choices().area);
  draw_header(session, actions, ui);
  const bool scrolls = shown > kCartFlags;
  if (scrolls)
    ImGui::BeginChild("lamps", ImGui::GetContentRegionAvail(), false, ImGuiWindowFlags_NavFlattened);
  for (int first = 0; first < shown; first += kCartFlags) draw_eight(session, actions, ui, first);
  if (scrolls) ImGui::EndChild();
  for (int flag = shown; flag < kMaxFlags; ++flag) {  // a command opens the menu of a flag without a lamp
    if (ui.view.requests.take<request::FocusField>("flags/menu" + std::to_string(flag)))
      menu_.open_flag(level, flag, ImGui::GetCursorScreenPos().x);
  }
  menu_.draw(session, actions, ui);
}

void FlagsPanel::draw_eight(const Session& session, Actions& actions, Ui& ui, int first) {
  const float width = (ImGui::GetContentRegionAvail().x - ui.px(kRowGap)) / 2;
  const std::vector<int> flags = single_flags(session.level(), first);
  const std::size_t rows = (flags.size() + 1) / 2;
  for (std::size_t row = 0; row < rows; ++row) {
    draw_lamp(session, actions, ui, flags[row], width);
    if (row + rows >= flags.size()) continue;
    ImGui::SameLine();
    draw_lamp(session, actions, ui, flags[row + rows], width);
  }
  for (const FlagField& field : session.level().flag_fields)
    if (field.first >= first && field.first < first + kCartFlags) draw_field(session, actions, ui, field);
}

// In line with the panel's tab; what has no room there is left out: the word, and then the number.
void FlagsPanel::draw_header(const Session& session, Actions& actions, Ui& ui) {
  const Level& level = session.level();
  const Command& brush = find_command("flags/brush"_command);
  const int digits = shown_flags(level) / 4;
  const bool has_more = has_lamps_to_add(level), is_short = has_more || digits > 2;
  const float number = ui.px(14 + 7 * static_cast<float>(digits)), width = ui.px(is_short ? 42 : 80);
  const float gap = ui.px(theme::kGap), more = has_more ? ui.px(kMoreWidth) + gap : 0;
  const ImGuiTabBar* tabs = ImGui::GetCurrentContext()->CurrentTabBar;
  const float used = tabs != nullptr ? tabs->BarRect.Min.x + tabs->WidthAllTabs - ImGui::GetWindowPos().x : 0;
  const float without_number = ImGui::GetWindowWidth() - ui.px(8) - more - width;
  const bool has_number = used <= without_number - number - gap;
  float hex = ImGui::CalcTextSize("hex").x + gap;
  float x = has_number ? without_number - number - gap : without_number;
  if (!has_number || x - hex < used) hex = 0;
  x -= hex;
  if (used <= x)
    ImGui::SameLine(x);
  else
    ImGui::SetCursorPosX(x);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ui.px(4), ui.px(1)));
  if (has_more) draw_more(level, ui);
  const bool on = brush.is_checked(session, ui);
  if (on) ImGui::PushStyleColor(ImGuiCol_Button, theme::tone(theme::kAccent, 150));
  const bool pressed =
      is_short ? ImGui::Button("Paint##brush", {width, 0}) : ImGui::Button("Paint flags##brush", {width, 0});
  if (on) ImGui::PopStyleColor();
  if (pressed) brush.run(session, actions, ui);
  ui.item("flags/brush", brush.help, keys_of(brush, ui));
  if (hex > 0) {
    ImGui::SameLine(0, gap);
    const ImVec2 at = ImGui::GetCursorScreenPos();  // a text item would be lowered as the text of tabs is
    ImGui::GetWindowDrawList()->AddText({at.x, at.y + ui.px(1)}, theme::tone(theme::kMuted), "hex");
    ImGui::Dummy({hex - gap, 1});
  }
  if (has_number) {
    ImGui::SameLine(0, gap);
    ImGui::SetNextItemWidth(number);
    draw_number(session, actions, ui);
  }
  ImGui::PopStyleVar();
}

// A flag that is named, or gets a role or a shape, has a lamp, and so do the seven flags after it.
void FlagsPanel::draw_more(const Level& level, Ui& ui) {
  const int flag = shown_flags(level);
  const std::string number = std::to_string(flag);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (ImGui::Button("+##more", {ui.px(kMoreWidth), 0})) menu_.open_flag(level, flag, at.x);
  ui.item("flags/more", "Names flag " + number + ", which shows the lamps of the flags " + number + " to " +
                            std::to_string(flag + kCartFlags - 1) + ". A cart has only the flags 0 to 7.");
  ImGui::SameLine(0, ui.px(theme::kGap));
}

void FlagsPanel::draw_number(const Session& session, Actions& actions, Ui& ui) {
  const int shown = shown_flags(session.level());
  if (!number_active_) number_ = now_.any == now_.all ? hex_digits(now_.all, shown) : "";
  const bool entered =
      input_text("byte", "..", number_,
                 ImGuiInputTextFlags_CharsHexadecimal | ImGuiInputTextFlags_EnterReturnsTrue |
                     ImGuiInputTextFlags_AutoSelectAll);
  number_active_ = ImGui::IsItemActive();
  const std::string digits = shown == kCartFlags ? "two" : std::to_string(shown / 4);
  ui.item("flags/byte", "All " + (shown == kCartFlags ? "eight" : std::to_string(shown)) + " flags as " +
                            digits +
                            " hexadecimal digits, flag 0 the lowest bit; empty where the selected tiles "
                            "differ. Enter sets them.");
  if (!entered) return;
  FlagSet flags = 0;
  const char* end = number_.data() + number_.size();
  const auto [rest, code] = std::from_chars(number_.data(), end, flags, 16);
  if (code == std::errc() && rest == end && (shown == kMaxFlags || flags >> shown == 0))
    actions.push_back(action::EditLevel{set_all_flags(session.level(), session.choices().area, flags)});
  else
    actions.push_back(action::ShowMessage{"\"" + number_ + "\" is no number of flags: type " + digits +
                                              " hexadecimal digits, " + hex_digits(0, shown) + " to " +
                                              std::string(static_cast<std::size_t>(shown) / 4, 'f') + ".",
                                          true});
}

void FlagsPanel::draw_lamp(const Session& session, Actions& actions, Ui& ui, int flag, float width) {
  const Level& level = session.level();
  const std::string number = std::to_string(flag), name = "flags/lamp" + number;
  const FlagRoleInfo* role = role_of_flag(level.roles, flag);
  const TileShape& shape = level.flag_shapes[static_cast<std::size_t>(flag)];
  const FlagLamp lamp = now_.lamp(flag);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ui.px(kFlagRow), menu = ui.px(kFlagRow);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, ui.px(kRowGap)));
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
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, ui.px(kRowGap)));
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
