// Finds what is likely wrong in a level.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <talus/level/level.h>

namespace talus {

enum class Severity { warning, error };

struct Problem {
  Severity severity = Severity::warning;
  std::string code;          // stable name of the rule, such as "slope-half-missing"; see lint_rules()
  std::string message;       // one sentence
  std::optional<Cell> cell;  // where on the map, if it has a place there
  int tile = -1;             // which tile, 0..255, if it is about one; else -1
  // Index of what else it is about: of the spawn, of the curve, of the flag with a bad shape, or of the
  // second role, in flag_role_infos(), of a shared flag; else -1.
  int object = -1;
  friend bool operator==(const Problem&, const Problem&) = default;
};

// What counts as a problem where tastes differ.
struct LintOptions {
  // px, 0 to below kTileSize: floors and ceilings may jump by as much where two tiles meet. Jumps of a whole
  // tile and more are steps that are meant.
  double seam = 0;
  friend bool operator==(const LintOptions&, const LintOptions&) = default;
};
inline constexpr double kMaxSeam = kTileSize - 1.0 / 256;

// A kind of problem.
struct LintRule {
  std::string_view code;   // as Problem::code
  std::string_view label;  // on screen: "seam"
};
// Every kind, but the one that says how many are not listed.
std::span<const LintRule> lint_rules();
std::string_view rule_label(std::string_view code);  // the code itself, where it is no rule's

// A level wrong in more places than this gets one more problem, without a place, that says how many are left.
inline constexpr std::size_t kMaxProblems = 1000;

// The problems, by row, then column, then rule; those without a cell first.
std::vector<Problem> lint(const Level& level, const LintOptions& options = {});

}  // namespace talus
