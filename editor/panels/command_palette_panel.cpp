// A modal list of the commands that match.
#include "command_palette_panel.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include "commands.h"
#include "dialog.h"

namespace talus {
namespace {

bool matches(std::string_view label, std::string_view typed) {
  const auto same = [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); };
  return std::search(label.begin(), label.end(), typed.begin(), typed.end(), same) != label.end();
}

}  // namespace

void CommandPalettePanel::draw(const Session& session, Actions& actions, Ui& ui) {
  if (!begin_dialog("Find a command", ui.view.command_palette_open, {ui.px(460), ui.px(360)}, ui)) return;
  if (ImGui::IsWindowAppearing()) {
    typed_.clear();
    chosen_ = 0;
    ImGui::SetKeyboardFocusHere();
  }
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputTextWithHint("##typed", "type a part of its name", &typed_)) chosen_ = 0;
  ui.item("command_palette/text");
  draw_list(session, actions, ui);
  if (key_pressed(ImGuiKey_Escape)) ui.view.command_palette_open = false;
  ImGui::EndPopup();
}

void CommandPalettePanel::draw_list(const Session& session, Actions& actions, Ui& ui) {
  std::vector<const Command*> found;
  for (const Command& command : commands())
    if (command.is_enabled(session, ui) && matches(command.label, typed_)) found.push_back(&command);
  const int last = static_cast<int>(found.size()) - 1;
  if (key_pressed(ImGuiKey_DownArrow)) ++chosen_;
  if (key_pressed(ImGuiKey_UpArrow)) --chosen_;
  chosen_ = std::clamp(chosen_, 0, std::max(last, 0));
  const Command* run =
      key_pressed(ImGuiKey_Enter) && last >= 0 ? found[static_cast<std::size_t>(chosen_)] : nullptr;
  if (found.empty()) ui.hint("No command has this in its name.");
  ImGui::BeginChild("list");
  for (int i = 0; i <= last; ++i) {
    const Command& command = *found[static_cast<std::size_t>(i)];
    if (ImGui::Selectable(std::string(command.label).c_str(), i == chosen_)) run = &command;
    if (i == chosen_) ImGui::SetScrollHereY();
    ui.item("command_palette/" + std::string(command.id), command.help);
    ImGui::SameLine();
    ui.right_aligned(keys_of(command), theme::color(theme::kMuted));
  }
  ImGui::EndChild();
  if (run == nullptr) return;
  ui.view.command_palette_open = false;
  run->run(session, actions, ui);
}

}  // namespace talus
