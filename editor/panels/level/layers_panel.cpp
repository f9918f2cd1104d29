// Rows with an eye, a lock and the mark of ground, indented in groups; below them, how what is chosen looks.
#include "layers_panel.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "edit/group_tools.h"
#include "edit/layer_tools.h"
#include "edit/object_tools.h"
#include "panels/canvas/drag_cancel.h"
#include "panels/commands/commands.h"
#include "panels/emit_edit.h"
#include "panels/ui/long_list.h"

namespace talus {
namespace {

constexpr float kRow = 22;       // px at scale 1, of a layer
constexpr float kLeastRows = 3;  // of the list, however low the panel is
constexpr float kIndent = 14;    // px at scale 1, of what is in a group

const TileLayer& looks_of(const Session& session, int layer) {
  return session.level().layers.list[static_cast<std::size_t>(layer)];
}

struct LayerMark {
  bool TileLayer::*field;
  const char* name;  // of its widget
  Icon on, off;
  const char* help;
};
constexpr std::array<LayerMark, 3> kMarks = {
    {{&TileLayer::visible, "eye", Icon::eye, Icon::eye_closed,
      "Whether the layer is drawn. Hidden ground stops bodies, too."},
     {&TileLayer::locked, "lock", Icon::lock, Icon::unlock,
      "Whether the layer is locked, so that no tool changes its tiles."},
     {&TileLayer::is_ground, "ground", Icon::ground, Icon::ground,
      "Whether tiles of the layer are ground and bodies, or only drawn."}}};

// A mark that a click switches, without the frame of a button, as each row has three. Returns whether it was
// clicked.
bool draw_switch(const char* name, Icon icon, bool on, const Ui& ui) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float side = ui.px(kRow), inset = ui.px(4);
  const bool clicked = ImGui::InvisibleButton(name, {side, side});
  const ImU32 color = ImGui::IsItemHovered() ? theme::tone(theme::kAccent)
                      : on                   ? theme::tone(theme::kText)
                                             : theme::tone(theme::kMuted, 90);
  draw_icon(*ImGui::GetWindowDrawList(), icon, {at.x + inset, at.y + inset}, side - 2 * inset, color);
  return clicked;
}

void draw_mark(const LayerMark& mark, int layer, const Session& session, Actions& actions, Ui& ui) {
  const TileLayer& looks = looks_of(session, layer);
  const bool on = looks.*mark.field;
  if (draw_switch(mark.name, on ? mark.on : mark.off, on, ui)) {
    TileLayer switched = looks;
    switched.*mark.field = !on;
    emit_edit(actions, set_layer_looks(session.level(), layer, std::move(switched)));
  }
  ui.item("layers/" + std::to_string(layer) + "/" + mark.name, mark.help);
}

const ObjectLayer& other_of(const Session& session, int layer) {
  return session.level().objects[static_cast<std::size_t>(layer)];
}

// The marks of a layer of objects or of a picture.
void draw_other_marks(int layer, const Session& session, Actions& actions, Ui& ui) {
  const Level& level = session.level();
  const ObjectLayer& other = other_of(session, layer);
  const std::string id = "layers/objects/" + std::to_string(layer);
  if (draw_switch("eye", other.visible ? Icon::eye : Icon::eye_closed, other.visible, ui))
    emit_edit(actions, set_object_visible(level, layer, !other.visible));
  ui.item(id + "/eye", "Whether the layer is drawn. Hidden ground stops bodies, too.");
  ImGui::SameLine();
  if (draw_switch("lock", other.locked ? Icon::lock : Icon::unlock, other.locked, ui))
    emit_edit(actions, set_object_locked(level, layer, !other.locked));
  ui.item(id + "/lock", "Whether the layer is locked, so that no tool changes what is in it.");
  ImGui::SameLine();
  if (other.image) {  // no picture is ground
    ImGui::Dummy({ui.px(kRow), ui.px(kRow)});
    return;
  }
  if (draw_switch("ground", Icon::ground, other.is_ground, ui))
    emit_edit(actions, set_object_ground(level, layer, !other.is_ground));
  ui.item(id + "/ground", "Whether areas and lines among the objects are ground, or only drawn.");
}

const LayerGroup& group_of(const Session& session, int group) {
  return session.level().layers.groups[static_cast<std::size_t>(group)];
}

void draw_group_mark(bool LayerGroup::*field, int group, Icon on_icon, Icon off_icon, const std::string& name,
                     const char* help, const Session& session, Actions& actions, Ui& ui) {
  const bool on = group_of(session, group).*field;
  if (draw_switch(name.c_str(), on ? on_icon : off_icon, on, ui)) {
    LayerGroup switched = group_of(session, group);
    switched.*field = !on;
    emit_edit(actions, set_group_looks(session.level(), group, std::move(switched)));
  }
  ui.item("layers/groups/" + std::to_string(group) + "/" + name, help);
  ImGui::SameLine();
}

void draw_group_marks(int group, const Session& session, Actions& actions, Ui& ui) {
  draw_group_mark(&LayerGroup::visible, group, Icon::eye, Icon::eye_closed, "eye",
                  "Whether the layers of the group are drawn. Hidden ground stops bodies, too.", session,
                  actions, ui);
  draw_group_mark(&LayerGroup::locked, group, Icon::lock, Icon::unlock, "lock",
                  "Whether the group is locked, so that no tool changes what is in it.", session, actions,
                  ui);
  ImGui::Dummy({ui.px(kRow), ui.px(kRow)});
}

std::string id_of(const LayerNode& node) {
  if (node.is_group) return "layers/groups/" + std::to_string(node.group);
  return (node.layer.has_tiles ? "layers/" : "layers/objects/") + std::to_string(node.layer.index);
}

const std::string& own_name_of(const LayerInOrder& layer, const Session& session) {
  return layer.has_tiles ? looks_of(session, layer.index).name : other_of(session, layer.index).name;
}

std::string text_of(const LayerNode& node, const Level& level) {
  return node.is_group ? group_name(level, node.group) : layer_text(level, node.layer);
}

bool is_shown(const LayerNode& node, const Level& level) {
  const LayerGroups& groups = level.layers.groups;
  const auto at = static_cast<std::size_t>(node.is_group ? node.group : node.layer.index);
  if (node.is_group) return shown_looks(groups, groups[at]).visible;
  return node.layer.has_tiles ? shown_looks(groups, level.layers.list[at]).visible
                              : shown_looks(groups, level.objects[at]).visible;
}

// By which the panel knows a group again, also after others were moved: its name and those around it.
std::string path_of(const Level& level, int group) {
  std::string path;
  for (const int around : groups_around(level.layers.groups, group)) path += group_name(level, around) + "/";
  return path;
}

// The group that a row is in, at that depth; -1: none.
int group_at_depth(const Level& level, const LayerNode& above, int depth) {
  const std::vector<int> around = groups_around(level.layers.groups, above.group);
  return depth > 0 && depth <= static_cast<int>(around.size()) ? around[static_cast<std::size_t>(depth - 1)]
                                                               : -1;
}

// Where what is dragged goes: in front of so many layers, and into a group.
struct DropPlace {
  int to = 0, group = -1;
  int depth = 0;
};
// gap: above that row. depth: of the mouse.
DropPlace drop_place(const Level& level, const std::vector<LayerNode>& rows, int gap, int depth,
                     bool is_open) {
  const auto at = static_cast<std::size_t>(gap);
  const bool has_below = at < rows.size();
  DropPlace place;
  place.to = has_below ? rows[at].end : 0;
  const int least = has_below ? rows[at].depth : 0;
  if (gap == 0) return place;
  const LayerNode& above = rows[at - 1];
  const int most = above.depth + (above.is_group && is_open ? 1 : 0);
  place.depth = std::clamp(depth, std::min(least, most), most);
  place.group = group_at_depth(level, above, place.depth);
  return place;
}

}  // namespace

LayersPanel::Item LayersPanel::item_of(const LayerNode& node) {
  return {node.layer, node.is_group ? node.group : -1};
}

void LayersPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  if (const auto asked = ui.view.requests.take<request::RenameLayer>())
    renaming_ = Renaming{{{true, asked->layer}}, looks_of(session, session.level().layers.chosen).name};
  if (const auto asked = ui.view.requests.take<request::RenameGroup>())
    renaming_ = Renaming{{{}, asked->group}, group_of(session, asked->group).name};
  constexpr std::array kButtons = {"layers/add"_command,       "layers/group"_command,
                                   "layers/duplicate"_command, "layers/forwards"_command,
                                   "layers/backwards"_command, "layers/merge_down"_command,
                                   "layers/delete"_command};
  for (const CommandId id : kButtons) {
    command_button(id, session, actions, ui, std::string(id.text) + "_button");
    ImGui::SameLine();
  }
  ImGui::NewLine();
  follow_choice(session);
  ImGui::BeginChild("layers");
  draw_list(session, actions, ui);
  draw_looks(session, actions, ui);
  ImGui::EndChild();
}

// All layers and groups but those in folded ones, the front one at the top.
std::vector<LayerNode> LayersPanel::rows_of(const Level& level) const {
  std::vector<LayerNode> rows;
  int folded = -1;  // the depth of the folded group that the next ones are in
  for (const LayerNode& node : layer_tree(level, true)) {
    if (folded >= 0 && node.depth > folded) continue;
    folded = node.is_group && folded_.contains(path_of(level, node.group)) ? node.depth : -1;
    rows.push_back(node);
  }
  return rows;
}

void LayersPanel::draw_list(const Session& session, Actions& actions, Ui& ui) {
  const std::vector<LayerNode> rows = rows_of(session.level());
  const int count = static_cast<int>(rows.size()), chosen = session.level().layers.chosen;
  const float row = ui.px(kRow);
  const float room = ImGui::GetContentRegionAvail().y - LayerLookFields::height(ui);
  const float height =
      std::min(static_cast<float>(count), std::max(kLeastRows, std::floor(room / row))) * row;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  ImGui::BeginChild("list", {0, height});
  if (std::exchange(followed_, chosen) != chosen) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const LayerNode& node) {
      return item_of(node) == Item{{true, chosen}};
    });
    const float top = static_cast<float>(found - rows.begin()) * row;
    if (top < ImGui::GetScrollY()) ImGui::SetScrollY(top);
    if (top + row > ImGui::GetScrollY() + height) ImGui::SetScrollY(top + row - height);
  }
  const ImVec2 top = ImGui::GetCursorScreenPos();
  draw_rows(count, [&](int at) {
    const LayerNode& node = rows[static_cast<std::size_t>(at)];
    ImGui::PushID(id_of(node).c_str());
    draw_row(node, session, actions, ui);
    ImGui::PopID();
  });
  drag_item(top, row, rows, session, actions, ui);
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

void LayersPanel::draw_row(const LayerNode& node, const Session& session, Actions& actions, Ui& ui) {
  if (node.is_group) {
    draw_group_marks(node.group, session, actions, ui);
  } else if (node.layer.has_tiles) {
    for (const LayerMark& mark : kMarks) {
      if (&mark != kMarks.data()) ImGui::SameLine();
      draw_mark(mark, node.layer.index, session, actions, ui);
    }
  } else {
    draw_other_marks(node.layer.index, session, actions, ui);
  }
  ImGui::SameLine();
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ui.px(kIndent) * static_cast<float>(node.depth));
  if (node.is_group) draw_fold(node, session, ui);
  if (renaming_ && renaming_->item == item_of(node))
    draw_name_field(session, actions, ui);
  else
    draw_name(node, session, actions, ui);
}

// The arrow of a group.
void LayersPanel::draw_fold(const LayerNode& node, const Session& session, Ui& ui) {
  const std::string path = path_of(session.level(), node.group);
  const bool is_folded = folded_.contains(path);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float side = ui.px(kRow), arrow = ImGui::GetFontSize() * 0.7f, inset = (side - arrow) / 2;
  if (ImGui::InvisibleButton("fold", {ui.px(kIndent), side})) {
    if (is_folded)
      folded_.erase(path);
    else
      folded_.insert(path);
  }
  const ImU32 color = theme::tone(ImGui::IsItemHovered() ? theme::kAccent : theme::kText);
  ImGui::RenderArrow(ImGui::GetWindowDrawList(), {at.x, at.y + inset}, color,
                     is_folded ? ImGuiDir_Right : ImGuiDir_Down, 0.7f);
  ui.item(id_of(node) + "/fold", is_folded ? "Shows what is in the group." : "Hides the rows of the group.");
  ImGui::SameLine();
}

// A click chooses a layer or a group, a double click renames, and a drag moves.
void LayersPanel::draw_name(const LayerNode& node, const Session& session, Actions& actions, Ui& ui) {
  const Level& level = session.level();
  const bool has_tiles = !node.is_group && node.layer.has_tiles;
  const int group = chosen_group(ui.view.level, level);
  const int chosen = has_tiles ? level.layers.chosen : session.choices().object.layer;
  const bool is_chosen = node.is_group ? node.group == group : group < 0 && node.layer.index == chosen;
  const bool hidden = !is_shown(node, level);
  if (hidden) ImGui::PushStyleColor(ImGuiCol_Text, theme::tone(theme::kMuted));
  ImGui::PushStyleVar(ImGuiStyleVar_SelectableTextAlign, ImVec2(0, 0.5f));
  const bool clicked = selectable("  " + text_of(node, level), "name", is_chosen,
                                  ImGuiSelectableFlags_AllowDoubleClick, {0, ui.px(kRow)});
  ImGui::PopStyleVar();
  if (hidden) ImGui::PopStyleColor();
  if (has_tiles)
    ui.item(
        id_of(node),
        "A click chooses the layer for the tools. A double click renames it, and a drag moves it, also into "
        "a group and out of it.",
        keys_of("layers/above"_command, ui) + ", " + keys_of("layers/below"_command, ui));
  else if (node.is_group)
    ui.item(
        id_of(node),
        "A group of layers. A click chooses it for the buttons and the fields here. A double click renames "
        "it, and a drag moves it.");
  else
    ui.item(id_of(node),
            "A layer beside those of tiles. A click shows its looks, a double click renames it, and a drag "
            "moves it, also into a group and out of it.");
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0)) dragged_ = item_of(node);
  if (clicked && !dragged_) choose(item_of(node), session, actions, ui);
}

void LayersPanel::choose(const Item& item, const Session& session, Actions& actions, Ui& ui) {
  const bool is_group = item.group >= 0;
  const std::string& name = is_group ? group_of(session, item.group).name : own_name_of(item.layer, session);
  ui.view.level.group = is_group ? GroupChoice{item.group, name} : GroupChoice();
  const bool has_tiles = !is_group && item.layer.has_tiles;
  const int chosen = has_tiles ? session.level().layers.chosen : session.choices().object.layer;
  if (!is_group && item.layer.index == chosen) looks_of_other_ = !has_tiles;  // else follow_choice() sees it
  if (has_tiles)
    actions.push_back(action::ChooseLayer{item.layer.index});
  else if (!is_group && item.layer.index != chosen)
    actions.push_back(action::SelectObject{{item.layer.index, -1}});
  if (ImGui::IsMouseDoubleClicked(0)) renaming_ = Renaming{item, name};
}

// The typed text becomes the name when the field is left; Escape leaves the name as it was.
void LayersPanel::draw_name_field(const Session& session, Actions& actions, Ui& ui) {
  if (!renaming_->has_keys) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  input_text("renamed", "no name", renaming_->name, ImGuiInputTextFlags_AutoSelectAll);
  ui.item("layers/name", "The name.", "Esc cancels");
  if (ImGui::IsItemActive()) renaming_->has_keys = true;
  if (!ImGui::IsItemDeactivated()) return;
  if (ImGui::IsItemDeactivatedAfterEdit()) {
    const auto& [layer, group] = renaming_->item;
    if (group >= 0) {
      LayerGroup looks = group_of(session, group);
      looks.name = renaming_->name;
      if (ui.view.level.group.group == group) ui.view.level.group.name = looks.name;
      emit_edit(actions, set_group_looks(session.level(), group, std::move(looks)));
    } else if (layer.has_tiles) {
      TileLayer looks = looks_of(session, layer.index);
      looks.name = renaming_->name;
      emit_edit(actions, set_layer_looks(session.level(), layer.index, std::move(looks)));
    } else {
      emit_edit(actions, rename_objects(session.level(), layer.index, renaming_->name));
    }
  }
  renaming_.reset();
}

// A line shows where the dragged row would go; it begins at the indentation of its new group. top: of the
// first row; row: its height; px of the screen.
void LayersPanel::drag_item(ImVec2 top, float row, const std::vector<LayerNode>& rows, const Session& session,
                            Actions& actions, const Ui& ui) {
  if (!dragged_) return;
  const Level& level = session.level();
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [&](const LayerNode& node) { return item_of(node) == *dragged_; });
  if (is_drag_cancelled() || found == rows.end()) {
    ImGui::ClearActiveID();
    dragged_.reset();
    return;
  }
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const int count = static_cast<int>(rows.size());
  const int gap = std::clamp(static_cast<int>(std::floor((mouse.y - top.y) / row + 0.5f)), 0, count);
  const float names = top.x + 3 * ui.px(kRow);  // where those begin that are in no group
  const int depth = static_cast<int>(std::floor((mouse.x - names) / ui.px(kIndent)));
  const LayerNode* const above = gap > 0 ? &rows[static_cast<std::size_t>(gap - 1)] : nullptr;
  const bool is_open = above != nullptr && above->is_group && !folded_.contains(path_of(level, above->group));
  const DropPlace place = drop_place(level, rows, gap, depth, is_open);
  const float line = top.y + static_cast<float>(gap) * row, half = ui.px(1);
  const float left = place.depth == 0 ? top.x : names + ui.px(kIndent) * static_cast<float>(place.depth);
  ImGui::GetWindowDrawList()->AddRectFilled(
      {left, line - half}, {top.x + ImGui::GetWindowWidth(), line + half}, theme::tone(theme::kAccent));
  if (ImGui::IsMouseDown(0)) return;
  dragged_.reset();
  emit_edit(actions, move_node(level, *found, place.to, place.group));
}

// Of the chosen group, of the layer of objects or of a picture that was chosen last, or else of the chosen
// layer of tiles.
void LayersPanel::draw_looks(const Session& session, Actions& actions, Ui& ui) {
  const Level& level = session.level();
  const int group = chosen_group(ui.view.level, level);
  const LayerInOrder layer = looks_of_other_ ? LayerInOrder{false, session.choices().object.layer}
                                             : LayerInOrder{true, level.layers.chosen};
  look_fields_.draw(layer, group, session, actions, ui);
}

// The fields go to the layer that was chosen last, in the panel or by a tool.
void LayersPanel::follow_choice(const Session& session) {
  const int tiles = session.level().layers.chosen, other = session.choices().object.layer;
  if (std::exchange(chosen_tiles_, tiles) != tiles) looks_of_other_ = false;
  if (std::exchange(chosen_other_, other) != other) looks_of_other_ = true;
  looks_of_other_ = looks_of_other_ && has_layer(session.level(), {false, other});
}

}  // namespace talus
