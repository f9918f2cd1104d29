// JSON text in and out: bounded reading, and printing that people can read and diff.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "format.h"

namespace talus {

using Json = nlohmann::json;

inline constexpr int kMaxJsonDepth = 64;          // levels have 5; printing recurses once a level
inline constexpr int kMaxJsonValues = 5'000'000;  // a text project of line breaks alone has 4.2 million lines

// Errors are placed by line, and by the column or the key in it where there is one. progress: told how much
// of the text is parsed; where it says so, that is an error.
FormatResult<Json> parse_json(std::string_view text, const Progress& progress = {});

// One line a member, short rows of numbers and small objects on one; keys in `order`, then the others shorter
// first. Strings must be UTF-8 (see is_utf8).
std::string print_json(const Json& value, std::span<const std::string_view> order);

bool is_utf8(std::string_view text);

// A number that is whole prints without ".0".
Json json_number(double value);

}  // namespace talus
