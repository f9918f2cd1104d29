// What the problems panel shows, besides the problems.
#pragma once

#include <cstddef>
#include <optional>

#include "lint/lint.h"

namespace talus {

struct ProblemsView {
  const LintRule* kind = nullptr;  // the only listed rule; null: all rules
  std::optional<Problem> chosen;   // the problem that was gone to last
  std::size_t row = 0;             // its place in the list at that time
  bool scroll = false;             // asks the panel to show it; the next frame takes it
};

}  // namespace talus
