#include "lua_text.h"

namespace talus {

std::string lua_string(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 32 && byte < 127 && c != '"' && c != '\\') {
      quoted += c;
    } else {
      const std::string digits = std::to_string(byte);
      quoted.append("\\").append(3 - digits.size(), '0').append(digits);
    }
  }
  return quoted + '"';
}

}  // namespace talus
