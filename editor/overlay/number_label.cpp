#include "number_label.h"

#include <cstdio>

namespace talus {

namespace {

std::string formatted(const char* format, double value) {
  char text[384];  // the largest double has 309 digits before the point
  std::snprintf(text, sizeof text, format, value);
  return text;
}

}  // namespace

std::string no_decimals(double value) { return formatted("%.0f", value); }

std::string two_decimals(double value) {
  const std::string text = formatted("%.2f", value);
  return text == "-0.00" ? "0.00" : text;
}

std::string one_decimal(double value) {
  std::string text = formatted("%.1f", value);
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  if (text == "-0") return "0";
  if (text.starts_with("0.")) text.erase(0, 1);
  if (text.starts_with("-0.")) text.erase(1, 1);
  return text;
}

std::string time_label(double ti, bool overlaps) { return overlaps ? "inside" : "t " + two_decimals(ti); }

std::string all_digits(double value) { return formatted("%.17g", value); }

}  // namespace talus
