// Text from files: whether it is UTF-8, and how to show it safely.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace talus {

struct CodePoint {
  std::uint32_t value = 0;  // 0 to 0x10ffff, but not a surrogate
  std::size_t bytes = 0;    // 1 to 4; 0: the text does not begin with a valid code point in its shortest form
};

// text: not empty. After an invalid byte, callers skip one byte.
CodePoint first_code_point(std::string_view text);

bool is_utf8(std::string_view text);

// Returns the text for one line of a terminal, a log or a window. Control characters, line ends, characters
// that change the direction of writing, and bytes that are not UTF-8 become "
// ", "\x1b", "\u202e". All else stays, backslashes too, so doing it twice changes nothing more.
std::string printable(std::string_view text);

// The same for a whole line that a continuous integration may read. The line neither begins with "::", after
// white space of any kind, nor contains "##[", "##vso[", "##teamcity[" or the like: these are commands in
// logs.
std::string printable_line(std::string_view line);

// Returns the text up to `most` bytes, and "..." instead of the rest. most: 3 or more.
std::string shortened(std::string_view text, std::size_t most);

}  // namespace talus
