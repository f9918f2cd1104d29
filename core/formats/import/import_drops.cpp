// Phrases with their counts.
#include "import_drops.h"

#include "../text/utf8_text.h"

namespace talus {

std::string quoted_name(std::string_view name) {
  constexpr std::size_t kMax = 80;  // bytes
  return "\"" + shortened(name, kMax) + "\"";
}

void ImportDrops::add(std::string_view phrase) {
  constexpr std::size_t kMaxPhrases = 1000;
  constexpr std::size_t kMaxShown = 200;  // bytes
  const std::string shown = shortened(phrase, kMaxShown);
  if (const auto known = counts_.find(shown); known != counts_.end())
    ++known->second;
  else if (counts_.size() < kMaxPhrases)
    counts_.emplace(shown, 1);
  else
    ++more_;
}

std::vector<std::string> ImportDrops::phrases() const {
  std::vector<std::string> phrases;
  for (const auto& [phrase, count] : counts_) {
    const std::string shown = printable(phrase);
    phrases.push_back(count == 1 ? shown : shown + " (" + std::to_string(count) + " times)");
  }
  if (more_ > 0) phrases.push_back("and " + std::to_string(more_) + " more");
  return phrases;
}

}  // namespace talus
