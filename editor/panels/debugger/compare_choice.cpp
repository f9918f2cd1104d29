#include "compare_choice.h"

#include <algorithm>

namespace talus {

std::vector<CompareChoice> compare_choices(const Session& session) {
  std::vector<CompareChoice> choices = {
      {"nothing", "nothing", std::nullopt, 0},
      {"exact", "exact", Variant{SolverKind::exact, false}, 0},
      {"exact, single precision", "single", Variant{SolverKind::exact, true}, 0},
      {"bump", "bump", Variant{SolverKind::bump, false}, 0},
      {"article", "article", Variant{SolverKind::article, false}, 0}};
  for (const Branch& branch : session.timeline().branches()) {
    if (branch.id == session.timeline().current().id) continue;
    const std::string id = std::to_string(branch.id);
    choices.push_back({"branch " + id, "branch" + id, std::nullopt, branch.id});
  }
  return choices;
}

CompareChoice compare_choice(const Session& session) {
  const VariantBranch* variant = session.debugger().side_by_side().variant();
  const Branch* branch = session.timeline().compared();
  const auto choices = compare_choices(session);
  const auto made = std::find_if(choices.begin(), choices.end(), [&](const CompareChoice& choice) {
    return variant != nullptr ? choice.variant == variant->variant()
                              : !choice.variant && choice.branch == (branch != nullptr ? branch->id : 0);
  });
  return made != choices.end() ? *made : choices.front();
}

bool is_compared(const Session& session) {
  return session.debugger().side_by_side().variant() != nullptr || session.timeline().compared() != nullptr;
}

std::string missing_side(const Session& session) {
  if (!is_compared(session) || session.other_state() != nullptr) return {};
  const std::string name = compare_choice(session).label;
  if (const auto progress = session.debugger().comparing_progress(session.timeline()))
    return name + " is run: " + std::to_string(static_cast<int>(*progress * 100)) + " %";
  return name + " ends at frame " + std::to_string(session.debugger().other_end().value_or(0));
}

void compare_with(const CompareChoice& choice, Actions& actions) {
  actions.push_back(action::CompareVariant{choice.variant});
  if (!choice.variant) actions.push_back(action::CompareBranch{choice.branch});
}

}  // namespace talus
