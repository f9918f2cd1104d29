// Finding commands by what is typed.
#pragma once

#include <optional>

#include "commands.h"

namespace talus {

// How well a command fits what was typed: each typed word at the beginning of one of the label's, or its
// letters in the label, in their order, or each typed word at the beginning of one of the command's other
// words, or, as the worst, of its help. The larger the better. Nothing when it does not fit.
std::optional<int> command_score(const Command& command, std::string_view typed);

// In which of these ways a command fits, by its score; the larger the better.
int rank_of_score(int score);

}  // namespace talus
