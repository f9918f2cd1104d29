// Colours in native levels: six hexadecimal digits, such as "1a1c2c".
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include <talus/level/tileset.h>
#include "../text/hex.h"
#include "../text/json_text.h"

namespace talus {

inline constexpr const char* kColorText = "must be a colour such as \"1a1c2c\"";  // what is wrong with others

// Nothing if it is no colour.
inline std::optional<Rgb> color_of(const Json& json) {
  const std::string text = json.is_string() ? json.get<std::string>() : "";
  const bool good =
      text.size() == 6 && std::all_of(text.begin(), text.end(), [](char c) { return hex_value(c) >= 0; });
  if (!good) return std::nullopt;
  const auto channel = [&](std::size_t at) {
    return static_cast<std::uint8_t>(hex_value(text[at]) << 4 | hex_value(text[at + 1]));
  };
  return Rgb{channel(0), channel(2), channel(4)};
}

inline std::string text_of(Rgb color) {
  const std::array<char, 3> bytes = {static_cast<char>(color.r), static_cast<char>(color.g),
                                     static_cast<char>(color.b)};
  return to_hex({bytes.data(), bytes.size()});
}

}  // namespace talus
