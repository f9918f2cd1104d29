// Finds what is likely wrong in a level.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "level.h"

namespace talus {

enum class Severity { warning, error };

struct Problem {
  Severity severity = Severity::warning;
  std::string code;          // stable name of the rule, such as "slope-half-missing"
  std::string message;       // one sentence
  std::optional<Cell> cell;  // where on the map, if it has a place there
  int tile = -1;             // which tile, 0..255, if it is about one; else -1
};

// A level wrong in more places than this gets one more problem, without a place, that says how many are left.
inline constexpr std::size_t kMaxProblems = 1000;

// The problems, by row, then column, then rule; those without a cell first.
std::vector<Problem> lint(const Level& level);

}  // namespace talus
