// Finds and resolves conflicts of keys.
#include "key_conflicts.h"

#include <algorithm>

namespace talus {
namespace {

bool scopes_meet(Scope a, Scope b) { return a == Scope::everywhere || b == Scope::everywhere || a == b; }

// Default keys are not stored as a change.
void store_keys(const Command& command, CommandKeys keys, KeyBindings& bindings) {
  if (keys == CommandKeys{command.key, command.other_key}) {
    if (const auto it = bindings.changed.find(command.id); it != bindings.changed.end())
      bindings.changed.erase(it);
  } else {
    bindings.changed[std::string(command.id)] = keys;
  }
}

void take_from_others(KeyChord chord, const Command& command, KeyBindings& bindings) {
  while (const Command* other = command_with_key(chord, command, bindings)) {
    CommandKeys keys = command_keys(*other, bindings);
    std::replace(keys.begin(), keys.end(), chord, KeyChord{});
    store_keys(*other, keys, bindings);
  }
}

}  // namespace

const Command* command_with_key(KeyChord chord, const Command& command, const KeyBindings& bindings) {
  if (!chord) return nullptr;
  for (const Command& other : commands()) {
    if (other.id == command.id || !scopes_meet(other.scope, command.scope)) continue;
    const CommandKeys keys = command_keys(other, bindings);
    if (std::find(keys.begin(), keys.end(), chord) != keys.end()) return &other;
  }
  return nullptr;
}

void bind_key(const Command& command, std::size_t index, KeyChord chord, KeyBindings& bindings) {
  take_from_others(chord, command, bindings);
  CommandKeys keys = command_keys(command, bindings);
  if (chord) std::replace(keys.begin(), keys.end(), chord, KeyChord{});
  keys[index] = chord;
  store_keys(command, keys, bindings);
}

void reset_keys(const Command& command, KeyBindings& bindings) {
  for (KeyChord chord : {command.key, command.other_key}) take_from_others(chord, command, bindings);
  store_keys(command, {command.key, command.other_key}, bindings);
}

}  // namespace talus
