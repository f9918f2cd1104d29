// TextTable: rows of texts, aligned.
#pragma once

#include <string>
#include <vector>

namespace talus::beside {

class TextTable {
 public:
  // Adds a row; the first one has the titles. All have as many cells.
  void add(std::vector<std::string> cells, const std::vector<std::string>& more);
  // With lines between the columns if it is Markdown.
  std::string text(bool is_markdown) const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

std::string short_number(double value);  // two digits
std::string whole_number(double value);

}  // namespace talus::beside
