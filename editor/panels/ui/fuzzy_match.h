// Finds names by a few of their letters.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace talus {

// The text in lower case; letters of Western Europe (U+00C0 to U+00FF) lose their marks: "love" for "LÖVE".
std::string plain_letters(std::string_view text);

// How well a name fits the typed text: its letters must come in the name in this order, compared as
// plain_letters(); blanks in between do not count. Larger is better: letters in a row and at the beginnings
// of words count most, and short names more than long ones. Returns nothing if it does not fit.
std::optional<int> fuzzy_score(std::string_view name, std::string_view typed);

}  // namespace talus
