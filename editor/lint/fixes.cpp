// Finds the fixes of a problem, and tries those of many one after the other.
#include "fixes.h"

#include <algorithm>
#include <memory>

#include "edit/single_change.h"
#include "fix_parts.h"
#include "lint_parts.h"

namespace talus {
namespace {

bool is_of_tile(std::string_view code) {
  return code == "flags-conflict" || code == "flag-idle" || code == "invisible" || code == "too-steep" ||
         code == "slope-unflagged";
}

// The problems of the tile, of the cell, or of the rest of the level, wherever this one is.
std::vector<Problem> problems_now(const Level& level, const LintTiles& tiles, const Problem& problem) {
  if (is_of_tile(problem.code)) return tiles.problems_of(static_cast<std::size_t>(problem.tile));
  std::vector<Problem> now;
  if (problem.object >= 0 || !problem.cell) {
    lint_level(level, tiles, true, now);
  } else if (level.map.contains(*problem.cell)) {
    lint_cells(level, tiles, {*problem.cell, *problem.cell}, now);
  }
  return now;
}

// Whether the level still has the problem, with the same numbers or others.
bool is_there(const Level& level, const LintTiles& tiles, const Problem& problem) {
  const std::vector<Problem> now = problems_now(level, tiles, problem);
  return std::any_of(now.begin(), now.end(), [&](const Problem& other) {
    return other.code == problem.code && other.tile == problem.tile && other.object == problem.object;
  });
}

std::vector<Edit> fixes_with(const Level& level, const LintTiles& tiles, const Problem& problem) {
  std::vector<Edit> edits;
  if (!is_there(level, tiles, problem)) return edits;
  const std::string& code = problem.code;
  if (code.starts_with("spawn-")) {
    fix_start(level, tiles, problem, edits);
  } else if (code == "too-steep") {
    fix_steepness(level, problem, edits);
  } else if (code.starts_with("seam")) {
    fix_seam(level, tiles, problem, edits);
  } else if (code.starts_with("slope-")) {
    fix_slope(level, tiles, problem, edits);
  } else if (is_of_tile(code)) {
    fix_tile(level, tiles, problem, edits);
  } else {
    fix_level(level, problem, edits);
  }
  return edits;
}

// How many problems the cells around have.
std::size_t problems_around(const Level& level, const LintTiles& tiles, const Problem& problem) {
  std::vector<Problem> found;
  if (problem.cell && level.map.contains(*problem.cell)) {
    const int reach = tiles.reach();
    const Cell cell = *problem.cell;
    lint_cells(level, tiles,
               {Cell{std::max(cell.x - reach, 0), std::max(cell.y - reach, 0)},
                Cell{std::min(cell.x + reach, level.map.width() - 1),
                     std::min(cell.y + reach, level.map.height() - 1)}},
               found);
  }
  return found.size();
}

bool is_of_cells_alone(const Edit& edit) {
  return std::all_of(edit.changes.begin(), edit.changes.end(),
                     [](const Change& change) { return std::holds_alternative<CellChange>(change); });
}

}  // namespace

Edit put_tile(const Level& level, Cell cell, std::uint8_t tile, std::string label) {
  return single_change(std::move(label), CellChange{cell, level.map.at(cell), tile});
}

std::vector<Edit> fixes_for(const Level& level, const LintOptions& options, const Problem& problem) {
  return fixes_with(level, LintTiles(level, options), problem);
}

Edit fix_all(const Level& level, const LintOptions& options, std::span<const Problem> problems,
             std::string_view code, int* fixed) {
  Level trial = level;
  Edit all;
  EditMerger merger;
  auto tiles = std::make_unique<LintTiles>(trial, options);
  int count = 0;
  // From the last one, so that what is removed leaves those before it where they are.
  for (std::size_t i = problems.size(); i-- > 0 && count < kMostFixes;) {
    const Problem& problem = problems[i];
    if (problem.code != code) continue;
    for (const Edit& edit : fixes_with(trial, *tiles, problem)) {
      const std::size_t before = problems_around(trial, *tiles, problem);
      apply_edit(trial, edit);
      auto changed = is_of_cells_alone(edit) ? nullptr : std::make_unique<LintTiles>(trial, options);
      const LintTiles& now = changed ? *changed : *tiles;
      if (!is_there(trial, now, problem) && problems_around(trial, now, problem) <= before) {
        if (changed) tiles = std::move(changed);
        merger.merge(all, edit);
        ++count;
        break;
      }
      revert_edit(trial, edit);
    }
  }
  all.label = "Fix " + std::to_string(count) + (count == 1 ? " problem: " : " problems: ") +
              std::string(rule_label(code));
  if (fixed != nullptr) *fixed = count;
  return all;
}

}  // namespace talus
