// Hexadecimal digits, which cart texts and native levels use for bytes.
#pragma once

#include <string>
#include <string_view>

namespace talus {

inline constexpr std::string_view kHexDigits = "0123456789abcdef";

// Returns 0..15, or -1 if c is not a digit; upper case counts as lower case.
constexpr int hex_value(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

inline std::string to_hex(std::string_view bytes) {
  std::string text;
  text.reserve(2 * bytes.size());
  for (const char c : bytes) {
    text += kHexDigits[static_cast<unsigned char>(c) >> 4];
    text += kHexDigits[static_cast<unsigned char>(c) & 15];
  }
  return text;
}

}  // namespace talus
