// A modal list of the commands that match.
#include "command_palette_panel.h"

#include <algorithm>
#include <vector>

#include "command_search.h"
#include "panels/ui/dialog.h"

namespace talus {
namespace {

constexpr int kNoRow = -1;

}  // namespace

void CommandPalettePanel::draw(const Session& session, Actions& actions, Ui& ui) {
  const auto is_open = [](const Session&, const View& view) { return view.commands.palette_open; };
  if (!begin_dialog("Find a command", is_open, {ui.px(460), ui.px(360)}, session, ui)) return;
  if (ImGui::IsWindowAppearing()) {
    typed_.clear();
    chosen_.reset();
    ImGui::SetKeyboardFocusHere();
  }
  ImGui::SetNextItemWidth(-1);
  if (input_text("typed", "type a few letters of its name, or what it is about", typed_)) chosen_.reset();
  ui.item("command_palette/text");
  draw_list(session, actions, ui);
  if (key_pressed(ImGuiKey_Escape)) ui.view.commands.palette_open = false;
  ImGui::EndPopup();
}

void CommandPalettePanel::draw_list(const Session& session, Actions& actions, Ui& ui) {
  const auto [found, meant] =
      matching_commands(typed_, [&](const Command& command) { return command.is_enabled(session, ui); });
  const int last = static_cast<int>(found.size()) - 1;
  const int before = chosen_.value_or(meant == nullptr ? 0 : kNoRow);
  int chosen = before;
  if (key_pressed(ImGuiKey_DownArrow)) chosen = std::min(chosen + 1, last);
  if (key_pressed(ImGuiKey_UpArrow)) chosen = std::max(chosen - 1, 0);
  const bool moved = chosen != before;  // otherwise the wheel may scroll the list anywhere
  if (moved) chosen_ = chosen;
  const Command* run = key_pressed(ImGuiKey_Enter) && chosen >= 0 && chosen <= last
                           ? found[static_cast<std::size_t>(chosen)]
                           : nullptr;
  if (found.empty())
    ui.hint("No command has these letters in its name, in this order, or such a word in its help.");
  if (meant != nullptr) ui.hint(std::string(meant->label) + " cannot be done now.");
  ImGui::BeginChild("list");
  for (int i = 0; i <= last; ++i) {
    const Command& command = *found[static_cast<std::size_t>(i)];
    const bool enabled = command.is_enabled(session, ui);
    ImGui::BeginDisabled(!enabled);
    if (selectable(command.label, command.id, i == chosen)) run = &command;
    ImGui::EndDisabled();
    if (i == chosen && moved) ImGui::SetScrollHereY();
    ui.item("command_palette/" + std::string(command.id), command.help, {}, enabled);
    ImGui::SameLine();
    ui.right_aligned(keys_of(command, ui), theme::tone(theme::kMuted));
  }
  ImGui::EndChild();
  if (run == nullptr || !run->is_enabled(session, ui)) return;
  ui.view.commands.palette_open = false;
  run->run(session, actions, ui);
}

}  // namespace talus
