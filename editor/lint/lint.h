// Finds what is likely wrong in a level.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <talus/level/level.h>

namespace talus {

struct Edit;
struct LintContext;
struct Problem;

enum class Severity { warning, error };

// Appends edits that fix a problem of the rule, the best first.
using LintFix = void(const LintContext& context, const Problem& problem, std::vector<Edit>& out);

// A kind of problem. There is one object of each, which problems point to; see rule_group.h.
struct LintRule {
  std::string_view code;   // stable name, such as "slope-half-missing"; `talus check` writes it
  std::string_view label;  // on screen: "floor that jumps"
  Severity severity = Severity::warning;  // of most of its problems
  LintFix* fix = nullptr;                 // null: nobody but the user can tell what is meant
  bool has_seam = false;                  // LintOptions::seam says what counts
};

struct Problem {
  const LintRule* rule = nullptr;  // never null in what lint() returns
  Severity severity = Severity::warning;
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

// Every kind, but the one that says how many are not listed.
std::span<const LintRule* const> lint_rules();

// A level wrong in more places than this gets one more problem, without a place, that says how many are left.
inline constexpr std::size_t kMaxProblems = 1000;

// The problems, by row, then column, then rule; those without a cell first.
std::vector<Problem> lint(const Level& level, const LintOptions& options = {});

// Those of them that are about ground that the level's solver does not know, so that bodies pass through it.
std::vector<Problem> ignored_ground(const Level& level);

}  // namespace talus
