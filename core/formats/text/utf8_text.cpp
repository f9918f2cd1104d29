// One decoder serves all functions.
#include "utf8_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>

namespace talus {
namespace {

// Whether the character is invisible, but moves, colours, hides or turns round the text beside it.
bool is_hidden(std::uint32_t c) {
  const bool is_control = c < 0x20 || (c >= 0x7f && c <= 0x9f);
  const bool is_line_end = c == 0x2028 || c == 0x2029;
  const bool turns = c == 0x061c || c == 0x200e || c == 0x200f || (c >= 0x202a && c <= 0x202e) ||
                     (c >= 0x2066 && c <= 0x2069);
  return is_control || is_line_end || turns || c == 0xfeff || c == 0xfffe || c == 0xffff;
}

void append_hex(std::string& text, const char* prefix, std::uint32_t value, std::size_t digits) {
  std::array<char, 8> hex;
  const char* const end = std::to_chars(hex.data(), hex.data() + hex.size(), value, 16).ptr;
  const auto length = static_cast<std::size_t>(end - hex.data());
  text.append(prefix).append(digits > length ? digits - length : 0, '0').append(hex.data(), length);
}

void append_escaped(std::string& text, std::uint32_t c) {
  if (c == '\n')
    text += "\\n";
  else if (c == '\r')
    text += "\\r";
  else if (c == '\t')
    text += "\\t";
  else if (c < 0x80)
    append_hex(text, "\\x", c, 2);
  else
    append_hex(text, "\\u", c, 4);
}

bool is_white_space(std::uint32_t c) {
  return c == ' ' || c == 0xa0 || c == 0x1680 || (c >= 0x2000 && c <= 0x200a) || c == 0x202f || c == 0x205f ||
         c == 0x3000;
}

// The number of bytes of white space at the text's beginning that printable() keeps.
std::size_t white_space_before(std::string_view text) {
  std::size_t bytes = 0;
  while (bytes < text.size()) {
    const CodePoint next = first_code_point(text.substr(bytes));
    if (next.bytes == 0 || !is_white_space(next.value)) break;
    bytes += next.bytes;
  }
  return bytes;
}

// Whether the text behind "##" is a word, or nothing, followed by "[".
bool begins_a_command(std::string_view text) {
  const auto end = std::find_if_not(text.begin(), text.end(),
                                    [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); });
  return end != text.end() && *end == '[';
}

}  // namespace

CodePoint first_code_point(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  constexpr std::array<std::uint32_t, 5> kSmallest = {0, 0, 0x80, 0x800, 0x10000};
  if (lead < 0xc2 || lead > 0xf4 || text.size() < length) return {};
  std::uint32_t value = lead & (0x7fU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return {};
    value = value << 6 | (byte(i) & 0x3fU);
  }
  const bool is_surrogate = value >= 0xd800 && value <= 0xdfff;
  if (value < kSmallest[length] || value > 0x10ffff || is_surrogate) return {};
  return {value, length};
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const CodePoint first = first_code_point(text);
    if (first.bytes == 0) return false;
    text.remove_prefix(first.bytes);
  }
  return true;
}

std::string printable(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    const CodePoint first = first_code_point(text);
    if (first.bytes == 0)
      append_hex(shown, "\\x", static_cast<std::uint8_t>(text[0]), 2);
    else if (is_hidden(first.value))
      append_escaped(shown, first.value);
    else
      shown.append(text.substr(0, first.bytes));
    text.remove_prefix(first.bytes == 0 ? 1 : first.bytes);
  }
  return shown;
}

std::string printable_line(std::string_view line) {
  std::string shown = printable(line);
  const std::size_t first = white_space_before(shown);
  if (shown.compare(first, 2, "::") == 0) shown.replace(first, 1, "\\x3a");
  for (std::size_t at = shown.find("##"); at != shown.npos; at = shown.find("##", at + 1)) {
    if (begins_a_command(std::string_view(shown).substr(at + 2))) shown.replace(at, 1, "\\x23");
  }
  return shown;
}

std::string shortened(std::string_view text, std::size_t most) {
  if (text.size() <= most) return std::string(text);
  std::size_t end = most - 3;
  while (end > 0 && (static_cast<std::uint8_t>(text[end]) & 0xc0) == 0x80)
    --end;  // do not cut within a character
  return std::string(text.substr(0, end)) + "...";
}

}  // namespace talus
