// The chosen body among those placed on the map.
#pragma once

#include "session/session.h"

namespace talus {

// Index of the chosen body's spawn; -1 if it has none, or no body is chosen.
int chosen_spawn(const Session& session);
// index: of the level's spawns (not checked).
const Spawn& spawn_of(const Session& session, int index);

}  // namespace talus
