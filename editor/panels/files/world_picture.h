// The levels of a project of LDtk, as they lie in their world.
#pragma once

#include <vector>

#include "formats/ldtk/ldtk_format.h"
#include "panels/ui/ui.h"

namespace talus {

// Draws the levels of the world that the chosen one is in, in that size, px. pictures: what levels look like,
// by index; for one that is null or missing a box in its colour is drawn. Returns the index of the level that
// is clicked, or `chosen`.
int draw_world(const std::vector<LdtkLevelName>& levels,
               const std::vector<std::shared_ptr<const SheetPicture>>& pictures, int chosen, ImVec2 size,
               Ui& ui);

// The places of the levels, in px of a world, by index: levels without places are put in a row. Levels of
// other worlds than that of `chosen` have no size.
std::vector<Rect> places_in_world(const std::vector<LdtkLevelName>& levels, int chosen);

}  // namespace talus
