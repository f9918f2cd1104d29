// What the panel of problems shows, besides the problems.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "lint/lint.h"

namespace talus {

struct ProblemsView {
  std::string kind;               // code of the only rule that is listed; empty: all
  std::optional<Problem> chosen;  // the last one that was gone to
  std::size_t row = 0;            // where it was in the list, which may be another one by now
  bool scroll = false;            // asks the panel to show it; taken by the next frame
};

}  // namespace talus
