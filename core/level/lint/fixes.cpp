// Finds the fixes of a problem, and tries the fixes of many problems one after the other.
#include "fixes.h"

#include <algorithm>
#include <memory>

#include "../ground_level.h"
#include "fix_trial.h"
#include "rule_group.h"

namespace talus {
namespace {

// Returns the current problems of the rule, and of the rules that are checked with it, at the place of this
// problem.
std::vector<Problem> problems_now(const LintContext& context, const Problem& problem) {
  std::vector<Problem> now;
  const RuleGroup* group = group_of(*problem.rule);
  if (group == nullptr) return now;
  if (group->check_tile != nullptr && problem.tile >= 0) group->check_tile(context, problem.tile, now);
  if (group->check_area != nullptr && problem.cell && context.level.map.contains(*problem.cell))
    group->check_area(context, {*problem.cell, *problem.cell}, now);
  if (group->check_level != nullptr) group->check_level(context, now);
  return now;
}

// Whether the level still has the problem. Its numbers may have changed.
bool is_there(const LintContext& context, const Problem& problem) {
  const std::vector<Problem> now = problems_now(context, problem);
  return std::any_of(now.begin(), now.end(), [&](const Problem& other) {
    return other.rule == problem.rule && other.tile == problem.tile && other.object == problem.object;
  });
}

std::vector<Edit> fixes_with(const LintContext& context, const Problem& problem) {
  std::vector<Edit> edits;
  if (problem.rule->fix != nullptr && is_there(context, problem)) problem.rule->fix(context, problem, edits);
  return edits;
}

bool is_of_cells_alone(const Edit& edit) {
  return std::all_of(edit.changes.begin(), edit.changes.end(),
                     [](const Change& change) { return std::holds_alternative<CellChange>(change); });
}

}  // namespace

std::vector<Edit> fixes_for(const Level& level, const Level& ground, const LintOptions& options,
                            const Problem& problem) {
  const LintTiles tiles(ground, options);
  std::vector<Edit> fixes = fixes_with({ground, tiles}, problem);
  if (!has_plain_ground(level))
    std::erase_if(fixes, [&](const Edit& edit) { return !fits_layers(level, edit); });
  if (fixes.empty()) return fixes;
  Level trial = ground;
  std::erase_if(fixes, [&](const Edit& edit) { return !is_good_fix(trial, tiles, options, edit); });
  return fixes;
}

Edit fix_all(const Level& level, const Level& ground, const LintOptions& options,
             std::span<const Problem> problems, const LintRule& rule, int* fixed) {
  const bool is_plain = has_plain_ground(level);
  Level trial = ground;
  Edit all;
  EditMerger merger;
  auto tiles = std::make_unique<LintTiles>(trial, options);
  int count = 0;
  // Goes from the last problem to the first, as a removed body or curve changes the indices behind it.
  for (std::size_t i = problems.size(); i-- > 0 && count < kMaxFixes;) {
    const Problem& problem = problems[i];
    if (problem.rule != &rule) continue;
    for (const Edit& edit : fixes_with({trial, *tiles}, problem)) {
      if (!is_plain && !fits_layers(level, edit)) continue;
      if (!is_good_fix(trial, *tiles, options, edit)) continue;
      apply_edit(trial, edit);
      if (!is_of_cells_alone(edit)) tiles = std::make_unique<LintTiles>(trial, options);
      merger.merge(all, edit);
      ++count;
      break;
    }
  }
  all.label =
      "Fix " + std::to_string(count) + (count == 1 ? " problem: " : " problems: ") + std::string(rule.label);
  if (fixed != nullptr) *fixed = count;
  return all;
}

}  // namespace talus
