// Finds commands by typed text.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <talus/collision/function_ref.h>
#include "commands.h"

namespace talus {

// Returns how well a command matches the typed text; larger is better. These match, the best first: each
// typed word begins a word of the label; the letters are in the label, in their order; each typed word begins
// one of the command's other words; or a word of its help. Returns nothing if none of these match.
std::optional<int> command_score(const Command& command, std::string_view typed);

struct MatchingCommands {
  // Every matching command: enabled ones first, and among equals the best match first. Without typed text all
  // commands, in the order of the table.
  std::vector<const Command*> commands;
  // The best match, if it is disabled, its label has the typed words, and the label of no enabled command has
  // them. Otherwise null.
  const Command* meant = nullptr;
};
MatchingCommands matching_commands(std::string_view typed, FunctionRef<bool(const Command&)> is_enabled);

}  // namespace talus
