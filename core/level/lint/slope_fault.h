// What is wrong with a flagged slope.
#pragma once

#include <optional>
#include <string>

#include "lint_tiles.h"

namespace talus {

struct SlopeFault {
  const LintRule* rule;
  std::string text;  // the end of a sentence
};
// Returns the fault of the flagged slope in a cell; empty if there is no such slope, or if it is complete.
std::optional<SlopeFault> slope_fault_at(const Level& level, const LintTiles& tiles, Cell cell);

}  // namespace talus
