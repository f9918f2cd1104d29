#include "property_table.h"

#include <algorithm>
#include <array>
#include <utility>

namespace talus {
namespace {

constexpr float kName = 84, kKind = 66, kRemove = 20;  // px at scale 1
constexpr std::size_t kMaxOfName = 60;                 // bytes
constexpr std::size_t kMaxProperties = 1000;           // properties with a field

// Short, as the column is narrow.
const char* short_label(PropertyKind kind) {
  constexpr std::array<const char*, kPropertyKinds> kLabels = {"text", "whole", "number", "yes/no"};
  return kLabels[static_cast<std::size_t>(kind)];
}

// Returns the kind that was chosen; nothing if none was.
std::optional<PropertyKind> draw_kind(const std::string& id, PropertyKind now, Ui& ui) {
  std::optional<PropertyKind> chosen;
  if (!ui.begin_combo(id, short_label(now), ui.px(kKind), "What the value is: text, a number or yes or no."))
    return chosen;
  for (int i = 0; i < kPropertyKinds; ++i) {
    const auto kind = static_cast<PropertyKind>(i);
    if (selectable(label_of(kind), {}, kind == now) && kind != now) chosen = kind;
    ui.item(id + "_" + std::to_string(i));
  }
  ImGui::EndCombo();
  return chosen;
}

float room_for_value(const Ui& ui) {
  return std::max(ui.px(kKind),
                  ImGui::GetContentRegionAvail().x - ui.px(kRemove) - ImGui::GetStyle().ItemSpacing.x);
}

}  // namespace

void PropertyTable::forget() {
  typed_.clear();
  added_.clear();
}

std::optional<PropertyChange> PropertyTable::draw(const std::string& id, const std::string& of,
                                                  const std::string& properties, const std::string& has_field,
                                                  std::optional<std::string>& wrong, Ui& ui) {
  if (properties != text_) {
    text_ = properties;
    properties_ = properties_in(properties);
  }
  std::optional<PropertyChange> change;
  std::size_t row = 0;
  ui.begin_row();
  for (const auto& [name, value] : properties_.items()) {
    if (name == has_field && !has_field.empty()) continue;
    if (row >= kMaxProperties) break;
    if (auto changed = draw_row(id + "_property" + std::to_string(row++), of, name, value, wrong, ui))
      change = std::move(changed);
  }
  if (auto added = draw_new(id, properties_, ui)) change = std::move(added);
  ui.end_row();
  return change;
}

std::optional<PropertyChange> PropertyTable::draw_row(const std::string& id, const std::string& of,
                                                      const std::string& name, const Json& value,
                                                      std::optional<std::string>& wrong, Ui& ui) {
  std::optional<PropertyChange> change;
  ImGui::PushID(id.c_str());
  const float x = ImGui::GetCursorPosX();
  ImGui::AlignTextToFramePadding();
  draw_short_text(shown_line(name, kMaxOfName), ui.px(kName), theme::tone(theme::kText));
  ui.tooltip(shown_line(name));
  ImGui::SameLine();
  ImGui::SetCursorPosX(x + ui.px(kName) + ImGui::GetStyle().ItemSpacing.x);
  if (const auto kind = draw_kind(id + "_kind", kind_of(value), ui))
    change = PropertyChange{name, in_kind(value, *kind)};
  ImGui::SameLine();
  if (auto typed = draw_value(name, value, wrong, ui)) change = PropertyChange{name, std::move(typed)};
  ui.item(id, "The value of this property of the " + of + ".");
  ImGui::SameLine();
  ImGui::SetCursorPosX(x + ui.px(kName + kKind) + room_of_values_ + 3 * ImGui::GetStyle().ItemSpacing.x);
  if (ui.text_button(id + "_remove", "x", false, "Removes the property.", {}, true, ui.px(kRemove)))
    change = PropertyChange{name, std::nullopt};
  ImGui::PopID();
  return change;
}

std::optional<Json> PropertyTable::draw_value(const std::string& name, const Json& value,
                                              std::optional<std::string>& wrong, Ui& ui) {
  room_of_values_ = room_for_value(ui);
  const PropertyKind kind = kind_of(value);
  if (kind == PropertyKind::yes_or_no) {
    bool on = value.get<bool>();
    return ImGui::Checkbox("##value", &on) ? std::optional(Json(on)) : std::nullopt;
  }
  std::string text = typed_ == name ? value_ : text_of_value(value);
  ImGui::SetNextItemWidth(room_of_values_);
  input_text("value", "empty", text);
  if (ImGui::IsItemActive()) {
    typed_ = name;
    value_ = text;
  }
  if (!ImGui::IsItemDeactivated() || typed_ != name) return std::nullopt;
  typed_.clear();
  if (!ImGui::IsItemDeactivatedAfterEdit()) return std::nullopt;
  auto typed = value_of_text(text, kind);
  if (!typed) wrong = "Not changed: this property must be a " + std::string(label_of(kind)) + ".";
  return typed && *typed != value ? typed : std::nullopt;
}

// Enter in the name's field adds the property, too.
std::optional<PropertyChange> PropertyTable::draw_new(const std::string& id, const Json& properties, Ui& ui) {
  ImGui::SetNextItemWidth(ui.px(kName));
  const bool entered = input_text("new property", "new name", added_, ImGuiInputTextFlags_EnterReturnsTrue);
  ui.item(id + "_new_property", "The name of a property that games read, such as \"door\".", "Enter adds it");
  ImGui::SameLine();
  if (const auto kind = draw_kind(id + "_new_kind", kind_, ui)) kind_ = *kind;
  ImGui::SameLine();
  const bool is_new = !added_.empty() && !properties.contains(added_);
  const bool pressed = ui.text_button(id + "_add_property", "Add", false, "Adds a property with this name.");
  if (!is_new || !(pressed || entered)) return std::nullopt;
  const Json value = kind_ == PropertyKind::text ? Json("") : in_kind(Json(""), kind_);
  return PropertyChange{std::exchange(added_, {}), value};
}

}  // namespace talus
