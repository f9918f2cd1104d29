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

// A kind of problem. There is one object for each kind, and problems point to it; see rule_group.h.
struct LintRule {
  std::string_view code;     // stable name, such as "slope-half-missing"; `talus check` writes it
  std::string_view label;    // on screen: "floor that jumps"
  std::string_view by_hand;  // a sentence: what to do if there is no fix
  Severity severity = Severity::warning;  // of most of its problems
  LintFix* fix = nullptr;                 // null: only the user can know what was intended
  bool has_seam = false;                  // LintOptions::seam decides which jumps are problems
};

struct Problem {
  const LintRule* rule = nullptr;  // never null in what lint() returns
  Severity severity = Severity::warning;
  std::string message;       // one sentence
  std::optional<Cell> cell;  // on the map; empty: the problem has no place
  int tile = -1;             // the tile that it is about, below tile_count(); -1: no tile
  // Index of another thing that it is about: the spawn, the curve, the flag with an invalid shape, or, for a
  // flag with two roles, the second role in flag_role_infos(). -1: no such thing.
  int object = -1;
  friend bool operator==(const Problem&, const Problem&) = default;
};

// Settings for problems that depend on taste.
struct LintOptions {
  // Floors and ceilings may jump by this many px where two tiles meet; 0 to max_seam(). Jumps of a whole tile
  // and more are taken for intended steps.
  double seam = 0;
  friend bool operator==(const LintOptions&, const LintOptions&) = default;
};
// The largest jump, px, that is not a whole tile.
constexpr double max_seam(TileSize tile) { return tile.height - 1.0 / 256; }

// Every kind of problem, except the one that counts problems that are not listed.
std::span<const LintRule* const> lint_rules();

// The most problems that are listed. If there are more, one more problem without a place says how many are
// not listed.
inline constexpr std::size_t kMaxProblems = 1000;

// Returns the problems by row, then column, then rule. Problems without a cell come first.
std::vector<Problem> lint(const Level& level, const LintOptions& options = {});

// Returns the problems about ground that the level's solver does not know, so that bodies pass through it.
std::vector<Problem> ignored_ground(const Level& level);

}  // namespace talus
