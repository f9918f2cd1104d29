// What the shown branch can be compared with.
#pragma once

#include <string>

#include "session/session.h"

namespace talus {

// One side of a comparison: a variant of the same branch, or another branch.
struct CompareChoice {
  std::string label;  // "exact, single precision", "branch 2"
  std::string key;    // for the names of widgets
  std::optional<Variant> variant;
  int branch = 0;  // id; 0 for a variant, and for no comparison
  friend bool operator==(const CompareChoice&, const CompareChoice&) = default;
};

// First "nothing", then the variants, then the other branches in their order.
std::vector<CompareChoice> compare_choices(const Session& session);
CompareChoice compare_choice(const Session& session);  // the current choice
void compare_with(const CompareChoice& choice, Actions& actions);
bool is_compared(const Session& session);  // whether there is a comparison
// Why the shown frame has no other side: "branch 5 ends at frame 12"; empty if it has one, or if there is no
// comparison.
std::string missing_side(const Session& session);

}  // namespace talus
