// Splits the names of values, tags and entities into words, and finds ground and bodies in them.
#include "ldtk_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <span>
#include <string>
#include <vector>

#include "../text/name_words.h"

namespace talus {
namespace {

using Words = std::vector<std::string>;

bool has_word(const Words& words, std::span<const std::string_view> wanted) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::find(wanted.begin(), wanted.end(), word) != wanted.end();
  });
}

bool has_words(const Words& words, std::string_view first, std::string_view second) {
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (words[i] == first && words[i + 1] == second) return true;
  }
  return false;
}

// A number such as "2p5".
std::optional<double> number_of_word(std::string word) {
  std::replace(word.begin(), word.end(), 'p', '.');
  double number = 0;
  const char* const end = word.data() + word.size();
  const auto [stopped, problem] = std::from_chars(word.data(), end, number, std::chars_format::fixed);
  if (problem != std::errc() || stopped != end) return {};
  return number;
}

// "slope A to B", and "over N tile".
LdtkGround slope_of_words(const Words& words, TileSize tile) {
  LdtkGround ground;
  TileShape& shape = ground.shape;
  shape.kind = TileShape::Kind::slope;
  const auto at = static_cast<std::size_t>(std::find(words.begin(), words.end(), "slope") - words.begin());
  const auto word = [&](std::size_t i) { return at + i < words.size() ? words[at + i] : std::string(); };
  const auto from = number_of_word(word(1)), to = number_of_word(word(3));
  const auto tiles = word(4) == "over" ? number_of_word(word(5)) : std::nullopt;
  if (from && to && word(2) == "to") {
    shape.heights = {*from, *to};
    const double width = std::clamp(tiles.value_or(1), 1.0, 1.0 * kMaxShapeTiles);
    shape.tiles = static_cast<int>(width);
  } else if (has_words(words, "slope", "up") || has_words(words, "up", "slope")) {
    shape.heights = {0, 1.0 * tile.height};
  } else if (has_words(words, "slope", "down") || has_words(words, "down", "slope")) {
    shape.heights = {1.0 * tile.height, 0};
  } else {
    shape.kind = TileShape::Kind::solid;
    ground.is_unclear = true;
  }
  return ground;
}

}  // namespace

std::optional<LdtkGround> ldtk_ground_of_name(std::string_view name, TileSize tile) {
  constexpr std::array<std::string_view, 9> kBehind = {
      "background", "bg", "backdrop", "decoration", "decor", "deco", "part", "shadow", "sky"};
  constexpr std::array<std::string_view, 3> kPlatform = {"oneway", "platform", "semisolid"};
  constexpr std::array<std::string_view, 10> kSolid = {"wall",      "solid",    "ground",  "block", "full",
                                                       "collision", "collider", "collide", "rock",  "brick"};
  constexpr std::array<std::string_view, 22> kAir = {
      "ladder", "rope",    "vine",   "climb", "climbable", "water", "lava", "acid",
      "liquid", "air",     "empty",  "none",  "void",      "spawn", "coin", "item",
      "enemy",  "trigger", "camera", "zone",  "ball",      "player"};
  const Words words = name_words(name);
  const bool is_one_way = has_word(words, kPlatform) || has_words(words, "one", "way") ||
                          has_words(words, "jump", "through") || has_words(words, "pass", "through");
  LdtkGround ground;
  if (has_word(words, kBehind)) {
    ground.is_plain = has_word(words, std::array<std::string_view, 1>{"part"});
    return ground;
  }
  constexpr std::array<std::string_view, 1> kSlope = {"slope"};
  if (has_word(words, kSlope)) {
    ground = slope_of_words(words, tile);
    constexpr std::array<std::string_view, 1> kCeiling = {"ceiling"};
    if (has_word(words, kCeiling)) ground.shape.side = TileShape::Side::ceiling;
  } else if (is_one_way || has_word(words, kSolid)) {
    ground.shape.kind = TileShape::Kind::solid;
  } else if (has_word(words, kAir)) {
    ground.is_plain = false;
    return ground;
  } else {
    return {};
  }
  ground.shape.one_way = is_one_way;
  if (problem_of(ground.shape, tile)) ground = {{.kind = TileShape::Kind::solid}, true, true};
  return ground;
}

std::optional<BodyKind> ldtk_body_of_name(std::string_view type) {
  constexpr std::array<std::string_view, 3> kPlayers = {"player", "hero", "protagonist"};
  constexpr std::array<std::string_view, 4> kAfterPlayer = {"start", "spawn", "point", "position"};
  std::string without_number(type.substr(0, kMaxNameBytesRead));
  std::erase_if(without_number, [](unsigned char c) { return std::isdigit(c) != 0; });
  const Words words = name_words(without_number);
  if (words.empty()) return {};
  for (const BodyTraits& kind : body_kinds()) {
    if (words == name_words(kind.ldtk_identifier)) return find_body_kind(kind.word);
  }
  const bool is_player = has_word({words.front()}, kPlayers) &&
                         std::all_of(words.begin() + 1, words.end(),
                                     [&](const std::string& word) { return has_word({word}, kAfterPlayer); });
  if (is_player) return BodyKind::player;
  return {};
}

}  // namespace talus
