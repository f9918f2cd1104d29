// The best way to lay the typed letters over the name, row by row.
#include "fuzzy_match.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <vector>

namespace talus {
namespace {

constexpr int kPlainLetter = 1, kInARow = 5, kWordStart = 8;
constexpr int kNoMatch = std::numeric_limits<int>::min() / 2;

char lower_case(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }
bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

}  // namespace

std::optional<int> fuzzy_score(std::string_view name, std::string_view typed) {
  const std::size_t n = name.size();
  // By place in the name: the best score with the last letter there, and with it there or before.
  std::vector<int> there(n, kNoMatch), until(n + 1, 0);
  for (const char letter : typed) {
    if (letter == ' ') continue;
    std::vector<int> next(n, kNoMatch), next_until(n + 1, kNoMatch);
    for (std::size_t i = 0; i < n; ++i) {
      if (lower_case(name[i]) == lower_case(letter)) {
        const bool starts = is_word(name[i]) && (i == 0 || !is_word(name[i - 1]));
        const int before = std::max(until[i], i > 0 ? there[i - 1] + kInARow : kNoMatch);
        next[i] = before + kPlainLetter + (starts ? kWordStart : 0);
      }
      next_until[i + 1] = std::max(next_until[i], next[i]);
    }
    there = std::move(next);
    until = std::move(next_until);
  }
  if (until[n] < 0) return std::nullopt;
  constexpr int kWeight = 1000;  // length decides between equals alone
  return until[n] * kWeight - static_cast<int>(n);
}

}  // namespace talus
