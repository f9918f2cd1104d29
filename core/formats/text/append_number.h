// Numbers as text: the shortest decimal that reads back as the same double.
#pragma once

#include <charconv>
#include <string>

namespace talus {

// Appends a finite number ("5", "0.1", "-0", "1e+30"), which is also valid JSON.
template <class Number>
void append_number(std::string& text, Number number) {
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
}

}  // namespace talus
