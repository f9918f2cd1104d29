// Colours in Tiled's notation, and phrases for what was dropped.
#include "tiled_map.h"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "../text/utf8_text.h"

namespace talus {

std::string tiled_path(const std::string& folder, std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  return (std::filesystem::path(folder) / name).lexically_normal().string();
}

std::string tiled_color(Rgb color) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t part : {color.r, color.g, color.b})
    (text += kDigits[part / 16]) += kDigits[part % 16];
  return text;
}

std::optional<Rgb> color_of_tiled(std::string_view text) {
  constexpr std::size_t kDigits = 6;
  if (text.starts_with('#')) text.remove_prefix(1);
  std::uint32_t number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number, 16);
  if (text.size() != kDigits || problem != std::errc() || end != text.data() + text.size()) return {};
  const auto part = [&](int shift) { return static_cast<std::uint8_t>(number >> shift & 0xff); };
  return Rgb{part(16), part(8), part(0)};
}

std::string tiled_quoted(std::string_view name) {
  constexpr std::size_t kMost = 80;  // bytes
  return "\"" + shortened(name, kMost) + "\"";
}

std::string tiled_too_many(std::string_view thing, std::size_t most) {
  return "is one " + std::string(thing) + " too many: a map may have at most " + std::to_string(most);
}

void TiledDrops::add(std::string_view phrase) {
  constexpr std::size_t kMostPhrases = 1000;
  constexpr std::size_t kMostShown = 200;  // bytes
  const std::string shown = shortened(phrase, kMostShown);
  if (const auto known = counts_.find(shown); known != counts_.end())
    ++known->second;
  else if (counts_.size() < kMostPhrases)
    counts_.emplace(shown, 1);
  else
    ++more_;
}

std::vector<std::string> TiledDrops::phrases() const {
  std::vector<std::string> phrases;
  for (const auto& [phrase, count] : counts_) {
    const std::string shown = printable(phrase);
    phrases.push_back(count == 1 ? shown : shown + " (" + std::to_string(count) + " times)");
  }
  if (more_ > 0) phrases.push_back("and " + std::to_string(more_) + " more");
  return phrases;
}

}  // namespace talus
