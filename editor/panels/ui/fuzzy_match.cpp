// Finds the best way to place the typed letters in the name, row by row.
#include "fuzzy_match.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <vector>

namespace talus {
namespace {

constexpr int kPlainLetter = 1, kInARow = 5, kWordStart = 8;
constexpr int kNoMatch = std::numeric_limits<int>::min() / 2;

// By the second byte of U+00C0 to U+00FF in UTF-8, from 0x80; of two letters, such as of U+00C6, the first.
constexpr char kFirstByte = '\xC3';
constexpr std::string_view kPlain = "aaaaaaaceeeeiiiidnooooo*ouuuuytsaaaaaaaceeeeiiiidnooooo/ouuuuyty";
static_assert(kPlain.size() == 64);

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

}  // namespace

std::string plain_letters(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t place =
        i + 1 < text.size() ? static_cast<std::size_t>(static_cast<unsigned char>(text[i + 1])) - 0x80 : 64;
    if (text[i] == kFirstByte && place < kPlain.size()) {
      plain += kPlain[place];
      ++i;
    } else {
      plain += static_cast<char>(std::tolower(static_cast<unsigned char>(text[i])));
    }
  }
  return plain;
}

std::optional<int> fuzzy_score(std::string_view shown_name, std::string_view typed) {
  const std::string name = plain_letters(shown_name);
  const std::size_t n = name.size();
  // By place in the name: the best score with the last letter there, and with it there or before.
  std::vector<int> there(n, kNoMatch), until(n + 1, 0);
  for (const char letter : plain_letters(typed)) {
    if (letter == ' ') continue;
    std::vector<int> next(n, kNoMatch), next_until(n + 1, kNoMatch);
    for (std::size_t i = 0; i < n; ++i) {
      if (name[i] == letter) {
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
  constexpr int kWeight = 1000;  // the length only decides between equal scores
  return until[n] * kWeight - static_cast<int>(n);
}

}  // namespace talus
