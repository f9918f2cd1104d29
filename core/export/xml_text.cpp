// Goes through UTF-8, character by character.
#include "xml_text.h"

#include <cstdint>

namespace talus {
namespace {

struct Utf8Character {
  char32_t code;
  std::size_t bytes;  // 0: what is there is none
};

Utf8Character character_at(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t first = byte(0);
  const std::size_t bytes = first < 0x80       ? 1
                            : first >> 5 == 6  ? 2
                            : first >> 4 == 14 ? 3
                            : first >> 3 == 30 ? 4
                                               : 0;
  if (bytes == 0 || bytes > text.size()) return {0, 0};
  char32_t code = bytes == 1 ? first : first & (0x7fU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if (byte(i) >> 6 != 2) return {0, 0};
    code = code << 6 | (byte(i) & 0x3fU);
  }
  constexpr char32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  return code < kLeast[bytes] ? Utf8Character{0, 0} : Utf8Character{code, bytes};
}

bool is_in_xml(char32_t code) {
  const bool is_surrogate = code >= 0xd800 && code <= 0xdfff;
  return !is_surrogate && code != 0xfffe && code != 0xffff && code <= 0x10ffff;
}

}  // namespace

std::string xml_text(std::string_view text) {
  std::string clean;
  clean.reserve(text.size());
  while (!text.empty()) {
    const auto [code, bytes] = character_at(text);
    if (bytes == 0 || !is_in_xml(code))
      clean += "\xef\xbf\xbd";
    else if (code < 32 && code != '\t' && code != '\n' && code != '\r')
      clean += ' ';
    else
      clean += text.substr(0, bytes);
    text.remove_prefix(bytes == 0 ? 1 : bytes);
  }
  return clean;
}

}  // namespace talus
