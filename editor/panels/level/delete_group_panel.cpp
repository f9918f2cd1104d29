// Three answers: with its layers, without them, or not at all.
#include "delete_group_panel.h"

#include <string>

#include "edit/group_tools.h"
#include "panels/ui/dialog.h"

namespace talus {

void DeleteGroupPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  const auto is_open = [](const Session& its, const View& view) {
    const int group = view.level.deleted_group;
    return group >= 0 && group < static_cast<int>(its.level().layers.groups.size());
  };
  if (!begin_dialog("Delete group", is_open, {0, 0}, session, ui)) return;
  const Level& level = session.level();
  const int group = ui.view.level.deleted_group;
  const auto node = node_of_group(level, group);
  if (!node) return ImGui::EndPopup();  // it closes
  const int count = node->end - node->begin;
  draw_text("Delete the group \"" + group_name(level, group) + "\" with its " +
            (count == 1 ? "layer" : std::to_string(count) + " layers") + "? Undo brings them back.");
  ImGui::Spacing();
  Edit edit;
  bool is_done = dialog_button({.widget = "delete_group/cancel",
                                .label = "Cancel",
                                .help = "Deletes nothing.",
                                .letter = 'C',
                                .is_cancel = true,
                                .gets_the_keys = true},
                               ui);
  ImGui::SameLine();
  if (dialog_button({.widget = "delete_group/ungroup",
                     .label = "Ungroup",
                     .help = "Deletes the group alone: its layers stay, and look as before.",
                     .letter = 'U'},
                    ui))
    edit = ungroup(level, group);
  ImGui::SameLine();
  if (dialog_button({.widget = "delete_group/delete",
                     .label = "Delete",
                     .help = "Deletes the group and its layers.",
                     .letter = 'D'},
                    ui))
    edit = remove_group(level, group);
  is_done = is_done || !edit.empty();
  if (!edit.empty()) actions.push_back(action::EditLevel{std::move(edit)});
  if (is_done) ui.view.level.deleted_group = -1;
  ImGui::EndPopup();
}

}  // namespace talus
