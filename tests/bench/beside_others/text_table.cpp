#include "text_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace talus::beside {

void TextTable::add(std::vector<std::string> cells, const std::vector<std::string>& more) {
  cells.insert(cells.end(), more.begin(), more.end());
  rows_.push_back(std::move(cells));
}

std::string TextTable::text(bool is_markdown) const {
  std::vector<std::size_t> widths(rows_[0].size(), 3);
  for (const auto& row : rows_)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  const std::string edge = is_markdown ? "|" : "";
  std::string text;
  const auto add_row = [&](const std::vector<std::string>& row) {
    text += edge;
    for (std::size_t i = 0; i < row.size(); ++i)
      text += " " + row[i] + std::string(widths[i] - row[i].size(), ' ') + " " + edge;
    text += "\n";
  };
  add_row(rows_[0]);
  std::vector<std::string> rule;
  rule.reserve(widths.size());
  for (const std::size_t width : widths) rule.emplace_back(width, '-');
  add_row(rule);
  for (std::size_t i = 1; i < rows_.size(); ++i) add_row(rows_[i]);
  return text;
}

std::string short_number(double value) {
  char text[32];
  const double size = std::abs(value);
  if (size >= 9.95) return whole_number(value);
  std::snprintf(text, sizeof text, size >= 9.5e-4 || size == 0 ? "%.2g" : "%.0e", value);
  return text;
}

std::string whole_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f", value);
  return text;
}

}  // namespace talus::beside
