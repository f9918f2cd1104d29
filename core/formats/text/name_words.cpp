#include "name_words.h"

#include <cctype>

namespace talus {

std::vector<std::string> name_words(std::string_view name) {
  std::vector<std::string> words;
  bool goes_on = false, was_small = false;
  for (const char c : name.substr(0, kMaxNameBytesRead)) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_capital = std::isupper(byte) != 0;
    if (std::isalnum(byte) == 0) {
      goes_on = was_small = false;
      continue;
    }
    if (!goes_on || (is_capital && was_small)) words.emplace_back();
    words.back() += static_cast<char>(std::tolower(byte));
    goes_on = true;
    was_small = !is_capital;
  }
  for (std::string& word : words) {
    const bool is_plural = word.size() > 3 && word.back() == 's' && word[word.size() - 2] != 's';
    if (is_plural) word.pop_back();
  }
  return words;
}

}  // namespace talus
