// What was added to a level of LDtk, whose ground LDtk has moved, as where a level grows at its left.
#pragma once

#include "ldtk_additions.h"
#include "level/moved_ground.h"

namespace talus {

// Moves all that has a place. additions: see ldtk_additions.h. place: where the ground was. held: the level
// that LDtk gives now. conflicts: counts painted cells that are not on the map any more. Returns how many
// curves would leave it, which are left out.
int move_ldtk_places(Json& additions, Cell by, const GroundPlace& place, const Level& held,
                     LdtkConflicts& conflicts);

}  // namespace talus
