// What a fix of a problem would make of the ground, for a picture of it on the map.
#pragma once

#include <vector>

#include "level/edit.h"

namespace talus {

struct FixPreview {
  Level level;              // after the fix
  std::vector<Cell> cells;  // whose ground it changes, at most kMaxPreviewCells
};
inline constexpr std::size_t kMaxPreviewCells = 4096;

FixPreview preview_of(const Level& level, const Edit& fix);

}  // namespace talus
