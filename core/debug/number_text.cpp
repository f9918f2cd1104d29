#include "number_text.h"

#include <charconv>
#include <cmath>

namespace talus {
namespace {

template <class... Format>
std::string text_of(double number, Format... format) {
  char digits[400];  // the largest double has 309 digits before the point
  return {digits, std::to_chars(digits, digits + sizeof digits, number, format...).ptr};
}

}  // namespace

std::string exact_text(double number) { return text_of(number); }

std::string short_text(double number) {
  if (number == 0) return "0";
  if (!std::isfinite(number)) return text_of(number);
  if (std::abs(number) < 0.005) return text_of(number, std::chars_format::scientific, 0);
  std::string text = text_of(number, std::chars_format::fixed, 2);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string short_text(Vec2 v) {
  const auto part = [](double p) { return short_text(std::abs(p) < kOnlyRounding ? 0 : p); };
  return "(" + part(v.x) + ", " + part(v.y) + ")";
}

std::string motion_text(Vec2 v) {
  const auto part = [](double p) { return std::abs(p) < kLeastShown ? 0 : p; };
  const Vec2 told{part(v.x), part(v.y)};
  if (told != Vec2{} || short_text(v) == "(0, 0)") return short_text(told);
  return "less than " + exact_text(kLeastShown);
}

}  // namespace talus
