#include "lua_text.h"

#include <algorithm>
#include <array>
#include <string>

namespace talus {

std::string lua_string(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool opens_section = c == '<' && quoted.ends_with("-- ");
    if (byte >= 32 && byte < 127 && c != '"' && c != '\\' && !opens_section) {
      quoted += c;
    } else {
      const std::string digits = std::to_string(byte);
      quoted.append("\\").append(3 - digits.size(), '0').append(digits);
    }
  }
  return quoted + '"';
}

bool is_lua_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || (c >= '0' && c <= '9');
}

bool is_lua_name(std::string_view text) {
  constexpr std::array<std::string_view, 22> kWords = {
      "and", "break", "do",  "else", "elseif", "end",    "false",  "for",  "function", "goto",  "if",
      "in",  "local", "nil", "not",  "or",     "repeat", "return", "then", "true",     "until", "while"};
  return !text.empty() && !(text.front() >= '0' && text.front() <= '9') &&
         std::all_of(text.begin(), text.end(), is_lua_word) &&
         std::find(kWords.begin(), kWords.end(), text) == kWords.end();
}

}  // namespace talus
