// The panel of the reach.
#include "reach_panel.h"

#include <string>

#include "level/level_text.h"
#include "panels/commands/commands.h"

namespace talus {
namespace {

std::string found_text(const ReachSearch& found) {
  return count_text(found.cells(), "cell") + " reached, in " + count_text(found.known(), "state") +
         " up to " + count_text(static_cast<std::size_t>(found.frames()), "frame") + " from the start.";
}

}  // namespace

void ReachPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  const ReachFinder& reach = session.reach();
  const ReachSearch* found = reach.found();
  command_text_button(reach.running() ? "reach/cancel"_command : "reach/find"_command, session, actions, ui);
  if (found == nullptr) {
    ui.hint(
        "Marks the cells that a player gets to from its start, by every combination of its keys. A body "
        "placed "
        "with the body tool becomes a player in the inspector; where several are, the chosen one is "
        "followed.");
    return;
  }
  if (reach.running()) {
    ImGui::SameLine();
    const double share = static_cast<double>(found->followed()) / static_cast<double>(found->known());
    ImGui::ProgressBar(static_cast<float>(share), {ui.px(180), ui.px(theme::kButton)}, "");
    ui.item("reach/progress", "States that were searched, out of those that are known so far.");
  }
  draw_text(found_text(*found));
  ui.item("reach/found");
  if (reach.is_stale()) {
    ImGui::PushStyleColor(ImGuiCol_Text, theme::tone(theme::kWarning));
    ImGui::TextUnformatted("The level has changed since: search again.");
    ImGui::PopStyleColor();
    ui.item("reach/stale");
    return;
  }
  draw_way(session, actions, ui);
  if (found->is_full()) {
    ui.hint("The search ended at the largest number of states: more may be reachable.");
  } else if (!reach.running() && !found->finished()) {
    ui.hint("The search was stopped: more may be reachable.");
  }
  ui.hint(
      "The solver has reached the marked cells. Others may still be reachable, by keys that change "
      "more often than every 4 frames.");
  if (reach.others() > 0) ui.hint("The other bodies of the level were left out; they may block the way.");
}

void ReachPanel::draw_way(const Session& session, Actions& actions, Ui& ui) {
  const ReachSearch& found = *session.reach().found();
  // The mouse crosses the canvas's edge on its way here, so the last cell under it would be a cell at the
  // edge. The clicked cell stays.
  const auto& pointed = ui.view.canvas.hover_before.cell;
  const auto& clicked = ui.view.canvas.clicked_cell;
  if (clicked != clicked_ && clicked && found.reached(*clicked)) chosen_ = clicked;
  clicked_ = clicked;
  if (pointed && found.reached(*pointed))
    cell_ = pointed;
  else if (chosen_ && !pointed)
    cell_ = chosen_;
  if (!cell_ || !found.reached(*cell_)) {
    ui.hint("Point at a marked cell to see how long the way to it is; a click chooses it.");
    return;
  }
  const std::size_t frames = found.way_to(*cell_).size();
  const std::string text = "To (" + std::to_string(cell_->x) + ", " + std::to_string(cell_->y) +
                           "): " + count_text(frames, "frame");
  if (ui.text_button("reach/play_way", "Play", false,
                     "Plays the way as a new branch of the timeline, which shows the keys too.",
                     keys_of("reach/show_way"_command, ui) + " over a cell", frames > 0))
    actions.push_back(action::ShowWay{*cell_});
  ImGui::SameLine();
  ui.label(text);
}

}  // namespace talus
