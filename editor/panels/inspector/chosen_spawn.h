// The chosen body among those placed on the map.
#pragma once

#include "session/session.h"

namespace talus {

// Index of the chosen body's spawn; -1 if it has none, or no body is chosen.
int chosen_spawn(const Session& session);

}  // namespace talus
