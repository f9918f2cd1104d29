// Which commands would answer to one key, and changing keys so that none does twice.
#pragma once

#include "commands.h"

namespace talus {

// The other command that the key works for wherever `command` works with it too; null: none.
const Command* command_with_key(KeyChord chord, const Command& command, const KeyBindings& bindings);
// Gives the command the key as the first or second one (0, 1), and takes it from whichever had it.
void bind_key(const Command& command, std::size_t index, KeyChord chord, KeyBindings& bindings);
// Gives the command its own keys back, and takes them from whichever has them.
void reset_keys(const Command& command, KeyBindings& bindings);

}  // namespace talus
