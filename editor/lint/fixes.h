// Fixes: what can be done about a problem with one click. Each is an Edit whose label says what it does.
#pragma once

#include <span>
#include <vector>

#include "edit/edit.h"
#include "lint.h"

namespace talus {

// The best first. None where nobody but the user can tell what is meant, and where the level has changed so
// that the problem is gone.
std::vector<Edit> fixes_for(const Level& level, const LintOptions& options, const Problem& problem);

// One edit that fixes the listed problems of a rule, each by its first fix that makes no new problem around,
// and no more than kMostFixes of them, so that nobody waits long; problems without a fix stay. fixed: if not
// null, how many were fixed.
inline constexpr int kMostFixes = 200;
Edit fix_all(const Level& level, const LintOptions& options, std::span<const Problem> problems,
             const LintRule& rule, int* fixed = nullptr);

}  // namespace talus
