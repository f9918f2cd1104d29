// Finding names by a few of their letters.
#pragma once

#include <optional>
#include <string_view>

namespace talus {

// How well a name fits what was typed: its letters must come in the name in this order, whatever their case;
// blanks in between do not count. The larger the better: letters in a row and at the beginnings of words
// count most, and short names more than long ones. Nothing when it does not fit.
std::optional<int> fuzzy_score(std::string_view name, std::string_view typed);

}  // namespace talus
