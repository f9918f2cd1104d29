#include "number_label.h"

#include <charconv>
#include <cmath>

namespace talus {

namespace {

// Formats like printf's %f and %g, but much faster: crowds have thousands of labels.
std::string formatted(std::chars_format format, int precision, double value) {
  char text[384];  // the largest double has 309 digits before the point
  return {text, std::to_chars(text, text + sizeof text, value, format, precision).ptr};
}

}  // namespace

std::string no_decimals(double value) { return formatted(std::chars_format::fixed, 0, value); }

std::string two_decimals(double value) {
  const std::string text = formatted(std::chars_format::fixed, 2, value);
  return text == "-0.00" ? "0.00" : text;
}

std::string small_too(double value) {
  const bool is_small = value != 0 && std::abs(value) < 0.005;
  return is_small ? formatted(std::chars_format::scientific, 1, value) : two_decimals(value);
}

std::string one_decimal(double value) {
  std::string text = formatted(std::chars_format::fixed, 1, value);
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  if (text == "-0") return "0";
  if (text.starts_with("0.")) text.erase(0, 1);
  if (text.starts_with("-0.")) text.erase(1, 1);
  return text;
}

std::string time_label(double ti, bool overlaps) { return overlaps ? "inside" : "t " + two_decimals(ti); }

std::string all_digits(double value) { return formatted(std::chars_format::general, 17, value); }

}  // namespace talus
