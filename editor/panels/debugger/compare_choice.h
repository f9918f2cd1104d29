// What the shown run can be compared with.
#pragma once

#include <string>

#include "session/session.h"

namespace talus {

// One side of a comparison: a variant of the same run, or another branch.
struct CompareChoice {
  std::string label;  // "exact, single precision", "branch 2"
  std::string key;    // for the names of widgets
  std::optional<Variant> variant;
  int branch = 0;  // id; 0 with a variant, and of nothing
  friend bool operator==(const CompareChoice&, const CompareChoice&) = default;
};

// Nothing first, then the variants, then the other branches in their order.
std::vector<CompareChoice> compare_choices(const Session& session);
CompareChoice compare_choice(const Session& session);  // the one that is made
void compare_with(const CompareChoice& choice, Actions& actions);
bool is_compared(const Session& session);  // with anything
// Why the other side is not there in the shown frame: "branch 5 ends at frame 12"; empty: it is there, or
// nothing is compared.
std::string missing_side(const Session& session);

}  // namespace talus
