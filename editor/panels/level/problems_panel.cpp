// The list of problems.
#include "problems_panel.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "level/lint/fixes.h"
#include "panels/canvas/fix_preview.h"
#include "panels/commands/commands.h"
#include "problem_list.h"
#include "proof_rows.h"
#include "session/checks/prover.h"

namespace talus {
namespace {

constexpr std::size_t kMaxRemedies = 2000;
constexpr int kRemediesAFrame = 4;  // finding a remedy takes up to a few ms
constexpr float kFix = 32,
                kWidePlace = 90;  // px at scale 1: width of the button, above which a place has its own line

// tile_count: of the level; problems of the ground have other tiles, too.
std::string place_of(const Problem& problem, int tile_count) {
  if (problem.cell) return short_cell_text(*problem.cell);
  return problem.tile >= 0 && problem.tile < tile_count ? "#" + std::to_string(problem.tile) : "level";
}

std::string looking_text(const Session& session) {
  return "Looking at the level: " + std::to_string(static_cast<int>(session.lint_progress() * 100)) + " %.";
}

std::string key_of(const Problem& problem) {
  return std::string(problem.rule->code) + ": " + problem.message;
}

float width_of(const std::string& text) { return size_of_text(text).x; }

}  // namespace

void ProblemsPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  looked_for_ = 0;
  is_previewed_ = false;
  if (remedies_.size() > kMaxRemedies) remedies_.clear();
  draw_proof_button(session, actions, ui);
  if (!ui.problems->empty() && !session.prover().running()) ImGui::SameLine();
  if (ui.problems->empty()) {
    if (session.is_linting())
      ui.hint(looking_text(session));
    else if (findings_of(session) == 0)
      ui.hint(session.prover().found() == nullptr
                  ? "No problem found in this level. Prove plays it, and finds more."
                  : "No problem found in this level.");
    ui.view.level.problems.kind = nullptr;
  } else {
    draw_bar(session, actions, ui);
  }
  // Also while a button of a row is pressed.
  const bool is_hovered =
      ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows | ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  note_followed_body(session, is_hovered, ui.view.level.problems);
  const std::vector<std::size_t> rows = listed_rows(ui);
  if (rows.empty() && !ui.problems->empty())
    ui.hint(session.is_linting() ? looking_text(session) : "No problem of this kind is left.");
  draw_rows(rows, session, actions, ui);
  if (!is_previewed_) ui.view.canvas.fix_preview.reset();
}

void ProblemsPanel::draw_bar(const Session& session, Actions& actions, Ui& ui) {
  ui.begin_row();
  draw_kinds(session, ui);
  const auto button = [&](CommandId id, std::string_view label) {
    ImGui::SameLine();
    command_text_button(id, session, actions, ui, {.label = label});
  };
  button("problems/previous"_command, "<");
  button("problems/next"_command, ">");
  const LintRule* kind = ui.view.level.problems.kind;
  if (kind != nullptr) {
    ImGui::SameLine();
    if (ui.text_button(
            "problems/fix_all", "Fix all", false,
            "Fixes every problem of this kind that can be fixed, each as its own Fix button says, as "
            "one change that can be undone.",
            keys_of("problems/fix_kind"_command, ui)))
      fix_all_problems(*kind, session, actions, ui);
  }
  if (kind != nullptr && kind->has_seam) draw_seam(session, actions, ui);
  ui.end_row();
}

void ProblemsPanel::draw_kinds(const Session& session, Ui& ui) {
  const LintRule*& kind = ui.view.level.problems.kind;
  const auto count = [&](const LintRule& rule) {
    return std::count_if(ui.problems->begin(), ui.problems->end(),
                         [&](const Problem& problem) { return problem.rule == &rule; });
  };
  const auto text = [&](std::string_view label, std::ptrdiff_t number) {
    return std::string(label) + " (" + std::to_string(number) + ")";
  };
  const std::string all =
      text("all", static_cast<std::ptrdiff_t>(ui.problems->size() + findings_of(session)));
  const std::string preview = kind == nullptr ? all : text(kind->label, count(*kind));
  const float others = ui.px(kind == nullptr ? 64 : 126);
  if (!ui.begin_combo("problems/kind", preview,
                      std::max(ImGui::GetContentRegionAvail().x - others, ui.px(90)),
                      "Which kind of problem is listed."))
    return;
  if (selectable(all, {}, kind == nullptr)) kind = nullptr;
  ui.item("problems/kind_all");
  for (const LintRule* rule : lint_rules()) {
    const std::ptrdiff_t number = count(*rule);
    if (number == 0) continue;
    if (selectable(text(rule->label, number), {}, kind == rule)) kind = rule;
    ui.item("problems/kind_" + std::string(rule->code));
  }
  ImGui::EndCombo();
}

void ProblemsPanel::draw_seam(const Session& session, Actions& actions, Ui& ui) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Allow jumps of up to");
  ImGui::SameLine();
  double seam = session.lint_options().seam;
  ImGui::SetNextItemWidth(ui.px(56));
  if (ImGui::InputDouble("##seam", &seam, 0, 0, "%.6g")) actions.push_back(action::SetLintOptions{{seam}});
  ui.item("problems/seam",
          "Jumps of a floor or a ceiling up to this many px, less than a tile, are not listed.");
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("px");
}

void ProblemsPanel::draw_rows(const std::vector<std::size_t>& rows, const Session& session, Actions& actions,
                              Ui& ui) {
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY;
  if (!ImGui::BeginTable("problems", 3, kFlags, ImGui::GetContentRegionAvail())) return;
  const std::size_t shown = std::min(rows.size(), kMaxProblemRows);
  const int tiles = session.level().tile_count();
  float place = std::max(ui.px(40), width_of_places(session));
  for (std::size_t i = 0; i < shown; ++i)
    place = std::max(place, width_of(place_of((*ui.problems)[rows[i]], tiles)));
  const bool is_wide = place > ui.px(kWidePlace);  // the place is above the message
  ImGui::TableSetupColumn("place", ImGuiTableColumnFlags_WidthFixed, is_wide ? 1 : place + ui.px(4));
  ImGui::TableSetupColumn("message", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("fix", ImGuiTableColumnFlags_WidthFixed, ui.px(kFix));
  for (std::size_t i = 0; i < shown; ++i) draw_row(rows[i], session, actions, ui);
  if (rows.size() > shown) {
    ImGui::TableNextRow();
    ImGui::TableSetColumnIndex(1);
    ui.hint("... and " + std::to_string(rows.size() - shown) + " more.");
  }
  if (session.is_linting() && !rows.empty()) {  // below the rows, which do not move
    ImGui::TableNextRow();
    ImGui::TableSetColumnIndex(1);
    ui.hint(looking_text(session));
  }
  if (ui.view.level.problems.kind == nullptr)
    draw_proof_rows(is_wide, session, actions, ui,
                    [&](Cell cell, std::size_t row) { draw_fix_near(cell, row, session, actions, ui); });
  ImGui::EndTable();
}

// The fix of a finding is that of a floor that jumps in its cell or beside it.
void ProblemsPanel::draw_fix_near(Cell cell, std::size_t row, const Session& session, Actions& actions,
                                  Ui& ui) {
  if (!ImGui::IsItemVisible()) return;
  for (const Problem& problem : *ui.problems) {
    const bool is_near = problem.rule->has_seam && problem.cell && std::abs(problem.cell->x - cell.x) <= 1 &&
                         std::abs(problem.cell->y - cell.y) <= 1;
    if (!is_near) continue;
    const Remedy& remedy = remedy_of(problem, session);
    if (remedy.fixes.empty()) continue;
    if (ImGui::SmallButton("Fix")) fix_problem(problem, 0, session, actions, ui);
    preview(problem, 0, session, ui);
    ui.item("proof/fix" + std::to_string(row), remedy.fixes.front() + ".");
    return;
  }
}

void ProblemsPanel::draw_row(std::size_t index, const Session& session, Actions& actions, Ui& ui) {
  const Problem& problem = (*ui.problems)[index];
  const std::string row = std::to_string(index);
  const std::string place = place_of(problem, session.level().tile_count());
  const bool is_chosen = ui.view.level.problems.chosen == problem;
  ImGui::PushID(static_cast<int>(index));
  ImGui::TableNextRow();
  ImGui::TableSetColumnIndex(1);
  const bool is_wide = width_of(place) > ui.px(kWidePlace);
  const ImU32 color = theme::tone(problem.severity == Severity::error ? theme::kError : theme::kWarning);
  const float top = ImGui::GetCursorPosY();
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  if (is_wide) draw_text(place);
  ImGui::PopStyleColor();
  ImGui::PushTextWrapPos(0);
  draw_text(shown_line(problem.message));
  ImGui::PopTextWrapPos();
  const float height = std::max(ImGui::GetCursorPosY() - top - ImGui::GetStyle().ItemSpacing.y, ui.px(20));
  ImGui::TableSetColumnIndex(0);
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  if (selectable(is_wide ? "" : place, "place", is_chosen,
                 ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap, {0, height}))
    go_to_problem(index, session, actions, ui);
  ImGui::PopStyleColor();
  std::string help(problem.message.size() > kMaxLine ? problem.message : problem.rule->label);
  if (has_no_fix(problem, session)) help += "\n" + std::string(problem.rule->by_hand);
  ui.item("problems/row" + row, help, "click to go there");
  if (is_chosen && ui.view.requests.take<request::ShowProblem>()) ImGui::SetScrollHereY(0.5f);
  if (ImGui::IsItemVisible()) {
    const Remedy& remedy = remedy_of(problem, session);
    draw_menu(problem, remedy, session, actions, ui);
    ImGui::TableSetColumnIndex(2);
    if (!remedy.fixes.empty()) {
      if (ImGui::SmallButton("Fix")) fix_problem(problem, 0, session, actions, ui);
      preview(problem, 0, session, ui);
      ui.item("problems/fix" + row, remedy.fixes.front() + ".",
              is_chosen ? keys_of("problems/fix"_command, ui) : "");
    }
  }
  ImGui::PopID();
}

// The menu of a row, which is ImGui's last item.
void ProblemsPanel::draw_menu(const Problem& problem, const Remedy& remedy, const Session& session,
                              Actions& actions, Ui& ui) {
  if (!ImGui::BeginPopupContextItem("fixes")) return;
  for (std::size_t i = 0; i < remedy.fixes.size(); ++i) {
    if (menu_item(remedy.fixes[i], std::to_string(i))) fix_problem(problem, i, session, actions, ui);
    preview(problem, i, session, ui);
    ui.item("problems/choice" + std::to_string(i));
  }
  if (remedy.fixes.empty()) draw_text(problem.rule->by_hand);
  ImGui::Separator();
  if (ImGui::MenuItem("Fix all of this kind")) fix_all_problems(*problem.rule, session, actions, ui);
  ui.item("problems/choice_all");
  if (ImGui::MenuItem("List only this kind")) ui.view.level.problems.kind = problem.rule;
  ui.item("problems/choice_kind");
  ImGui::EndPopup();
}

// If the mouse is over ImGui's last item, which makes a fix, the map shows what the fix would make.
void ProblemsPanel::preview(const Problem& problem, std::size_t fix, const Session& session, Ui& ui) {
  if (!ImGui::IsItemHovered()) return;
  is_previewed_ = true;
  std::shared_ptr<const FixPreview>& shown = ui.view.canvas.fix_preview;
  std::string& previewed = ui.view.level.problems.previewed;
  std::string key = std::to_string(session.revision()) + "/" + std::to_string(fix) + "/" + key_of(problem);
  if (shown != nullptr && previewed == key) return;
  previewed = std::move(key);
  const std::vector<Edit> fixes =
      fixes_for(session.level(), session.linted_level(), session.lint_options(), problem);
  shown.reset();
  if (fix < fixes.size()) shown = std::make_shared<const FixPreview>(preview_of(session.level(), fixes[fix]));
}

// Whether it is known by now that no fix is good.
bool ProblemsPanel::has_no_fix(const Problem& problem, const Session& session) const {
  const auto known = remedies_.find(key_of(problem));
  return known != remedies_.end() && known->second.revision == session.revision() + 1 &&
         known->second.fixes.empty();
}

// During a drag the last result is used.
const ProblemsPanel::Remedy& ProblemsPanel::remedy_of(const Problem& problem, const Session& session) {
  Remedy& remedy = remedies_[key_of(problem)];
  const std::uint64_t now = session.revision() + 1;  // 0: not computed yet
  if (remedy.revision == now || looked_for_ == kRemediesAFrame || ImGui::IsAnyMouseDown()) return remedy;
  ++looked_for_;
  remedy = {{}, now};
  for (Edit& edit : fixes_for(session.level(), session.linted_level(), session.lint_options(), problem))
    remedy.fixes.push_back(std::move(edit.label));
  return remedy;
}

}  // namespace talus
