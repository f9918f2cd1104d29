// What the problems panel shows, besides the problems.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "lint/lint.h"

namespace talus {

struct ProblemsView {
  std::string kind;               // code of the only listed rule; empty: all rules
  std::optional<Problem> chosen;  // the problem that was gone to last
  std::size_t row = 0;            // its place in the list at that time
  bool scroll = false;            // asks the panel to show it; the next frame takes it
};

}  // namespace talus
