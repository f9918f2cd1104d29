#include "branch_choice.h"

#include <algorithm>
#include <string>

#include "panels/commands/commands.h"
#include "panels/ui/long_list.h"

namespace talus {
namespace {

constexpr float kBranchWidth = 212, kProgressWidth = 140, kLeastBranch = 60;  // px at scale 1

std::string branch_name(const Branch& branch) {
  std::string name = "branch " + std::to_string(branch.id);
  if (branch.parent != 0) name += ", from frame " + std::to_string(branch.fork);
  return name;
}

void draw_rerun(const Session& session, Actions& actions, Ui& ui) {
  const auto percent = static_cast<int>(session.timeline().progress() * 100);
  if (ui.text_button("timeline/cancel", "running " + std::to_string(percent) + " %  x", false,
                     "The recorded input is run again on the changed level. Click to stop: the branch ends "
                     "at the frame that it has reached.",
                     keys_of("timeline/cancel"_command, ui), true, ui.px(kProgressWidth)))
    actions.push_back(action::CancelRerun{});
}

// The other side of a comparison, which takes some time for a long recording.
void draw_comparing(double progress, Actions& actions, Ui& ui) {
  const auto percent = static_cast<int>(progress * 100);
  if (ui.text_button("compare/progress", "comparing " + std::to_string(percent) + " %  x", false,
                     "The same input goes through the other side. Click to stop that: nothing is compared "
                     "then.",
                     keys_of("timeline/cancel"_command, ui), true, ui.px(kProgressWidth)))
    actions.push_back(action::CompareVariant{std::nullopt});
}

void draw_branches(float width, const Session& session, Actions& actions, Ui& ui) {
  const Timeline& timeline = session.timeline();
  const bool open = ui.begin_combo(
      "timeline/branch", branch_name(timeline.current()), width,
      "Branches: playing on from an earlier frame, editing, or other keys make a new one, and the one before "
      "stays.",
      keys_of("timeline/previous_branch"_command, ui) + "  " + keys_of("timeline/next_branch"_command, ui));
  if (!open) return;
  const auto& branches = timeline.branches();
  draw_rows(static_cast<int>(branches.size()), [&](int row) {
    const Branch& branch = branches[static_cast<std::size_t>(row)];
    ImGui::PushID(branch.id);
    const std::string label = branch_name(branch) + "   " + std::to_string(branch.last_frame()) + " frames";
    const bool is_current = branch.id == timeline.current().id;
    const float drop = ui.px(48), row_width = ui.px(310);
    if (selectable(label, {}, is_current, ImGuiSelectableFlags_None, {row_width, 0}))
      actions.push_back(action::SwitchBranch{branch.id});
    ui.item("timeline/branch" + std::to_string(branch.id), "Shows this branch.");
    ImGui::SameLine(row_width + ui.px(8));
    if (ImGui::SmallButton("drop")) actions.push_back(action::DropBranch{branch.id});
    ui.item("timeline/drop" + std::to_string(branch.id), "Deletes this branch.",
            is_current ? keys_of("timeline/drop_branch"_command, ui) : "");
    ImGui::SameLine(row_width + ui.px(8) + drop);
    bool compared = timeline.compared() != nullptr && timeline.compared()->id == branch.id;
    ImGui::BeginDisabled(is_current);
    if (small_button(compared ? "compared" : "compare", "compare"))
      actions.push_back(action::CompareBranch{compared ? 0 : branch.id});
    ImGui::EndDisabled();
    ui.item("timeline/compare" + std::to_string(branch.id),
            "Draws this branch's bodies as ghosts beside those of the branch that is shown.",
            keys_of("compare/next"_command, ui), !is_current);
    ImGui::PopID();
  });
  ImGui::EndCombo();
}

}  // namespace

void draw_branch_choice(const Session& session, Actions& actions, Ui& ui) {
  const float gap = ui.px(8);
  ImGui::SameLine(0, gap);
  const float width = std::min(ui.px(kBranchWidth), ImGui::GetContentRegionAvail().x);
  if (width < ui.px(kLeastBranch)) return;  // the window is very narrow: Debug > Branches has the same
  draw_branches(width, session, actions, ui);
  const auto comparing = session.debugger().comparing_progress(session.timeline());
  if (!session.timeline().behind() && !comparing) return;
  ui.same_line_if_fits(ui.px(kProgressWidth));
  if (session.timeline().behind())
    draw_rerun(session, actions, ui);
  else
    draw_comparing(*comparing, actions, ui);
}

}  // namespace talus
