// Runs a hard case and measures how far the run is from the right answer.
#pragma once

#include <vector>

#include <talus/sim/state.h>
#include "../level/hard_case.h"

namespace talus {

struct CaseResult {
  CaseCheck check;
  bool passed = false;
  double measured = 0;  // in the unit of the check's measure; NaN if the run left the range of numbers
};

// Results of all checks, in order, with the solver that the level's tuning names.
std::vector<CaseResult> run_hard_case(const HardCase& hard, const Level& level);

}  // namespace talus
