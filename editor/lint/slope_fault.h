// What is wrong beside a flagged slope.
#pragma once

#include <optional>
#include <string>

#include "lint_tiles.h"

namespace talus {

struct SlopeFault {
  const LintRule* rule;
  std::string text;  // the end of a sentence
};
// Nothing where no flagged slope is, or where it is whole.
std::optional<SlopeFault> slope_fault_at(const Level& level, const LintTiles& tiles, Cell cell);

}  // namespace talus
