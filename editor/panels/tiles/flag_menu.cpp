// One popup for a flag or a field.
#include "flag_menu.h"

#include <imgui_internal.h>

#include <algorithm>
#include <span>
#include <utility>

#include "edit/flag_tools.h"
#include "edit/level_settings.h"
#include "edit/shape_tools.h"
#include "edit/tile_shapes.h"
#include "flag_label.h"
#include "panels/commands/commands.h"
#include "shape_editor.h"

namespace talus {
namespace {

constexpr const char* kPopup = "flag menu";
constexpr int kMaxValueRows = 8;  // with more rows it scrolls

// How many flags a field from there on can have: none that has no lamp.
int most_bits_shown(const Level& level, std::span<const FlagField> others, int first) {
  return std::min(most_bits(others, first), shown_flags(level) - first);
}

std::vector<FlagField> fields_without(const Level& level, std::size_t index) {
  std::vector<FlagField> others = level.flag_fields;
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(index));
  return others;
}

// A field that grows with the name, so that all of it can be read. least: px at scale 1. Returns the result
// of InputText.
bool draw_name(const char* id, const char* hint, std::string& name, float least, Ui& ui,
               ImGuiInputTextFlags flags = 0) {
  constexpr float kMax = 480;  // px at scale 1
  const float text = size_of_text(name + "W").x + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::SetNextItemWidth(std::clamp(text, ui.px(least), ui.px(kMax)));
  const bool result = input_text(id, hint, name, flags);
  // It scrolled to what was typed before it grew.
  if (ImGuiInputTextState* state = ImGui::GetInputTextState(ImGui::GetItemID()); state && text < ui.px(kMax))
    state->ScrollX = 0;
  return result;
}

}  // namespace

void FlagMenu::open_flag(const Level& level, int flag, float at_x) {
  x_ = at_x;
  show_flag(level, flag);
  opens_ = true;
}

void FlagMenu::open_field(int first_flag, float at_x) {
  x_ = at_x;
  show_field(first_flag);
  opens_ = true;
}

void FlagMenu::show_flag(const Level& level, int flag) {
  flag_ = flag;
  is_field_ = false;
  wants_keys_ = true;
  new_name_ = level.flag_names[static_cast<std::size_t>(flag)];
}

void FlagMenu::show_field(int first_flag) {
  flag_ = first_flag;
  is_field_ = true;
  wants_keys_ = true;
}

void FlagMenu::draw(const Session& session, Actions& actions, Ui& ui) {
  if (std::exchange(opens_, false)) ImGui::OpenPopup(kPopup);
  // It grows with its content: upwards, if there is room.
  ImGui::SetNextWindowPos({x_, ui.bars_top}, ImGuiCond_Always, {0, 1});
  if (!ImGui::BeginPopup(kPopup)) return;
  const auto& fields = session.level().flag_fields;
  const FlagField* field = is_field_ ? field_of_flag(fields, flag_) : nullptr;
  if (field != nullptr)
    draw_field(session, actions, ui, static_cast<std::size_t>(field - fields.data()));
  else
    draw_flag(session, actions, ui);
  ImGui::EndPopup();
}

void FlagMenu::draw_flag(const Session& session, Actions& actions, Ui& ui) {
  const Level& level = session.level();
  ui.heading("Flag " + std::to_string(flag_));
  if (std::exchange(wants_keys_, false)) ImGui::SetKeyboardFocusHere();
  const bool named = draw_name("name", "name", new_name_, 180, ui, ImGuiInputTextFlags_EnterReturnsTrue);
  ui.item("flags/name", "The name of this flag; Enter sets it.");
  if (named) {
    actions.push_back(action::EditLevel{rename_flag(level, flag_, new_name_)});
    ImGui::CloseCurrentPopup();
  }
  draw_role(level, actions, ui);
  draw_shape_of_flag(session, actions, ui);
  draw_place_in_field(level, actions, ui);
  const FlagPattern pattern = pattern_of_flag(flag_);
  const bool tinted = session.choices().flag_overlay == pattern;
  if (ui.text_button("flags/tint", "Tint on the map", tinted,
                     "Tints the cells and the tiles of the sheet that have this flag.",
                     keys_of("canvas/flag_tint"_command, ui)))
    actions.push_back(action::SetFlagOverlay{tinted ? std::optional<FlagPattern>() : pattern});
}

void FlagMenu::draw_role(const Level& level, Actions& actions, Ui& ui) const {
  ui.heading("Role in the physics");
  const FlagRoleInfo* now = role_of_flag(level.roles, flag_);
  if (ImGui::RadioButton("none", now == nullptr) && now != nullptr) {
    FlagRoles roles = level.roles;
    roles.*now->flag = FlagRoles::kUnused;
    actions.push_back(action::EditLevel{set_roles(level, roles)});
  }
  ui.item("flags/role_none");
  for (const FlagRoleInfo& info : flag_role_infos()) {
    if (radio_button(info.label, {}, now == &info) && now != &info) {
      FlagRoles roles = level.roles;
      if (now != nullptr) roles.*now->flag = FlagRoles::kUnused;
      roles.*info.flag = flag_;
      actions.push_back(action::EditLevel{set_roles(level, roles)});
    }
    ui.item("flags/role_" + std::string(info.key), "Tiles with this flag are this to the physics.");
  }
}

void FlagMenu::draw_shape_of_flag(const Session& session, Actions& actions, Ui& ui) {
  const Level& level = session.level();
  ui.heading("Shape of tiles without a role");
  const TileShape& now = level.flag_shapes[static_cast<std::size_t>(flag_)];
  if (const auto kind = choose_shape_kind("flags/shape", now.kind, std::string(kind_label(now)), ui))
    actions.push_back(
        action::EditLevel{set_flag_shape(level, flag_, with_kind(now, *kind, level.map.tile_size()))});
  if (const auto shape = draw_shape_fields("flags/shape", now, session, shape_edit_, actions, ui))
    actions.push_back(action::EditLevel{set_flag_shape(level, flag_, *shape), shape_edit_.stroke});
  draw_shape_of_tile(session, actions, ui);
}

// Polygons have many points: they are drawn in the shape editor of a tile.
void FlagMenu::draw_shape_of_tile(const Session& session, Actions& actions, Ui& ui) const {
  const SpriteArea& area = session.choices().area;
  if (area.sheet != SheetId::tiles) return;
  const int tile = area.tile_at(session.level(), 0, 0);
  const TileShape shape = shape_of_tile(session.level(), static_cast<TileNumber>(tile));
  if (ui.text_button("flags/shape_of_tile", "Take the shape of tile " + std::to_string(tile), false,
                     "Gives this flag the shape of the selected tile, also a polygon or a group.", {},
                     shape.kind != TileShape::Kind::none))
    actions.push_back(action::EditLevel{set_flag_shape(session.level(), flag_, shape)});
}

// Makes a field with the next flag, or goes back to the field that it is in.
void FlagMenu::draw_place_in_field(const Level& level, Actions& actions, Ui& ui) {
  if (const FlagField* field = field_of_flag(level.flag_fields, flag_)) {
    if (ui.text_button("flags/to_field", "Back to " + field_name(*field), false,
                       "This flag is a part of that field."))
      show_field(field->first);
    return;
  }
  const bool possible = most_bits_shown(level, level.flag_fields, flag_) >= FlagField::kLeastBits;
  const std::string label = "Make a field with flag " + std::to_string(flag_ + 1);
  if (!ui.text_button("flags/make_field", possible ? label : "Make a field", false,
                      "Reads this flag and the next as one number, whose values have names, such as the "
                      "kind of a slope.",
                      {}, possible))
    return;
  FlagField field;
  field.first = flag_;
  actions.push_back(action::EditLevel{set_flag_field(level, level.flag_fields.size(), field)});
  show_field(flag_);
}

void FlagMenu::draw_field(const Session& session, Actions& actions, Ui& ui, std::size_t index) {
  const Level& level = session.level();
  const FlagField& field = level.flag_fields[index];
  ui.heading("Field of flags " + std::to_string(field.first) + " to " + std::to_string(field.last()));
  if (std::exchange(wants_keys_, false)) ImGui::SetKeyboardFocusHere();
  FlagField changed = field;
  if (draw_name("field_name", "name, such as slope kind", changed.name, 200, ui))
    actions.push_back(action::EditLevel{set_flag_field(level, index, changed), text_stroke_});
  if (ImGui::IsItemActivated()) text_stroke_ = session.next_stroke();
  ui.item("flags/field_name", "The name of this field.");
  draw_bits(level, actions, ui, index);
  draw_values(session, actions, ui, index);
  draw_flags_of_field(level, ui, field);
  ImGui::Spacing();
  if (ui.text_button("flags/remove_field", "Take apart", false,
                     "Splits it into single flags again; the tiles keep their flags.")) {
    actions.push_back(action::EditLevel{remove_flag_field(level, index)});
    ImGui::CloseCurrentPopup();
  }
}

void FlagMenu::draw_bits(const Level& level, Actions& actions, Ui& ui, std::size_t index) const {
  FlagField field = level.flag_fields[index];
  const int most = most_bits_shown(level, fields_without(level, index), field.first), before = field.bits;
  if (ui.text_button("flags/field_narrower", "-", false, "Takes the last flag out of it.", {},
                     before > FlagField::kLeastBits, ui.px(24)))
    --field.bits;
  ImGui::SameLine();
  if (ui.text_button("flags/field_wider", "+", false, "Takes the next flag into it.", {}, before < most,
                     ui.px(24)))
    ++field.bits;
  ImGui::SameLine();
  ui.label(std::to_string(before) + " bits, " + std::to_string(1 << before) + " values");
  if (field.bits == before) return;
  if (field.values.size() > static_cast<std::size_t>(field.value_count()))
    field.values.resize(static_cast<std::size_t>(field.value_count()));
  actions.push_back(action::EditLevel{set_flag_field(level, index, field)});
}

void FlagMenu::draw_values(const Session& session, Actions& actions, Ui& ui, std::size_t index) {
  const FlagField& field = session.level().flag_fields[index];
  ui.heading("Names of its values");
  const int rows = std::min(field.value_count(), kMaxValueRows);
  const float row = ImGui::GetFrameHeightWithSpacing();
  ImGui::BeginChild("values", {ui.px(200), static_cast<float>(rows) * row});
  for (int value = 0; value < field.value_count(); ++value) {
    const auto at = static_cast<std::size_t>(value);
    const std::string number = std::to_string(value);
    ImGui::AlignTextToFramePadding();
    ui.muted(number);
    ImGui::SameLine(ui.px(32));
    ImGui::SetNextItemWidth(-1);
    std::string name = at < field.values.size() ? field.values[at] : "";
    if (input_text("value" + number, "name", name)) {
      FlagField changed = field;
      if (changed.values.size() <= at) changed.values.resize(at + 1);
      changed.values[at] = name;
      while (!changed.values.empty() && changed.values.back().empty()) changed.values.pop_back();
      actions.push_back(action::EditLevel{set_flag_field(session.level(), index, changed), text_stroke_});
    }
    if (ImGui::IsItemActivated()) text_stroke_ = session.next_stroke();
    ui.item("flags/value" + number, "What the value " + number + " stands for.");
  }
  ImGui::EndChild();
}

void FlagMenu::draw_flags_of_field(const Level& level, Ui& ui, const FlagField& field) {
  ui.heading("Its flags, with roles and shapes of their own");
  for (int flag = field.first; flag <= field.last(); ++flag) {
    const std::string number = std::to_string(flag);
    if (ui.text_button("flags/part" + number, flag_label(level, flag), false,
                       "Names flag " + number + " and chooses its role or shape."))
      show_flag(level, flag);
    if (flag < field.last()) ui.same_line_if_fits(ui.px(96));
  }
}

}  // namespace talus
