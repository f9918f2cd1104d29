// Kind, name and start of a placed body.
#include "spawn_inspector.h"

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "chosen_spawn.h"
#include "edit/body_frames.h"
#include "edit/spawn_tools.h"
#include "exact_hint.h"
#include "level/single_change.h"
#include "overlay/number_label.h"
#include "panels/commands/commands.h"
#include "panels/ui/text_field.h"

namespace talus {
namespace {

// A list. Returns the index of the new choice, or nothing.
std::optional<std::size_t> draw_choice(std::string_view name, std::span<const std::string_view> labels,
                                       std::size_t now, std::string_view help, Ui& ui) {
  std::optional<std::size_t> chosen;
  if (!ui.begin_combo(name, std::string(labels[now]), ui.px(kFormField), help)) return chosen;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const std::string label(labels[i]);
    if (selectable(label, {}, i == now)) chosen = i;
    ui.item(std::string(name) + "_" + label);
  }
  ImGui::EndCombo();
  return chosen;
}

void change(const Session& session, int index, Spawn spawn, std::string label, int stroke, Actions& actions) {
  actions.push_back(
      action::EditLevel{change_spawn(session.level(), index, std::move(spawn), std::move(label)), stroke});
}

// Nothing can be further away, or faster.
void refuse(const std::string& part, Actions& actions) {
  const std::string most = no_decimals(kMaxCoordinate);
  actions.push_back(action::ShowMessage{
      "Not changed: " + part + " must be a number from -" + most + " to " + most + ".", true});
}

}  // namespace

void SpawnInspector::draw(const Session& session, int index, Actions& actions, Ui& ui) {
  ui.begin_row();
  draw_name(session, index, actions, ui);
  draw_kind(session, index, actions, ui);
  draw_foot(session, index, actions, ui);
  draw_start(session, index, actions, ui);
  draw_size(session, index, actions, ui);
  ui.end_row();
  if (traits_of(spawn_of(session, index).kind).takes_keys)
    draw_exact_hint("Players run only with the exact solver.", "inspector/exact", session, actions, ui);
  picture_.draw(session, index, actions, ui);
}

void SpawnInspector::draw_name(const Session& session, int index, Actions& actions, Ui& ui) {
  Spawn spawn = spawn_of(session, index);
  if (index != shown_) name_ = spawn.name;
  shown_ = index;
  if (!draw_text_field({"Name", "inspector/spawn_name", "no name", "The name of this body."}, name_,
                       spawn.name, ui))
    return;
  spawn.name = name_;
  change(session, index, std::move(spawn), "Name a body", 0, actions);
}

void SpawnInspector::draw_kind(const Session& session, int index, Actions& actions, Ui& ui) {
  std::vector<std::string_view> words;
  std::string help;
  for (const BodyTraits& traits : body_kinds()) {
    words.push_back(traits.word);
    help.append(help.empty() ? "" : " ").append(traits.help);
  }
  Spawn spawn = spawn_of(session, index);
  ui.field_label("Kind");
  const auto kind = draw_choice("inspector/kind", words, static_cast<std::size_t>(spawn.kind), help, ui);
  ImGui::SameLine();
  command_text_button("map/duplicate"_command, session, actions, ui,
                      {.label = "Copy", .widget = "inspector/copy", .width = ui.px(kFormField)});
  if (!kind) return;
  spawn.kind = static_cast<BodyKind>(*kind);
  change(session, index, spawn, "Make a body a " + std::string(words[*kind]), 0, actions);
}

void SpawnInspector::draw_foot(const Session& session, int index, Actions& actions, Ui& ui) {
  static constexpr std::array<std::string_view, 2> kFeet = {"box", "centre"};
  Spawn spawn = spawn_of(session, index);
  ui.field_label("Foot");
  const auto foot = draw_choice("inspector/foot", kFeet, spawn.used_foot() == Foot::centre ? 1 : 0,
                                "What stands on slopes: the whole bottom side of the box, or its centre, "
                                "which sinks the box into them.",
                                ui);
  ImGui::SameLine();
  if (ui.text_button("inspector/remove", "Remove", false, "Removes the body from the level.", {}, true,
                     ui.px(kFormField)))
    actions.push_back(action::EditLevel{remove_spawn(session.level(), index)});
  if (!foot) return;
  spawn.foot = *foot == 1 ? Foot::centre : Foot::box;
  change(session, index, spawn, "Change a body's foot", 0, actions);
}

void SpawnInspector::draw_start(const Session& session, int index, Actions& actions, Ui& ui) {
  Spawn spawn = spawn_of(session, index);
  bool changed = false;
  const auto number = [&](const std::string& part, double& value, const char* help, float speed,
                          std::optional<double> standard = {}) {
    const std::string name = "inspector/start_" + part, format = part + " %.8g";
    double edited = value;
    if (!draw_number_field({name, format.c_str(), help, kFormField, speed, standard}, edited, session,
                           number_, ui))
      return;
    if (std::abs(edited) > kMaxCoordinate) return refuse(part, actions);
    value = edited;
    changed = true;
  };
  ui.field_label("Start");
  number("x", spawn.position.x, "Where its box's left side starts, px.", 1);
  ImGui::SameLine();
  number("y", spawn.position.y, "Where its box's top starts, px.", 1);
  ui.field_label("Speed");
  number("vx", spawn.velocity.x, "Its speed to the right at the start, px/frame.", 0.05f, 0);
  ImGui::SameLine();
  number("vy", spawn.velocity.y, "Its speed downwards at the start, px/frame.", 0.05f, 0);
  if (changed) change(session, index, std::move(spawn), "Change how a body starts", number_.stroke, actions);
}

// The middle of its bottom stays: that is where it stands.
void SpawnInspector::draw_size(const Session& session, int index, Actions& actions, Ui& ui) {
  const Spawn& spawn = spawn_of(session, index);
  const Vec2 standard = new_body_size(spawn.kind, session.level().map.tile_size());
  Vec2 size = spawn.size;
  bool changed = false;
  const auto number = [&](const std::string& part, double& value, const std::string& help, double of_new) {
    const std::string name = "inspector/size_" + part, format = part + " %.8g";
    changed |=
        draw_number_field({name, format.c_str(), help, kFormField, 1, of_new}, value, session, number_, ui);
  };
  ui.field_label("Size");
  const std::string by_hand =
      " With the body tool (" + keys_of("map/body"_command, ui) + ") the box on the map has handles.";
  number("w", size.x, "The width of its box, px. The middle of its bottom stays where it is." + by_hand,
         standard.x);
  ImGui::SameLine();
  number("h", size.y, "The height of its box, px. Its bottom stays where it is." + by_hand, standard.y);
  if (changed)
    change(session, index, with_size(spawn, size), "Change a body's size", number_.stroke, actions);
}

}  // namespace talus
