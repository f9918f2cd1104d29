// Text of unknown origin: whether it is UTF-8, and how it is shown.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace talus {

struct CodePoint {
  std::uint32_t value = 0;  // 0 to 0x10ffff, no surrogate
  std::size_t bytes = 0;    // 1 to 4; 0: the text does not begin with a whole, shortest, valid one
};

// text: not empty. Of what is no UTF-8 callers pass over one byte.
CodePoint first_code_point(std::string_view text);

bool is_utf8(std::string_view text);

// The text for one line of a terminal, a log or a window: control characters, line ends, what turns the
// direction of writing and bytes that are no UTF-8 become "\n", "\x1b", "\u202e"; all else stays, backslashes
// too, so that doing it twice changes nothing more.
std::string printable(std::string_view text);

// The same for a whole line that somebody's continuous integration may read: it cannot begin with "::"
// or hold "##[" or "##vso[", with which logs give commands there.
std::string printable_line(std::string_view line);

// The text up to `most` bytes, and "..." in the place of what more there is. most: 3 or more.
std::string shortened(std::string_view text, std::size_t most);

}  // namespace talus
