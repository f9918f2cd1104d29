#include "command_row.h"

#include <utility>

namespace talus {

CommandRow::CommandRow(std::string name, Ui& ui)
    : name_(std::move(name)), ui_(ui), end_(ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x) {}

bool CommandRow::takes(float width) {
  const float gap = ImGui::GetStyle().ItemSpacing.x + ui_.px(std::exchange(gap_, 0.0f));
  const float more = ui_.px(theme::kButton) + ImGui::GetStyle().ItemSpacing.x;
  if (ImGui::GetItemRectMax().x + gap + width + more > end_) return false;
  ImGui::SameLine(0, gap);
  return true;
}

void CommandRow::add(std::initializer_list<CommandId> ids, const Session& session, Actions& actions) {
  const float count = static_cast<float>(ids.size()), gap = ImGui::GetStyle().ItemSpacing.x;
  if (!hidden_.empty() || !takes(count * ui_.px(theme::kButton) + (count - 1) * gap)) {
    hidden_.insert(hidden_.end(), ids);
    return;
  }
  for (const CommandId& id : ids) {
    if (&id != ids.begin()) ImGui::SameLine();
    command_button(id, session, actions, ui_);
  }
}

void CommandRow::end(const Session& session, Actions& actions, const std::function<void()>& draw_last,
                     float width) {
  const bool has_room = hidden_.empty() && takes(width);
  if (has_room) draw_last();
  std::vector<CommandId> in_menu = folded_;
  in_menu.insert(in_menu.end(), hidden_.begin(), hidden_.end());
  if (has_room && in_menu.empty()) return;
  ImGui::SameLine();
  if (ui_.icon_button(name_ + "/more", Icon::more, false, "More tools.", {})) ImGui::OpenPopup("more");
  if (!ImGui::BeginPopup("more")) return;
  for (const CommandId id : in_menu) {
    const Command& command = find_command(id);
    if (menu_item(command.label, command.id, keys_of(command, ui_), command.is_checked(session, ui_),
                  command.is_enabled(session, ui_)))
      command.run(session, actions, ui_);
    ui_.item(command.id, command.help);
  }
  const bool was_empty = actions.empty();
  if (!has_room) draw_last();
  if (was_empty && !actions.empty()) ImGui::CloseCurrentPopup();  // something was chosen in it
  ImGui::EndPopup();
}

}  // namespace talus
