// What to do if the level has no tiles for ground.
#pragma once

#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// Shows the panel with the ground's tiles and says what it is for.
void ask_for_ground_tiles(Actions& actions, Ui& ui);

}  // namespace talus
