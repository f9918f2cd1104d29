// Draws the list of edits, to go back to one of them.
#include "history_panel.h"

#include <string>
#include <utility>

#include "edit_text.h"
#include "panels/ui/long_list.h"

namespace talus {

void HistoryPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  const UndoStack& history = session.history();
  const auto& edits = history.edits();
  if (edits.empty()) {
    ui.hint("Nothing changed yet: what you paint is listed here, and a click goes back to it.");
    return;
  }
  std::size_t wanted = history.position();
  ImGui::BeginChild("list");
  if (std::exchange(followed_, history.position()) != history.position())
    scroll_to_row(static_cast<int>(history.position()));
  draw_rows(static_cast<int>(edits.size()) + 1, [&](int row) {
    const auto i = static_cast<std::size_t>(row);
    const std::string label = i == 0 ? "as opened" : describe(edits[i - 1]);
    const bool undone = i > history.position();
    if (undone) ImGui::PushStyleColor(ImGuiCol_Text, theme::tone(theme::kMuted));
    if (selectable(label, std::to_string(i), i == history.position())) wanted = i;
    if (undone) ImGui::PopStyleColor();
    ui.item("history/entry" + std::to_string(i), label + ": undoes or redoes up to here.");
  });
  ImGui::EndChild();
  for (std::size_t i = history.position(); i > wanted; --i) actions.push_back(action::Undo{});
  for (std::size_t i = history.position(); i < wanted; ++i) actions.push_back(action::Redo{});
}

}  // namespace talus
