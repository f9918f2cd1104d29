// The commands of the layers of the map.
#include <string>
#include <utility>

#include "command_table.h"
#include "edit/group_tools.h"
#include "edit/layer_tools.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;

int chosen_layer(S session) { return session.level().layers.chosen; }
const TileLayer& looks_of_chosen(S session) {
  return session.level().layers.list[static_cast<std::size_t>(chosen_layer(session))];
}
int chosen_group_of(S session, const Ui& ui) { return chosen_group(ui.view.level, session.level()); }
bool has_groups(S session) { return !session.level().layers.groups.empty(); }
// What commands work on: the chosen group, or the chosen layer.
LayerNode chosen_node(S session, const Ui& ui) {
  const auto group = node_of_group(session.level(), chosen_group_of(session, ui));
  return group ? *group : node_of_layer(session.level(), chosen_layer(session));
}
bool has_layer_above(S session, const Ui&) {
  return chosen_layer(session) + 1 < session.level().layers.count();
}
bool has_layer_below(S session, const Ui&) { return chosen_layer(session) > 0; }
bool has_several_layers(S session, const Ui&) { return session.level().layers.count() > 1; }
bool can_move_forwards(S session, const Ui& ui) {
  return has_groups(session) || has_layer_above(session, ui);
}
bool can_move_backwards(S session, const Ui& ui) {
  return has_groups(session) || has_layer_below(session, ui);
}
// The chosen group, or the one that the chosen layer is in; -1: none.
int nearest_group(S session, const Ui& ui) {
  const int group = chosen_group_of(session, ui);
  return group >= 0 ? group : looks_of_chosen(session).group;
}
bool is_in_group(S session, const Ui& ui) { return nearest_group(session, ui) >= 0; }

CommandRun choose_layer_beside(int by) {
  return [by](S session, A actions, U ui) {
    ui.view.level.group = {};
    actions.push_back(action::ChooseLayer{chosen_layer(session) + by});
  };
}

CommandRun move_chosen_layer(int by) {
  return [by](S session, A actions, U ui) {
    const int layer = chosen_layer(session);
    emit_edit(actions, has_groups(session) ? step_node(session.level(), chosen_node(session, ui), by > 0)
                                           : move_layer(session.level(), layer, layer + by));
  };
}

void add_layer_in_front(S session, A actions, U ui) {
  ui.ask(request::ShowTab(panel_id::kLayers));
  emit_edit(actions, add_layer(session.level()));
}

void duplicate_chosen(S session, A actions, U ui) {
  const int group = chosen_group_of(session, ui);
  ui.ask(request::ShowTab(panel_id::kLayers));
  emit_edit(actions, group >= 0 ? duplicate_group(session.level(), group)
                                : duplicate_layer(session.level(), chosen_layer(session)));
}

// A group with something in it is asked about.
void delete_chosen(S session, A actions, U ui) {
  const Level& level = session.level();
  const int group = chosen_group_of(session, ui);
  ui.ask(request::ShowTab(panel_id::kLayers));
  if (group < 0) return emit_edit(actions, remove_layer(level, chosen_layer(session)));
  Edit edit = remove_group(level, group);
  if (edit.empty())
    actions.push_back(action::ShowMessage{"The group \"" + group_name(level, group) +
                                              "\" has all layers of tiles, and a level needs one of them.",
                                          true});
  else if (has_content(level, group))
    ui.view.level.deleted_group = group;
  else
    emit_edit(actions, std::move(edit));
}

void group_chosen(S session, A actions, U ui) {
  ui.ask(request::ShowTab(panel_id::kLayers));
  emit_edit(actions, add_group(session.level(), chosen_node(session, ui)));
}

void ungroup_chosen(S session, A actions, U ui) {
  ui.ask(request::ShowTab(panel_id::kLayers));
  emit_edit(actions, ungroup(session.level(), nearest_group(session, ui)));
}

void merge_chosen_layer(S session, A actions, U ui) {
  const int layer = chosen_layer(session);
  for (const int merged : {layer, layer - 1}) {
    const TileLayers& layers = session.level().layers;
    if (!shown_looks(layers.groups, layers.list[static_cast<std::size_t>(merged)]).locked) continue;
    actions.push_back(action::ShowMessage{"The layer \"" + layer_name(session.level(), merged) +
                                              "\" is locked: unlock it under Layers to merge the two.",
                                          true});
    return;
  }
  ui.ask(request::ShowTab(panel_id::kLayers));
  emit_edit(actions, merge_layer_down(session.level(), layer));
}

void rename_chosen(S session, A, U ui) {
  ui.ask(request::ShowTab(panel_id::kLayers));
  const int group = chosen_group_of(session, ui);
  if (group >= 0)
    ui.ask(request::RenameGroup{group});
  else
    ui.ask(request::RenameLayer{chosen_layer(session)});
}

template <bool TileLayer::*kField>
void switch_chosen_layer(S session, A actions, U) {
  TileLayer looks = looks_of_chosen(session);
  looks.*kField = !(looks.*kField);
  emit_edit(actions, set_layer_looks(session.level(), chosen_layer(session), std::move(looks)));
}
template <bool TileLayer::*kField>
bool is_chosen_layer(S session, const Ui&) {
  return looks_of_chosen(session).*kField;
}

template <bool TileLayer::*kField, bool LayerGroup::*kOfGroup>
void switch_chosen(S session, A actions, U ui) {
  const int group = chosen_group_of(session, ui);
  if (group < 0) return switch_chosen_layer<kField>(session, actions, ui);
  LayerGroup looks = session.level().layers.groups[static_cast<std::size_t>(group)];
  looks.*kOfGroup = !(looks.*kOfGroup);
  emit_edit(actions, set_group_looks(session.level(), group, std::move(looks)));
}
template <bool TileLayer::*kField, bool LayerGroup::*kOfGroup>
bool is_chosen(S session, const Ui& ui) {
  const int group = chosen_group_of(session, ui);
  return group < 0 ? is_chosen_layer<kField>(session, ui)
                   : session.level().layers.groups[static_cast<std::size_t>(group)].*kOfGroup;
}

std::vector<Command> layer_choices() {
  return {
      {.id = "layers/above",
       .label = "Layer in front",
       .help = "Chooses the layer of the map in front of the chosen one: the tools paint on it.",
       .key = KeyChord{kKeyPageUp},
       .menu = menus::kLayerChoice,
       .run = choose_layer_beside(1),
       .enabled = has_layer_above,
       .words = "select next layer above"},
      {.id = "layers/below",
       .label = "Layer behind",
       .help = "Chooses the layer of the map behind the chosen one: the tools paint on it.",
       .key = KeyChord{kKeyPageDown},
       .menu = menus::kLayerChoice,
       .run = choose_layer_beside(-1),
       .enabled = has_layer_below,
       .words = "select previous layer below"},
  };
}

std::vector<Command> layer_changes() {
  return {
      {.id = "layers/add",
       .label = "Add layer",
       .help = "Adds an empty layer of tiles in front of the chosen one.",
       .menu = menus::kLayerChanges,
       .icon = Icon::plus,
       .run = add_layer_in_front,
       .words = "new tile layer"},
      {.id = "layers/group",
       .label = "Group layers",
       .help = "Puts the chosen layer, or the chosen group, into a new group: a drag moves others into it.",
       .menu = menus::kLayerChanges,
       .icon = Icon::folder,
       .run = group_chosen,
       .words = "new group folder"},
      {.id = "layers/ungroup",
       .label = "Ungroup layers",
       .help = "Takes the chosen group, or that of the chosen layer, away. Its layers look as before.",
       .menu = menus::kLayerChanges,
       .run = ungroup_chosen,
       .enabled = is_in_group,
       .words = "dissolve flatten"},
      {.id = "layers/duplicate",
       .label = "Duplicate layer",
       .help = "Puts a copy of the chosen layer in front of it, or of the chosen group with its layers.",
       .menu = menus::kLayerChanges,
       .icon = Icon::copy,
       .run = duplicate_chosen,
       .words = "copy"},
      {.id = "layers/forwards",
       .label = "Move layer forwards",
       .help = "Moves the chosen layer or group in front of the next one, into a group, or out of its own.",
       .key = ctrl_shift(kKeyUp),
       .menu = menus::kLayerChanges,
       .icon = Icon::arrow_up,
       .run = move_chosen_layer(1),
       .enabled = can_move_forwards,
       .words = "raise up order"},
      {.id = "layers/backwards",
       .label = "Move layer backwards",
       .help = "Moves the chosen layer or group behind the next one, into a group, or out of its own.",
       .key = ctrl_shift(kKeyDown),
       .menu = menus::kLayerChanges,
       .icon = Icon::arrow_down,
       .run = move_chosen_layer(-1),
       .enabled = can_move_backwards,
       .words = "lower down order"},
      {.id = "layers/merge_down",
       .label = "Merge layer down",
       .help = "Puts the tiles of the chosen layer, except tile 0, over those of the layer behind it, which "
               "keeps its name and its looks.",
       .menu = menus::kLayerChanges,
       .icon = Icon::merge_down,
       .run = merge_chosen_layer,
       .enabled = has_layer_below,
       .words = "flatten join"},
      {.id = "layers/delete",
       .label = "Delete layer",
       .help = "Removes the chosen layer with its tiles, or the chosen group with its layers; Undo brings "
               "them back.",
       .menu = menus::kLayerChanges,
       .icon = Icon::clear,
       .run = delete_chosen,
       .enabled = has_several_layers,
       .words = "remove"},
      {.id = "layers/rename",
       .label = "Rename layer",
       .help = "Types another name for the chosen layer or group.",
       .key = ctrl_shift('n'),
       .menu = menus::kLayerChanges,
       .run = rename_chosen,
       .words = "name"},
  };
}

std::vector<Command> layer_switches() {
  return {
      {.id = "layers/visible",
       .label = "Layer is visible",
       .help = "Shows or hides the chosen layer or group. Hidden ground stops bodies, too.",
       .menu = menus::kLayerSwitches,
       .run = switch_chosen<&TileLayer::visible, &LayerGroup::visible>,
       .checked = is_chosen<&TileLayer::visible, &LayerGroup::visible>,
       .words = "show hide eye"},
      {.id = "layers/locked",
       .label = "Layer is locked",
       .help = "Locks the chosen layer or group, so that no tool changes its tiles, or unlocks it.",
       .menu = menus::kLayerSwitches,
       .run = switch_chosen<&TileLayer::locked, &LayerGroup::locked>,
       .checked = is_chosen<&TileLayer::locked, &LayerGroup::locked>,
       .words = "lock unlock protect"},
      {.id = "layers/ground",
       .label = "Layer is ground",
       .help = "Whether tiles of the chosen layer are ground and bodies, or only drawn.",
       .menu = menus::kLayerSwitches,
       .run = switch_chosen_layer<&TileLayer::is_ground>,
       .checked = is_chosen_layer<&TileLayer::is_ground>,
       .words = "collision solid scenery decoration"},
  };
}

}  // namespace

std::vector<Command> layer_commands() {
  return joined({in_scope(Scope::map, layer_choices()), in_scope(Scope::map, layer_changes()),
                 in_scope(Scope::map, layer_switches())});
}

}  // namespace talus
