// Finds commands that have the same key at the same place, and changes keys without making such conflicts.
#pragma once

#include "commands.h"

namespace talus {

// Returns another command that this key would run at a place where it would also run `command`; null if there
// is none.
const Command* command_with_key(KeyChord chord, const Command& command, const KeyBindings& bindings);
// Gives the command the key as its first or second one (0 or 1), and takes it from the commands that had it.
void bind_key(const Command& command, std::size_t index, KeyChord chord, KeyBindings& bindings);
// Gives the command its default keys back, and takes them from the commands that have them.
void reset_keys(const Command& command, KeyBindings& bindings);

}  // namespace talus
