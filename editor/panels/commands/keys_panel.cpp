// A modal table of the commands with their keys. Enter or a click on a key waits for a new one.
#include "keys_panel.h"

#include <algorithm>
#include <utility>

#include "command_search.h"
#include "key_conflicts.h"
#include "panels/ui/dialog.h"

namespace talus {
namespace {

constexpr float kKeyButtonWidth = 120;  // px at scale 1

bool is_captured(const std::optional<KeyCapture>& capture, const Command& command, std::size_t index) {
  return capture && capture->command == command.id && capture->index == index;
}

}  // namespace

void KeysPanel::draw(const Session& session, Actions&, Ui& ui) {
  CommandsView& view = ui.view.commands;
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const auto is_open = [](const Session&, const View& now) { return now.commands.keys_open; };
  if (!begin_dialog("Keys of the commands", is_open,
                    {std::min(ui.px(760), window.x - ui.px(64)), window.y - ui.px(96)}, session, ui,
                    DialogKeys::its_own))
    return;
  if (ImGui::IsWindowAppearing()) {
    typed_.clear();
    row_ = 0;
    column_ = 0;
    moved_ = wants_text_ = true;
    asks_reset_ = false;
  }
  if (std::exchange(wants_text_, false)) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  if (input_text("typed", "type a part of a command's name, or what it is about", typed_)) row_ = 0;
  ui.item("keys/text");
  listed_.clear();
  for (const Command& command : commands())
    if (command_score(command, typed_)) listed_.push_back(&command);
  take_pressed_key(ui);
  if (!view.key_capture) choose_by_keys(ui);
  draw_table(ui);
  draw_question(ui);
  asks_for_taken_ = view.key_capture && view.key_capture->pressed;
  ImGui::EndPopup();
}

void KeysPanel::choose_by_keys(Ui& ui) {
  const int last = std::max(static_cast<int>(listed_.size()) - 1, 0), before = row_;
  if (key_repeats(ImGuiKey_DownArrow)) ++row_;
  if (key_repeats(ImGuiKey_UpArrow)) --row_;
  constexpr int kPage = 10;
  if (key_repeats(ImGuiKey_PageDown)) row_ += kPage;
  if (key_repeats(ImGuiKey_PageUp)) row_ -= kPage;
  row_ = std::clamp(row_, 0, last);
  moved_ = moved_ || row_ != before;
  const bool text_is_typed =
      ImGui::GetIO().KeyCtrl || ImGui::GetIO().KeyShift;  // the keys belong to the cursor of the text field
  if (!text_is_typed && key_pressed(ImGuiKey_LeftArrow)) column_ = 0;
  if (!text_is_typed && key_pressed(ImGuiKey_RightArrow)) column_ = 1;
  if (listed_.empty()) return;
  const Command& command = *listed_[static_cast<std::size_t>(row_)];
  KeyBindings& bindings = ui.view.preferences.keys;
  if (key_pressed(ImGuiKey_Enter))
    ui.view.commands.key_capture = KeyCapture{std::string(command.id), column_, {}};
  if (key_pressed(ImGuiKey_Delete)) {
    if (ImGui::GetIO().KeyCtrl)
      reset_keys(command, bindings);
    else
      bind_key(command, column_, {}, bindings);
  }
}

void KeysPanel::end_capture(Ui& ui) {
  ui.view.commands.key_capture.reset();
  wants_text_ = true;
}

// The command gets a free key at once.
void KeysPanel::take_pressed_key(Ui& ui) {
  auto& capture = ui.view.commands.key_capture;
  KeyBindings& bindings = ui.view.preferences.keys;
  if (!capture || !capture->pressed) return;
  const Command& command = find_command(CommandId{capture->command});
  if (command_with_key(capture->pressed, command, bindings) != nullptr) return;
  bind_key(command, capture->index, capture->pressed, bindings);
  end_capture(ui);
}

void KeysPanel::draw_table(Ui& ui) {
  const float lines = 2 * ImGui::GetTextLineHeightWithSpacing();
  const float below = lines + ui.px(theme::kButton) + 2 * ImGui::GetStyle().ItemSpacing.y;
  if (!ImGui::BeginTable("commands", 5, ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY,
                         {0, ImGui::GetContentRegionAvail().y - below}))
    return;
  ImGui::TableSetupColumn("command", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("where", ImGuiTableColumnFlags_WidthFixed, ui.px(140));
  for (const char* name : {"key", "second key"})
    ImGui::TableSetupColumn(name, ImGuiTableColumnFlags_WidthFixed, ui.px(kKeyButtonWidth));
  // The button, and room between it and the scrollbar.
  ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, ui.px(theme::kButton + theme::kGap));
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableHeadersRow();
  ui.begin_row();
  for (int row = 0; row < static_cast<int>(listed_.size()); ++row) draw_row(row, ui);
  ui.end_row();
  moved_ = false;
  ImGui::EndTable();
}

void KeysPanel::draw_row(int row, Ui& ui) {
  const Command& command = *listed_[static_cast<std::size_t>(row)];
  KeyBindings& bindings = ui.view.preferences.keys;
  ImGui::TableNextRow();
  if (row == row_) ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg1, theme::tone(theme::kAccent, 60));
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  draw_text(command.label);
  ui.tooltip(command.help);
  if (row == row_ && moved_) ImGui::SetScrollHereY();
  ImGui::TableNextColumn();
  ui.hint(scope_label(command.scope));
  for (std::size_t index : {0u, 1u}) {
    ImGui::TableNextColumn();
    draw_key(row, index, ui);
  }
  ImGui::TableNextColumn();
  const std::string id(command.id);
  if (bindings.changed.contains(command.id) &&
      ui.icon_button("keys/reset/" + id, Icon::restart, false, "Gives the command its default keys back.",
                     "Ctrl+Delete"))
    reset_keys(command, bindings);
}

void KeysPanel::draw_key(int row, std::size_t index, Ui& ui) {
  const Command& command = *listed_[static_cast<std::size_t>(row)];
  auto& capture = ui.view.commands.key_capture;
  const bool waits = is_captured(capture, command, index);
  const KeyChord chord = command_keys(command, ui.view.preferences.keys)[index];
  const std::string label = waits && !capture->pressed ? "press a key"
                            : waits                    ? to_string(capture->pressed) + "?"
                                                       : to_string(chord);
  const std::string widget = (index == 0 ? "keys/first/" : "keys/second/") + std::string(command.id);
  if (ui.text_button(widget, label, waits, "Click, then press the new key.", "Enter", true,
                     ui.px(kKeyButtonWidth))) {
    capture = KeyCapture{std::string(command.id), index, {}};
    row_ = row;
    column_ = index;
  }
  if (row == row_ && index == column_)
    ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                        theme::tone(theme::kAccent), 0, 0, ui.px(2));
}

void KeysPanel::draw_taken_question(const Command& command, const Command* other, Ui& ui) {
  KeyBindings& bindings = ui.view.preferences.keys;
  const KeyCapture capture = *ui.view.commands.key_capture;
  if (other != nullptr) {
    if (dialog_button({.widget = "keys/take",
                       .label = "Take it",
                       .help = "The other command loses this key.",
                       .letter = 'T',
                       .is_default = asks_for_taken_},
                      ui)) {
      bind_key(command, capture.index, capture.pressed, bindings);
      return end_capture(ui);
    }
    ImGui::SameLine();
  }
  if (dialog_button({.widget = "keys/none",
                     .label = "No key",
                     .help = "Removes this key from the command.",
                     .letter = 'N'},
                    ui)) {
    bind_key(command, capture.index, {}, bindings);
    return end_capture(ui);
  }
  ImGui::SameLine();
  if (dialog_button({.widget = "keys/cancel",
                     .label = "Cancel",
                     .help = "Leaves the key as it was.",
                     .letter = 'C',
                     .is_cancel = true},
                    ui))
    end_capture(ui);
}

void KeysPanel::draw_question(Ui& ui) {
  CommandsView& view = ui.view.commands;
  KeyBindings& bindings = ui.view.preferences.keys;
  if (const auto& capture = view.key_capture) {
    const Command& command = find_command(CommandId{capture->command});
    const Command* other = command_with_key(capture->pressed, command, bindings);
    ui.hint(other == nullptr
                ? "Press the new key for " + std::string(command.label) + ", or Escape."
                : to_string(capture->pressed) + " is the key of \"" + std::string(other->label) + "\".");
    return draw_taken_question(command, other, ui);
  }
  ui.hint(
      "Up and Down choose a command, Left and Right its key; Enter or a click changes it, Delete clears it, "
      "Ctrl+Delete gives the default keys back. Keys of a place work if the focus is there.");
  if (dialog_button({.widget = "keys/close",
                     .label = "Close",
                     .help = "Keeps the keys as they are now.",
                     .letter = 'C',
                     .is_cancel = true,
                     .width = ui.px(96)},
                    ui))
    view.keys_open = false;
  ImGui::SameLine();
  if (dialog_button(
          {.widget = "keys/reset_all",
           .label = asks_reset_ ? "Really reset all" : "Reset all",
           .help = "Gives every command its default keys back; asks once more. While typing: Alt+R.",
           .letter = 'R',
           .enabled = !bindings.changed.empty()},
          ui)) {
    if (asks_reset_) bindings.changed.clear();
    asks_reset_ = !asks_reset_;
  }
}

}  // namespace talus
