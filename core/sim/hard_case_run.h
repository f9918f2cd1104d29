// Runs a hard case and measures how far the run is from the right answer.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include <talus/sim/state.h>
#include "../level/hard_case.h"

namespace talus {

struct CaseResult {
  CaseCheck check;
  bool passed = false;
  double measured = 0;  // in the unit of the check's measure; NaN if the run left the range of numbers
};

// A run keeps the bodies and contacts of all its frames. There may be this many of them together.
inline constexpr std::size_t kMaxCaseBodies = std::size_t{1} << 21, kMaxCaseContacts = std::size_t{1} << 22;

// Results of all checks, in order, with the solver that the level's tuning names. The error is a sentence
// about the case: "makes 1000000 frames of 3000 bodies, but ...", or "removes body 7, but the level has 6".
tl::expected<std::vector<CaseResult>, std::string> run_hard_case(const HardCase& hard, const Level& level);

}  // namespace talus
