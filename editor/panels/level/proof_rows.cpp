// The rows of the proof.
#include "proof_rows.h"

#include <algorithm>
#include <span>
#include <string>

#include "panels/commands/commands.h"
#include "problem_list.h"
#include "session/checks/prover.h"

namespace talus {
namespace {

constexpr std::size_t kMaxFindingRows = 500;

std::size_t count_of(const Proof& proof) { return proof.findings.size() + proof.more; }

std::span<const Finding> shown_findings(const Session& session) {
  const Proof* proof = session.prover().found();
  if (proof == nullptr) return {};
  return std::span(proof->findings).first(std::min(proof->findings.size(), kMaxFindingRows));
}

void begin_message() {
  ImGui::TableNextRow();
  ImGui::TableSetColumnIndex(1);
}

// How much was proved; while it runs, the button says that.
std::string title_of(const Proof& proof, bool is_running) {
  if (is_running) return "So far: ";
  const int percent = static_cast<int>(proof.share * 100);
  return proof.share < 1 ? "Proof of " + std::to_string(percent) + " %: " : "Proof: ";
}

void draw_summary(const Proof& proof, const Prover& prover, Ui& ui) {
  begin_message();
  draw_wrapped_text(title_of(proof, prover.running()) + summary_of(proof) + ".");
  if (ui.view.requests.take<request::ShowProof>()) ImGui::SetScrollHereY(0);
  ui.item("proof/summary");
  if (proof.left_out > 0)
    ui.hint(std::to_string(proof.left_out) +
            (proof.left_out == 1 ? " kind of body was" : " kinds of bodies were") + " not tried.");
  if (proof.assumes_body) ui.hint("The level has no bodies, so a player was tried.");
  if (!prover.is_stale() || prover.running()) return;
  draw_wrapped_text("The level has changed since: prove it again.", theme::tone(theme::kWarning));
  ui.item("proof/stale");
}

void go_to_finding(const Finding& finding, std::size_t index, Actions& actions, View& view) {
  view.level.problems.chosen_finding = message_of(finding);
  show_cell(finding.cell, view);
  actions.push_back(action::PlayFinding{index});
}

void draw_finding(const Finding& finding, std::size_t index, bool is_wide, Actions& actions, Ui& ui,
                  DrawFix draw_fix) {
  const std::string message = message_of(finding), place = short_cell_text(finding.cell);
  const std::string what = placeless_message_of(finding);  // the cell is beside it
  const std::string& chosen = ui.view.level.problems.chosen_finding;
  ImGui::PushID(static_cast<int>(index));
  begin_message();
  const FindingInfo& info = info_of(finding.kind);
  const ImU32 color = theme::tone(info.of_level ? theme::kWarning : theme::kError);
  const float top = ImGui::GetCursorPosY();
  if (is_wide) draw_text(place, color);
  draw_wrapped_text(what);
  const float height = std::max(ImGui::GetCursorPosY() - top - ImGui::GetStyle().ItemSpacing.y, ui.px(20));
  ImGui::TableSetColumnIndex(0);
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  if (selectable(is_wide ? "" : place, "finding", chosen == message,
                 ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap, {0, height})) {
    go_to_finding(finding, index, actions, ui.view);
  }
  ImGui::PopStyleColor();
  ui.item("proof/row" + std::to_string(index),
          message + (info.of_level ? ".\nA fault of the level. " : ".\nA fault of the solver. ") +
              std::string(info.by_hand),
          "click to go there and to play it");
  ImGui::TableSetColumnIndex(2);
  draw_fix(finding.cell, index);
  ImGui::PopID();
}

}  // namespace

std::size_t findings_of(const Session& session) {
  const Proof* proof = session.prover().found();
  return proof == nullptr ? 0 : count_of(*proof);
}

float width_of_places(const Session& session) {
  float widest = 0;
  for (const Finding& finding : shown_findings(session))
    widest = std::max(widest, size_of_text(short_cell_text(finding.cell)).x);
  return widest;
}

void go_to_next_finding(const Session& session, Actions& actions, Ui& ui) {
  const std::span<const Finding> shown = shown_findings(session);
  if (shown.empty()) return;
  const auto now = std::find_if(shown.begin(), shown.end(), [&](const Finding& finding) {
    return message_of(finding) == ui.view.level.problems.chosen_finding;
  });
  const auto next = static_cast<std::size_t>(now - shown.begin()) + 1;
  const std::size_t index = now == shown.end() || next == shown.size() ? 0 : next;
  go_to_finding(shown[index], index, actions, ui.view);
}

void draw_proof_button(const Session& session, Actions& actions, Ui& ui) {
  const Prover& prover = session.prover();
  if (!prover.running())
    command_text_button("problems/prove"_command, session, actions, ui, {.label = "Prove"});
  if (!prover.follows_edits()) return;
  if (!prover.running()) ImGui::SameLine();
  command_text_button("problems/cancel_proof"_command, session, actions, ui, {.label = "Stop"});
  if (!prover.running()) return;
  ImGui::SameLine();
  ui.label("proved: " + std::to_string(static_cast<int>(prover.progress() * 100)) + " %");
}

void draw_proof_rows(bool is_wide, const Session& session, Actions& actions, Ui& ui, DrawFix draw_fix) {
  const Proof* proof = session.prover().found();
  if (proof == nullptr) return;
  draw_summary(*proof, session.prover(), ui);
  const std::span<const Finding> shown = shown_findings(session);
  ImGui::PushID("proof");
  for (std::size_t i = 0; i < shown.size(); ++i) draw_finding(shown[i], i, is_wide, actions, ui, draw_fix);
  ImGui::PopID();
  const std::size_t all = count_of(*proof);
  if (all == shown.size()) return;
  begin_message();
  ui.hint("... and " + std::to_string(all - shown.size()) + " more.");
}

}  // namespace talus
