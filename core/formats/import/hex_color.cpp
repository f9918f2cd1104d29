// Three, six or eight digits.
#include "hex_color.h"

#include <charconv>
#include <cstdint>
#include <string>

namespace talus {
namespace {

constexpr std::size_t kShortDigits = 3, kDigits = 6, kDigitsWithOpacity = 8;

// Red, green and blue in the last 24 bits, the opacity before them.
std::optional<std::uint32_t> number_of_hex(std::string_view text) {
  if (text.starts_with('#')) text.remove_prefix(1);
  std::string digits;
  if (text.size() == kShortDigits)
    for (const char digit : text) digits.append(2, digit);
  else if (text.size() == kDigits || text.size() == kDigitsWithOpacity)
    digits = text;
  if (digits.size() == kDigits) digits.insert(0, "ff");
  std::uint32_t number = 0;
  const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), number, 16);
  if (digits.empty() || problem != std::errc() || end != digits.data() + digits.size()) return {};
  return number;
}

}  // namespace

std::optional<Rgb> color_of_hex(std::string_view text) {
  const auto number = number_of_hex(text);
  if (!number) return {};
  const auto part = [&](int shift) { return static_cast<std::uint8_t>(*number >> shift & 0xff); };
  return Rgb{part(16), part(8), part(0)};
}

double opacity_of_hex(std::string_view text) {
  constexpr int kShift = 24;
  constexpr double kMost = 255;
  return (number_of_hex(text).value_or(~std::uint32_t{0}) >> kShift) / kMost;
}

}  // namespace talus
