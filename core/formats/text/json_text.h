// JSON text in and out: bounded reading, and printing that people can read and diff.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include <talus/formats/format.h>

namespace talus {

using Json = nlohmann::json;

inline constexpr int kMaxJsonDepth = 64;             // levels have 5; printing recurses once a level
inline constexpr std::size_t kMaxJsonKeys = 65'536;  // of one object; those of a level have up to 256
inline constexpr int kMaxJsonValues = 5'000'000;  // a text project of line breaks alone has 4.2 million lines

// The one way from text to JSON: each reader of JSON uses it. Text that is no JSON, nests deeper or has more
// values or keys than the limits above, has a key twice in one object, a number that no double holds, or
// anything but blanks after its end is an error, placed by line, and by the column or the key in it where
// there is one. progress: told how much of the text is parsed; where it says so, that is an error.
// first_line: the number that the text's first line has in its file.
FormatResult<Json> parse_json(std::string_view text, const Progress& progress = {},
                              std::int64_t first_line = 1);

// Whether the value is an integer from min to max. A comparison with nlohmann's own operators would take
// integers from 2^63 for negative ones.
bool is_whole(const Json& value, std::int64_t min, std::int64_t max);

// One line a member, short rows of numbers and small objects on one; keys in `order`, then the others shorter
// first. Strings must be UTF-8 (see utf8_text.h).
std::string print_json(const Json& value, std::span<const std::string_view> order);

// Why read_file or parse_json would refuse a text that was printed: "takes 70 MiB as a file, and Talus reads
// up to 64". Nothing: they would not.
std::optional<std::string> problem_of_size(std::string_view printed);

// A number that is whole prints without ".0".
Json json_number(double value);

}  // namespace talus
