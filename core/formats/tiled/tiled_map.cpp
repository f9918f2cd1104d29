// Colours in Tiled's notation, and phrases for what was dropped.
#include "tiled_map.h"

#include "../text/utf8_text.h"

namespace talus {

std::string tiled_color(Rgb color) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t part : {color.r, color.g, color.b})
    (text += kDigits[part / 16]) += kDigits[part % 16];
  return text;
}

std::vector<std::string> TiledDrops::phrases() const {
  std::vector<std::string> phrases;
  constexpr std::size_t kMostPhrases = 1000;
  constexpr std::size_t kMostShown = 200;  // bytes; names in files may be of any length
  for (const auto& [phrase, count] : counts_) {
    if (phrases.size() == kMostPhrases) {
      phrases.push_back("and " + std::to_string(counts_.size() - kMostPhrases) + " more");
      break;
    }
    const std::string shown = printable(shortened(phrase, kMostShown));
    phrases.push_back(count == 1 ? shown : shown + " (" + std::to_string(count) + " times)");
  }
  return phrases;
}

}  // namespace talus
