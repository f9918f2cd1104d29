// Converts SDL's keys to ours, and back.
#pragma once

#include <SDL_events.h>

#include "panels/commands/keys.h"

namespace talus {

KeyChord chord_of(const SDL_Keysym& sym);  // an empty chord for keys without a name here
SDL_Keysym keysym_of(const KeyChord& chord);

}  // namespace talus
