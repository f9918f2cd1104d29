#include "tile_words.h"

#include <algorithm>
#include <sstream>

namespace talus {
namespace {

std::string in_lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

const char* word_of(TileShape::Kind kind) {
  switch (kind) {
    case TileShape::Kind::none:
      return "none";
    case TileShape::Kind::solid:
      return "solid";
    case TileShape::Kind::slope:
      return "slope";
    case TileShape::Kind::profile:
      return "profile";
    case TileShape::Kind::polygon:
      return "polygon";
    case TileShape::Kind::group:
      return "group";
  }
  return "";
}

void add_shape_words(const TileShape& shape, std::vector<std::string>& words) {
  words.emplace_back(word_of(shape.kind));
  if (shape.one_way) words.emplace_back("one-way");
  if (shape.side == TileShape::Side::ceiling) words.emplace_back("ceiling");
  for (const TileShape& part : shape.parts) add_shape_words(part, words);
}

bool is_number(const std::string& word) { return word.find_first_not_of("0123456789") == std::string::npos; }

bool has_word(const std::vector<std::string>& words, const std::string& wanted) {
  constexpr std::string_view kFlag = "flag:";
  const bool of_flags = wanted.starts_with(kFlag);
  if (is_number(wanted) || (of_flags && is_number(wanted.substr(kFlag.size()))))
    return std::find(words.begin(), words.end(), wanted) != words.end();
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return of_flags ? word.starts_with(wanted) : !word.starts_with(kFlag) && word.find(wanted) != word.npos;
  });
}

}  // namespace

std::vector<std::string> words_of_tile(const Level& level, TileNumber tile) {
  std::vector<std::string> words = {std::to_string(tile)};
  const int set = tileset_with(level.tilesets, level.sheet(SheetId::tiles).layout(), tile);
  if (set >= 0) words.push_back(in_lower_case(level.tilesets[static_cast<std::size_t>(set)].name));
  const std::uint8_t flags = level.tile_flags(tile);
  const auto add_flag = [&](const std::string& name) {
    words.push_back(name);
    words.push_back("flag:" + name);
  };
  for (int flag = 0; flag < kFlagCount; ++flag) {
    if (!has_flag(flags, flag)) continue;
    words.push_back("flag:" + std::to_string(flag));
    const std::string& name = level.flag_names[static_cast<std::size_t>(flag)];
    if (!name.empty()) add_flag(in_lower_case(name));
  }
  for (const FlagRoleInfo& info : flag_role_infos())
    if (has_flag(flags, level.roles.*info.flag)) add_flag(std::string(info.label));
  add_shape_words(shape_of_tile(level, tile), words);
  return words;
}

std::vector<bool> find_tiles(const Level& level, std::string_view text) {
  std::vector<std::string> wanted;
  std::istringstream typed(in_lower_case(std::string(text)));
  for (std::string word; typed >> word;) {
    if (word.size() > 1 && word[0] == '#') word.erase(0, 1);
    wanted.push_back(std::move(word));
  }
  std::vector<bool> found;
  if (wanted.empty()) return found;
  for (int tile = 0; tile < level.tile_count(); ++tile) {
    const auto words = words_of_tile(level, static_cast<TileNumber>(tile));
    found.push_back(std::all_of(wanted.begin(), wanted.end(),
                                [&](const std::string& word) { return has_word(words, word); }));
  }
  return found;
}

std::vector<std::size_t> count_tiles(const Level& level) {
  std::vector<std::size_t> counts(static_cast<std::size_t>(level.tile_count()));
  for (int layer = 0; layer < level.layers.count(); ++layer)
    for (const TileNumber tile : level.cells_of(layer)) ++counts[tile];
  return counts;
}

}  // namespace talus
