// Three, six or eight digits.
#include "hex_color.h"

#include <charconv>
#include <cstdint>
#include <string>

#include "../text/hex.h"

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

std::optional<Rgba> rgba_of_hex(std::string_view text) {
  const auto number = number_of_hex(text);
  if (!number) return {};
  const auto part = [&](int shift) { return static_cast<std::uint8_t>(*number >> shift & 0xff); };
  return Rgba{part(16), part(8), part(0), part(24)};
}

std::optional<Rgb> color_of_hex(std::string_view text) {
  const auto color = rgba_of_hex(text);
  if (!color) return {};
  return Rgb{color->r, color->g, color->b};
}

double opacity_of_hex(std::string_view text) {
  constexpr int kShift = 24;
  constexpr double kMax = 255;
  return (number_of_hex(text).value_or(~std::uint32_t{0}) >> kShift) / kMax;
}

std::string hex_of(Rgba color) {
  std::string text = "#";
  const auto put = [&](std::uint8_t part) { (text += kHexDigits[part / 16]) += kHexDigits[part % 16]; };
  if (color.a != 255) put(color.a);
  for (const std::uint8_t part : {color.r, color.g, color.b}) put(part);
  return text;
}

}  // namespace talus
