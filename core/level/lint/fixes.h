// Fixes: edits that remove a problem by one click. The label of each edit says what it does.
#pragma once

#include <span>
#include <vector>

#include "../edit.h"
#include "lint.h"

namespace talus {

// Returns the fixes that make the level better (see is_good_fix), the best first. The list is empty if there
// is none, so that only the user can know what was intended, or if the problem is gone from the level.
// ground: the level itself if it has_plain_ground(), else its ground_level(), which takes long for a large
// map.
std::vector<Edit> fixes_for(const Level& level, const Level& ground, const LintOptions& options,
                            const Problem& problem);

// Returns one edit that fixes the listed problems of a rule. It takes the first of fixes_for() for
// each problem, and skips problems without one. It fixes at most kMaxFixes problems, so that
// nobody waits long. ground: as above. fixed: gets the number of fixed problems, unless null.
inline constexpr int kMaxFixes = 200;
Edit fix_all(const Level& level, const Level& ground, const LintOptions& options,
             std::span<const Problem> problems, const LintRule& rule, int* fixed = nullptr);

}  // namespace talus
