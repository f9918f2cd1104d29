// Six digits.
#include "hex_color.h"

#include <algorithm>
#include <charconv>

namespace talus {

std::optional<Rgb> color_of_hex(std::string_view text) {
  constexpr std::size_t kDigits = 6;
  if (text.starts_with('#')) text.remove_prefix(1);
  std::uint32_t number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number, 16);
  if (text.size() != kDigits || problem != std::errc() || end != text.data() + text.size()) return {};
  const auto part = [&](int shift) { return static_cast<std::uint8_t>(number >> shift & 0xff); };
  return Rgb{part(16), part(8), part(0)};
}

std::pair<std::string_view, double> split_tint(std::string_view text) {
  constexpr std::size_t kAlphaDigits = 2, kDigits = 8;
  const std::string_view digits = text.substr(text.starts_with('#') ? 1 : 0);
  unsigned alpha = 0;
  const auto [end, problem] =
      std::from_chars(digits.data(), digits.data() + std::min(digits.size(), kAlphaDigits), alpha, 16);
  const bool is_alpha = problem == std::errc() && end == digits.data() + kAlphaDigits;
  if (digits.size() != kDigits || !is_alpha) return {text, 1};
  return {digits.substr(kAlphaDigits), alpha / 255.0};
}

}  // namespace talus
