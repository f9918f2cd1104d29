// JSON text: reads with limits, and prints text that people can read and diff.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include <talus/formats/format.h>

namespace talus {

using Json = nlohmann::json;

inline constexpr int kMaxJsonDepth = 64;  // levels of Talus have 5; printing recurses once for each
inline constexpr std::size_t kMaxJsonKeys = 66'048;  // of one object
// Of them, those that Talus does not know. It adds its own when it writes a level, up to 256 to one object.
inline constexpr std::size_t kMaxUnknownKeys = 65'536;
// A text project that is all line breaks has 4.2 million lines.
inline constexpr int kMaxJsonValues = 5'000'000;

// Parses JSON; all readers of JSON use this function. These are errors: text that is not JSON; deeper
// nesting, or more values or keys, than the limits above; a key that is in one object twice; a number too
// large for a double; anything but blanks after the end. The error's place is the line, with the column or
// the key if there is one. progress: receives how much of the text is parsed, and may stop the work, which is
// an error. first_line: the number of the text's first line in its file. most_deep: the allowed nesting, for
// a file whose parts may themselves have kMaxJsonDepth levels.
FormatResult<Json> parse_json(std::string_view text, const Progress& progress = {},
                              std::int64_t first_line = 1, int most_deep = kMaxJsonDepth);

// The value of a text that is a part of what parse_json() has read. A text that is not JSON gives a discarded
// value.
Json json_part(std::string_view text);

// Whether the text begins with an object that has one of these keys itself, not in a value. What follows the
// key may be damaged or missing.
bool has_key(std::string_view text, std::span<const std::string_view> keys);

// How many objects and lists nest in the value, with itself: 0 for a number, 2 for [[]].
int depth_of(const Json& value);

// Whether the value is an integer from min to max. nlohmann's own operators would take integers from 2^63 on
// for negative ones.
bool is_whole(const Json& value, std::int64_t min, std::int64_t max);

// Prints one member on each line; short rows of numbers and small objects stay on one line. Keys come in
// `order`, the others follow by length. Strings must be UTF-8 (see utf8_text.h).
std::string print_json(const Json& value, std::span<const std::string_view> order);

// Why read_file or parse_json would refuse a printed text: "takes 70 MiB as a file, and Talus reads up to
// 64". Returns nothing if they would accept it.
std::optional<std::string> problem_of_size(std::string_view printed);

// A number that prints without ".0" if it is whole.
Json json_number(double value);

}  // namespace talus
