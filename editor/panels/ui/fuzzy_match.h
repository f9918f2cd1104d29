// Finding names by a few of their letters.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace talus {

// The text in small letters, those of Western Europe (U+00C0 to U+00FF) without their marks: "love" of
// "LÖVE".
std::string plain_letters(std::string_view text);

// How well a name fits what was typed: its letters must come in the name in this order, as plain_letters();
// blanks in between do not count. The larger the better: letters in a row and at the beginnings of words
// count most, and short names more than long ones. Nothing when it does not fit.
std::optional<int> fuzzy_score(std::string_view name, std::string_view typed);

}  // namespace talus
