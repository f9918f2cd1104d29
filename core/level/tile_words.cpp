#include "tile_words.h"

#include <algorithm>
#include <string_view>
#include <utility>

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
  const auto add = [&](const char* word) {
    if (std::find(words.begin(), words.end(), word) == words.end()) words.emplace_back(word);
  };
  add(word_of(shape.kind));
  if (shape.one_way) add("one-way");
  if (shape.conveyor != 0) add("conveyor");
  if (shape.side == TileShape::Side::ceiling) add("ceiling");
  for (const TileShape& part : shape.parts) add_shape_words(part, words);
}

bool is_number(const std::string& word) { return word.find_first_not_of("0123456789") == std::string::npos; }

constexpr std::string_view kFlag = "flag:", kSet = "set:", kClass = "class:";

bool has_kind(const std::string& word) {
  return word.starts_with(kFlag) || word.starts_with(kSet) || word.starts_with(kClass);
}

bool has_word(const std::vector<std::string>& words, const std::string& wanted) {
  const bool of_flags = wanted.starts_with(kFlag);
  if (is_number(wanted) || (of_flags && is_number(wanted.substr(kFlag.size()))))
    return std::find(words.begin(), words.end(), wanted) != words.end();
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return has_kind(wanted) ? word.starts_with(wanted) : !has_kind(word) && word.find(wanted) != word.npos;
  });
}

// Words between blanks, or between quotes, which may be anywhere in a word.
std::vector<std::string> typed_words(std::string_view text) {
  std::vector<std::string> words;
  std::string word;
  bool is_quoted = false;
  const auto end_word = [&] {
    if (word.size() > 1 && word[0] == '#') word.erase(0, 1);
    if (!word.empty()) words.push_back(std::exchange(word, {}));
  };
  for (const char c : text) {
    if (c == '"')
      is_quoted = !is_quoted;
    else if (!is_quoted && std::string_view(" \t\r\n").find(c) != std::string_view::npos)
      end_word();
    else
      word += c;
  }
  end_word();
  return words;
}

}  // namespace

std::vector<std::string> words_of_tile(const Level& level, TileNumber tile) {
  std::vector<std::string> words = {std::to_string(tile)};
  const int set = tileset_with(level.tilesets, level.sheet(SheetId::tiles).layout(), tile);
  const auto add = [&](std::string_view kind, const std::string& name) {
    words.push_back(name);
    words.push_back(std::string(kind) + name);
  };
  if (set >= 0) add(kSet, in_lower_case(level.tilesets[static_cast<std::size_t>(set)].name));
  if (const std::string& type = note_of(level.tile_notes, tile).type; !type.empty())
    add(kClass, in_lower_case(type));
  const FlagSet flags = level.tile_flags(tile);
  for (int flag = 0; flag < kMaxFlags; ++flag) {
    if (!has_flag(flags, flag)) continue;
    words.push_back("flag:" + std::to_string(flag));
    const std::string& name = level.flag_names[static_cast<std::size_t>(flag)];
    if (!name.empty()) add(kFlag, in_lower_case(name));
  }
  for (const FlagRoleInfo& info : flag_role_infos())
    if (has_flag(flags, level.roles.*info.flag)) add(kFlag, std::string(info.label));
  for (const FlagField& field : level.flag_fields) {
    const auto value = static_cast<std::size_t>(field.value_of(flags));
    if (value > 0 && value < field.values.size() && !field.values[value].empty())
      add(kFlag, in_lower_case(field.values[value]));
  }
  add_shape_words(shape_of_tile(level, tile), words);
  return words;
}

std::vector<std::string> words_of_shape(const TileShape& shape) {
  std::vector<std::string> words;
  add_shape_words(shape, words);
  return words;
}

std::vector<bool> find_tiles(const Level& level, std::string_view text) {
  const std::vector<std::string> wanted = typed_words(in_lower_case(std::string(text)));
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
    for (const TileNumber tile : level.cells_of(layer).tiles()) ++counts[tile];
  return counts;
}

}  // namespace talus
