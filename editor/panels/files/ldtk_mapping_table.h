// The table in which values, tags and entities of a project of LDtk are mapped.
#pragma once

#include <talus/level/ldtk_origin.h>
#include "panels/ui/ui.h"

namespace talus {

// Draws it in that size, px, and changes the mapping as the user chooses. Returns whether it was changed.
bool draw_ldtk_mapping(const std::vector<LdtkThing>& things, LdtkMapping& mapping, ImVec2 size, Ui& ui);

}  // namespace talus
