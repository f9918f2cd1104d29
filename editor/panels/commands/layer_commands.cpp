// The commands of the layers of the map.
#include <string>
#include <utility>

#include "command_table.h"
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
bool has_layer_above(S session, const Ui&) {
  return chosen_layer(session) + 1 < session.level().layers.count();
}
bool has_layer_below(S session, const Ui&) { return chosen_layer(session) > 0; }
bool has_several_layers(S session, const Ui&) { return session.level().layers.count() > 1; }

CommandRun choose_layer_beside(int by) {
  return
      [by](S session, A actions, U) { actions.push_back(action::ChooseLayer{chosen_layer(session) + by}); };
}

CommandRun move_chosen_layer(int by) {
  return [by](S session, A actions, U) {
    const int layer = chosen_layer(session);
    emit_edit(actions, move_layer(session.level(), layer, layer + by));
  };
}

// An edit of the chosen layer by a function of edit/layer_tools.h.
template <auto kMakeEdit>
void edit_chosen_layer(S session, A actions, U ui) {
  ui.ask(request::ShowTab(panel_id::kLayers));
  emit_edit(actions, kMakeEdit(session.level(), chosen_layer(session)));
}

void add_layer_in_front(S session, A actions, U ui) {
  ui.ask(request::ShowTab(panel_id::kLayers));
  emit_edit(actions, add_layer(session.level()));
}

void merge_chosen_layer(S session, A actions, U ui) {
  const int layer = chosen_layer(session);
  for (const int merged : {layer, layer - 1}) {
    if (!session.level().layers.list[static_cast<std::size_t>(merged)].locked) continue;
    actions.push_back(action::ShowMessage{"The layer \"" + layer_name(session.level(), merged) +
                                              "\" is locked: unlock it under Layers to merge the two.",
                                          true});
    return;
  }
  edit_chosen_layer<merge_layer_down>(session, actions, ui);
}

void rename_chosen_layer(S session, A, U ui) {
  ui.ask(request::ShowTab(panel_id::kLayers));
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
      {.id = "layers/duplicate",
       .label = "Duplicate layer",
       .help = "Puts a copy of the chosen layer in front of it.",
       .menu = menus::kLayerChanges,
       .icon = Icon::copy,
       .run = edit_chosen_layer<duplicate_layer>,
       .words = "copy"},
      {.id = "layers/forwards",
       .label = "Move layer forwards",
       .help = "Moves the chosen layer in front of the next one.",
       .key = ctrl_shift(kKeyUp),
       .menu = menus::kLayerChanges,
       .icon = Icon::arrow_up,
       .run = move_chosen_layer(1),
       .enabled = has_layer_above,
       .words = "raise up order"},
      {.id = "layers/backwards",
       .label = "Move layer backwards",
       .help = "Moves the chosen layer behind the next one.",
       .key = ctrl_shift(kKeyDown),
       .menu = menus::kLayerChanges,
       .icon = Icon::arrow_down,
       .run = move_chosen_layer(-1),
       .enabled = has_layer_below,
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
       .help = "Removes the chosen layer with its tiles; Undo brings it back.",
       .menu = menus::kLayerChanges,
       .icon = Icon::clear,
       .run = edit_chosen_layer<remove_layer>,
       .enabled = has_several_layers,
       .words = "remove"},
      {.id = "layers/rename",
       .label = "Rename layer",
       .help = "Types another name for the chosen layer.",
       .key = ctrl_shift('n'),
       .menu = menus::kLayerChanges,
       .run = rename_chosen_layer,
       .words = "name"},
  };
}

std::vector<Command> layer_switches() {
  return {
      {.id = "layers/visible",
       .label = "Layer is visible",
       .help = "Shows or hides the chosen layer. Hidden ground stops bodies, too.",
       .menu = menus::kLayerSwitches,
       .run = switch_chosen_layer<&TileLayer::visible>,
       .checked = is_chosen_layer<&TileLayer::visible>,
       .words = "show hide eye"},
      {.id = "layers/locked",
       .label = "Layer is locked",
       .help = "Locks the chosen layer, so that no tool changes its tiles, or unlocks it.",
       .menu = menus::kLayerSwitches,
       .run = switch_chosen_layer<&TileLayer::locked>,
       .checked = is_chosen_layer<&TileLayer::locked>,
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
