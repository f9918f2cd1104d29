// Tries a fix: compares what the lint finds, and the outline of the ground, before and after it.
#pragma once

#include "../edit.h"
#include "lint_tiles.h"

namespace talus {

// Whether a fix makes the level better: the lint finds less where the fix changes something, nothing of a
// kind or at a place that was free of it, and there is no new wall, ceiling or pit. A fix that changes the
// ground in too many places to look at all of them is not good. level: is changed and restored meanwhile.
// tiles: of the level.
bool is_good_fix(Level& level, const LintTiles& tiles, const LintOptions& options, const Edit& edit);

}  // namespace talus
