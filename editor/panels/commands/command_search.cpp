// Searches labels first, then other words.
#include "command_search.h"

#include <algorithm>
#include <cctype>
#include <tuple>

#include "panels/ui/fuzzy_match.h"

namespace talus {
namespace {

constexpr int kLabelWordScore = 1'000'000;                       // above the scores of single letters
constexpr int kWordScore = -1'000'000, kHelpScore = -2'000'000;  // below the scores of all labels

bool is_word_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

// Whether a word of the text begins with these letters.
bool has_word(std::string_view text, std::string_view beginning) {
  for (std::size_t i = 0; i + beginning.size() <= text.size(); ++i) {
    const bool starts = i == 0 || !is_word_letter(text[i - 1]);
    if (starts && text.substr(i).starts_with(beginning)) return true;
  }
  return false;
}

// Whether each typed word is the beginning of a word of the text.
bool has_words(std::string_view shown_text, std::string_view typed_text) {
  const std::string text = plain_letters(shown_text), plain_typed = plain_letters(typed_text);
  std::string_view typed = plain_typed;
  bool any = false;
  while (!typed.empty()) {
    const std::size_t end = std::min(typed.find(' '), typed.size());
    if (end > 0 && !has_word(text, typed.substr(0, end))) return false;
    any = any || end > 0;
    typed.remove_prefix(std::min(end + 1, typed.size()));
  }
  return any;
}

}  // namespace

std::optional<int> command_score(const Command& command, std::string_view typed) {
  if (const auto score = fuzzy_score(command.label, typed))
    return *score + (has_words(command.label, typed) ? kLabelWordScore : 0);
  const std::string named = std::string(command.label) + " " + std::string(command.words);
  if (has_words(named, typed)) return kWordScore;
  constexpr std::size_t kLeastLetters = 3;  // fewer letters occur in too many sentences
  if (typed.size() >= kLeastLetters && has_words(named + " " + std::string(command.help), typed))
    return kHelpScore;
  return std::nullopt;
}

MatchingCommands matching_commands(std::string_view typed, FunctionRef<bool(const Command&)> is_enabled) {
  struct Match {
    const Command* command;
    int score;
    bool enabled;
  };
  std::vector<Match> found;
  for (const Command& command : commands()) {
    if (const auto score = command_score(command, typed))
      found.push_back({&command, typed.empty() ? 0 : *score, is_enabled(command)});
  }
  std::stable_sort(found.begin(), found.end(), [](const Match& a, const Match& b) {
    return std::tuple(!a.enabled, -a.score) < std::tuple(!b.enabled, -b.score);
  });
  MatchingCommands matching;
  for (const Match& match : found) matching.commands.push_back(match.command);
  const auto disabled =
      std::find_if(found.begin(), found.end(), [](const Match& match) { return !match.enabled; });
  const bool is_meant = disabled != found.end() && disabled->score >= kLabelWordScore &&
                        (disabled == found.begin() || found.front().score < kLabelWordScore);
  if (is_meant) matching.meant = disabled->command;
  return matching;
}

}  // namespace talus
