// Finding commands by what is typed.
#pragma once

#include <optional>

#include <optional>
#include <string_view>
#include <vector>

#include <talus/collision/function_ref.h>
#include "commands.h"

namespace talus {

// How well a command fits what was typed: each typed word at the beginning of one of the label's, or its
// letters in the label, in their order, or each typed word at the beginning of one of the command's other
// words, or, as the worst, of its help. The larger the better. Nothing when it does not fit.
std::optional<int> command_score(const Command& command, std::string_view typed);

// Every command that fits: those that are enabled first, and of both the best first. Without letters all of
// them, in the order of the table.
std::vector<const Command*> matching_commands(std::string_view typed,
                                              FunctionRef<bool(const Command&)> is_enabled);

}  // namespace talus
