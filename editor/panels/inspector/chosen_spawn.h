// The body that is chosen among those placed on the map.
#pragma once

#include "session/session.h"

namespace talus {

// The number of the chosen body's spawn; -1 when it has none or no body is chosen.
int chosen_spawn(const Session& session);

}  // namespace talus
