// Kind, name and start of a placed body.
#include "spawn_inspector.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "edit/spawn_tools.h"
#include "overlay/number_label.h"

namespace talus {
namespace {

// A list with two entries. Returns the index of the new choice, or nothing.
std::optional<int> draw_choice(std::string_view name, std::array<std::string_view, 2> labels, bool second,
                               std::string_view help, Ui& ui) {
  std::optional<int> chosen;
  if (!ui.begin_combo(name, std::string(labels[second]), ui.px(76), help)) return chosen;
  for (int i = 0; i < 2; ++i) {
    const std::string label(labels[static_cast<std::size_t>(i)]);
    if (selectable(label, {}, second == (i == 1))) chosen = i;
    ui.item(std::string(name) + "_" + label);
  }
  ImGui::EndCombo();
  return chosen;
}

const Spawn& spawn_of(const Session& session, int index) {
  return session.level().spawns[static_cast<std::size_t>(index)];
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
  draw_kind(session, index, actions, ui);
  draw_name(session, index, actions, ui);
  draw_start(session, index, actions, ui);
  if (spawn_of(session, index).kind == BodyKind::player && session.level().tuning.solver != SolverKind::exact)
    ui.hint("Players run only with the exact solver: see Tuning.");
}

void SpawnInspector::draw_kind(const Session& session, int index, Actions& actions, Ui& ui) {
  Spawn spawn = spawn_of(session, index);
  const auto kind = draw_choice("inspector/kind", {"ball", "player"}, spawn.kind == BodyKind::player,
                                "A ball falls and bounces; a player runs and jumps by the keys, with the "
                                "exact solver.",
                                ui);
  ImGui::SameLine();
  ui.heading("foot");
  ImGui::SameLine();
  const auto foot = draw_choice("inspector/foot", {"box", "centre"}, spawn.used_foot() == Foot::centre,
                                "What stands on slopes: the whole bottom side of the box, or its centre, "
                                "which sinks the box into them.",
                                ui);
  ui.same_line_if_fits(ui.px(56));
  if (ui.text_button("inspector/copy", "Copy", false, "Adds another one like it beside it.", "Ctrl+D")) {
    actions.push_back(action::EditLevel{duplicate_spawn(session.level(), index)});
    actions.push_back(action::SelectSpawn{static_cast<int>(session.level().spawns.size())});
  }
  ui.same_line_if_fits(ui.px(64));
  if (ui.text_button("inspector/remove", "Remove", false, "Removes the body from the level."))
    actions.push_back(action::EditLevel{remove_spawn(session.level(), index)});
  if (kind) {
    spawn.kind = *kind == 1 ? BodyKind::player : BodyKind::ball;
    change(session, index, spawn, "Make a body a " + std::string(*kind == 1 ? "player" : "ball"), 0, actions);
  } else if (foot) {
    spawn.foot = *foot == 1 ? Foot::centre : Foot::box;
    change(session, index, spawn, "Change a body's foot", 0, actions);
  }
}

void SpawnInspector::draw_name(const Session& session, int index, Actions& actions, Ui& ui) {
  Spawn spawn = spawn_of(session, index);
  if (index != shown_) name_ = spawn.name;
  shown_ = index;
  ImGui::SetNextItemWidth(ui.px(220));
  input_text("spawn name", "name", name_);
  ui.item("inspector/spawn_name", "What you call this body.");
  if (ImGui::IsItemDeactivatedAfterEdit() && name_ != spawn.name) {
    spawn.name = name_;
    change(session, index, std::move(spawn), "Name a body", 0, actions);
  } else if (!ImGui::IsItemActive()) {
    name_ = spawn.name;  // Undo may have changed it
  }
}

void SpawnInspector::draw_start(const Session& session, int index, Actions& actions, Ui& ui) {
  Spawn spawn = spawn_of(session, index);
  bool changed = false;
  const auto number = [&](const std::string& part, double& value, const char* help, float speed) {
    if (part != "x") ui.same_line_if_fits(ui.px(76));
    const std::string name = "inspector/start_" + part, format = part + " %.8g";
    double edited = value;
    if (!draw_number_field({name, format.c_str(), help, 76, speed}, edited, session, number_, ui)) return;
    if (std::abs(edited) > kMaxCoordinate) return refuse(part, actions);
    value = edited;
    changed = true;
  };
  ui.heading("Starts at");
  number("x", spawn.position.x, "Where its box's left side starts, px.", 1);
  number("y", spawn.position.y, "Where its box's top starts, px.", 1);
  number("vx", spawn.velocity.x, "Its speed to the right at the start, px/frame.", 0.05f);
  number("vy", spawn.velocity.y, "Its speed downwards at the start, px/frame.", 0.05f);
  if (changed) change(session, index, std::move(spawn), "Change how a body starts", number_.stroke, actions);
}

}  // namespace talus
