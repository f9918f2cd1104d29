#include "lua_text.h"

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

}  // namespace talus
