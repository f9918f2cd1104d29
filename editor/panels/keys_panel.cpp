// A modal table of the commands with their keys; a click on one waits for another.
#include "keys_panel.h"

#include <imgui_stdlib.h>

#include "dialog.h"
#include "fuzzy_match.h"
#include "key_conflicts.h"

namespace talus {
namespace {

constexpr float kKeyButtonWidth = 120;  // px at scale 1

bool is_captured(const std::optional<KeyCapture>& capture, const Command& command, std::size_t index) {
  return capture && capture->command == command.id && capture->index == index;
}

}  // namespace

void KeysPanel::draw(const Session&, Actions&, Ui& ui) {
  ProgramView& program = ui.view.program;
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  if (!begin_dialog("Keys of the commands", program.keys_open,
                    {std::min(ui.px(760), window.x - ui.px(64)), window.y - ui.px(96)}, ui))
    return;
  if (ImGui::IsWindowAppearing()) {
    typed_.clear();
    asks_reset_ = false;
    ImGui::SetKeyboardFocusHere();
  }
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##typed", "type a part of a command's name", &typed_);
  ui.item("keys/text");
  take_pressed_key(ui);
  draw_table(ui);
  draw_question(ui);
  if (key_pressed(ImGuiKey_Escape)) {
    if (program.key_capture)
      program.key_capture.reset();
    else
      program.keys_open = false;
  }
  ImGui::EndPopup();
}

// A key that nobody else has is the command's at once.
void KeysPanel::take_pressed_key(Ui& ui) {
  auto& capture = ui.view.program.key_capture;
  KeyBindings& bindings = ui.view.preferences.keys;
  if (!capture || !capture->pressed) return;
  const Command& command = find_command(capture->command);
  if (command_with_key(capture->pressed, command, bindings) != nullptr) return;
  bind_key(command, capture->index, capture->pressed, bindings);
  capture.reset();
}

void KeysPanel::draw_table(Ui& ui) {
  const float below = ui.px(theme::kButton) + ImGui::GetTextLineHeightWithSpacing() + ui.px(8);
  if (!ImGui::BeginTable("commands", 5, ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY,
                         {0, ImGui::GetContentRegionAvail().y - below}))
    return;
  ImGui::TableSetupColumn("command", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("where", ImGuiTableColumnFlags_WidthFixed, ui.px(140));
  for (const char* name : {"key", "second key"})
    ImGui::TableSetupColumn(name, ImGuiTableColumnFlags_WidthFixed, ui.px(kKeyButtonWidth));
  ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, ui.px(theme::kButton));
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableHeadersRow();
  KeyBindings& bindings = ui.view.preferences.keys;
  ui.begin_row();
  for (const Command& command : commands()) {
    if (!fuzzy_score(command.label, typed_)) continue;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(command.label.data(), command.label.data() + command.label.size());
    ui.tooltip(command.help);
    ImGui::TableNextColumn();
    ui.hint(scope_label(command.scope));
    for (std::size_t index : {0u, 1u}) {
      ImGui::TableNextColumn();
      draw_key(command, index, ui);
    }
    ImGui::TableNextColumn();
    const std::string id(command.id);
    if (bindings.changed.contains(command.id) && ui.icon_button("keys/reset/" + id, Icon::restart, false,
                                                                "Gives the command its first keys back.", {}))
      reset_keys(command, bindings);
  }
  ui.end_row();
  ImGui::EndTable();
}

void KeysPanel::draw_key(const Command& command, std::size_t index, Ui& ui) {
  auto& capture = ui.view.program.key_capture;
  const bool waits = is_captured(capture, command, index);
  const KeyChord chord = command_keys(command, ui.view.preferences.keys)[index];
  const std::string label = waits && !capture->pressed ? "press a key"
                            : waits                    ? to_string(capture->pressed) + "?"
                                                       : to_string(chord);
  const std::string widget = (index == 0 ? "keys/first/" : "keys/second/") + std::string(command.id);
  if (ui.text_button(widget, label, waits, "Click, then press the new key.", {}, true,
                     ui.px(kKeyButtonWidth)))
    capture = KeyCapture{std::string(command.id), index, {}};
}

void KeysPanel::draw_question(Ui& ui) {
  ProgramView& program = ui.view.program;
  KeyBindings& bindings = ui.view.preferences.keys;
  auto& capture = program.key_capture;
  if (capture) {
    const Command& command = find_command(capture->command);
    const Command* other = command_with_key(capture->pressed, command, bindings);
    ui.hint(other == nullptr
                ? "Press the new key for " + std::string(command.label) + ", or Escape."
                : to_string(capture->pressed) + " is the key of " + std::string(other->label) + ".");
    if (other != nullptr &&
        ui.text_button("keys/take", "Take it", true, "The other command loses this key.")) {
      bind_key(command, capture->index, capture->pressed, bindings);
      capture.reset();
    }
    if (other != nullptr) ImGui::SameLine();
    if (capture && ui.text_button("keys/none", "No key", false, "Leaves this place without a key.")) {
      bind_key(command, capture->index, {}, bindings);
      capture.reset();
    }
    ImGui::SameLine();
    if (ui.text_button("keys/cancel", "Cancel", false, "Leaves the key as it was.", "Esc")) capture.reset();
    return;
  }
  ui.hint(
      "Click a key to change it. Keys of the sprites, the map and the input roll work where the focus is, "
      "those "
      "of the keyboard's cursor while it is shown, before all others.");
  if (ui.text_button("keys/close", "Close", false, "Keeps the keys as they are now.", "Esc", true, ui.px(96)))
    program.keys_open = false;
  ImGui::SameLine();
  if (ui.text_button("keys/reset_all", asks_reset_ ? "Really reset all" : "Reset all", asks_reset_,
                     "Gives every command its first keys back; asks once more.", {},
                     !bindings.changed.empty())) {
    if (asks_reset_) bindings.changed.clear();
    asks_reset_ = !asks_reset_;
  }
}

}  // namespace talus
