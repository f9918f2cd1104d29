// The lamps in two columns, each with a menu for its name and role.
#include "flags_panel.h"

#include <imgui_stdlib.h>

#include "canvas_layers.h"
#include "commands.h"
#include "edit/shape_tools.h"
#include "flag_label.h"
#include "shape_editor.h"

namespace talus {
namespace {

void draw_lamp_light(ImDrawList& list, ImVec2 centre, float radius, FlagLamp lamp, int flag) {
  list.AddCircleFilled(centre, radius, theme::color(theme::kDark), 20);
  if (lamp == FlagLamp::all) list.AddCircleFilled(centre, radius - 1, flag_color(flag, 255), 20);
  if (lamp == FlagLamp::some) {  // half lit
    list.PathArcTo(centre, radius - 1, 1.5707963f, 4.7123890f, 12);
    list.PathFillConvex(flag_color(flag, 255));
  }
  list.AddCircle(centre, radius, flag_color(flag, 200), 20);
}

std::string lamp_help(FlagLamp lamp, int flag, const FlagRoleInfo* role, const TileShape& shape) {
  std::string help = "Flag " + std::to_string(flag) + ", ";
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

}  // namespace

void FlagsPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  const float width = (ImGui::GetContentRegionAvail().x - ui.px(4)) / 2;
  for (int row = 0; row < kFlagCount / 2; ++row) {
    draw_lamp(session, actions, ui, row, width);
    ImGui::SameLine();
    draw_lamp(session, actions, ui, row + kFlagCount / 2, width);
  }
  draw_menu(session, actions, ui, menu_flag_);
}

void FlagsPanel::draw_lamp(const Session& session, Actions& actions, Ui& ui, int flag, float width) {
  const Level& level = session.level();
  const std::string number = std::to_string(flag), name = "flags/lamp" + number;
  const FlagRoleInfo* role = role_of_flag(level.roles, flag);
  const TileShape& shape = level.flag_shapes[static_cast<std::size_t>(flag)];
  const FlagLamp lamp = flag_lamp(level, session.choices().area, flag);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ui.px(20), menu = ui.px(20);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, ui.px(4)));
  if (ImGui::Button(("##" + name).c_str(), {width - menu, height}))
    actions.push_back(action::EditLevel{toggle_flag(level, session.choices().area, flag)});
  bool opens = ImGui::IsItemClicked(1);
  ui.item(name, lamp_help(lamp, flag, role, shape));
  ImGui::SameLine();
  opens |= ImGui::Button(("...##menu" + number).c_str(), {menu, height});
  ui.item("flags/menu" + number, "Names flag " + number + " and chooses its role or shape.");
  ImGui::PopStyleVar();
  if (opens) {
    menu_flag_ = flag;
    menu_x_ = ImGui::GetIO().MousePos.x;
    new_name_ = level.flag_names[static_cast<std::size_t>(flag)];
    ImGui::OpenPopup("flag menu");
  }

  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_lamp_light(list, {at.x + ui.px(11), at.y + height / 2}, ui.px(6), lamp, flag);
  const std::string label = number + " " + flag_name(level, flag);
  const bool has_physics = role != nullptr || shape.kind != TileShape::Kind::none;
  const float y = at.y + (height - ImGui::GetTextLineHeight()) / 2;
  list.PushClipRect(at, {at.x + width - menu, at.y + height}, true);
  list.AddText({at.x + ui.px(22), y}, theme::color(has_physics ? theme::kText : theme::kMuted),
               label.c_str());
  list.PopClipRect();
}

void FlagsPanel::draw_menu(const Session& session, Actions& actions, Ui& ui, int flag) {
  // It grows with the shape: upwards, where there is room.
  ImGui::SetNextWindowPos({menu_x_, ui.bars_top}, ImGuiCond_Always, {0, 1});
  if (!ImGui::BeginPopup("flag menu")) return;
  const Level& level = session.level();
  ui.heading("Flag " + std::to_string(flag));
  ImGui::SetNextItemWidth(ui.px(180));
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  const bool named =
      ImGui::InputTextWithHint("##name", "name", &new_name_, ImGuiInputTextFlags_EnterReturnsTrue);
  ui.item("flags/name", "What you call this flag; Enter sets it.");
  if (named) {
    actions.push_back(action::EditLevel{rename_flag(level, flag, new_name_)});
    ImGui::CloseCurrentPopup();
  }
  ui.heading("Role in the physics");
  const FlagRoleInfo* now = role_of_flag(level.roles, flag);
  if (ImGui::RadioButton("none", now == nullptr) && now != nullptr) {
    FlagRoles roles = level.roles;
    roles.*now->flag = FlagRoles::kUnused;
    actions.push_back(action::EditLevel{set_roles(level, roles)});
  }
  ui.item("flags/role_none");
  for (const FlagRoleInfo& info : flag_role_infos()) {
    if (ImGui::RadioButton(std::string(info.label).c_str(), now == &info) && now != &info) {
      FlagRoles roles = level.roles;
      if (now != nullptr) roles.*now->flag = FlagRoles::kUnused;
      roles.*info.flag = flag;
      actions.push_back(action::EditLevel{set_roles(level, roles)});
    }
    ui.item("flags/role_" + std::string(info.key), "Tiles with this flag are this to the physics.");
  }
  draw_flag_shape(session, actions, ui, flag);
  if (ui.text_button("flags/tint", "Tint on the map", session.choices().flag_overlay == flag,
                     "Tints the cells whose tile has this flag.",
                     keys_of(find_command("canvas/flag_tint")))) {
    const bool on = session.choices().flag_overlay != flag;
    actions.push_back(action::SetFlagOverlay{on ? std::optional<int>(flag) : std::optional<int>()});
  }
  ImGui::EndPopup();
}

void FlagsPanel::draw_flag_shape(const Session& session, Actions& actions, Ui& ui, int flag) {
  const Level& level = session.level();
  ui.heading("Shape of tiles without a role");
  const TileShape& now = level.flag_shapes[static_cast<std::size_t>(flag)];
  if (const auto shape = draw_shape("flags/shape", now, session, shape_stroke_, ui))
    actions.push_back(action::EditLevel{set_flag_shape(level, flag, *shape), shape_stroke_});
}

}  // namespace talus
