// Choices, or else what names say.
#include "ldtk_meanings.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "../text/utf8_text.h"
#include "ldtk_names.h"

namespace talus {
namespace {

using Kind = LdtkMapping::Kind;

constexpr std::string_view kNothing = "none", kOwnFlag = "own";

// Heights in halves of a tile.
struct LdtkShapeRow {
  LdtkWord word;
  TileShape::Kind kind = TileShape::Kind::slope;
  int left = 0, right = 0;
  bool is_ceiling = false, is_one_way = false;
};
constexpr std::array<LdtkShapeRow, 12> kLdtkShapes = {{
    {{kNothing, "nothing"}, TileShape::Kind::none},
    {{"solid", "solid"}, TileShape::Kind::solid},
    {{"one_way", "one-way"}, TileShape::Kind::solid, 0, 0, false, true},
    {{"slope_up", "slope up, 45\xC2\xB0"}, TileShape::Kind::slope, 0, 2},
    {{"slope_down", "slope down, 45\xC2\xB0"}, TileShape::Kind::slope, 2, 0},
    {{"slope_up_low", "slope up, 26.6\xC2\xB0, low half"}, TileShape::Kind::slope, 0, 1},
    {{"slope_up_high", "slope up, 26.6\xC2\xB0, high half"}, TileShape::Kind::slope, 1, 2},
    {{"slope_down_high", "slope down, 26.6\xC2\xB0, high half"}, TileShape::Kind::slope, 2, 1},
    {{"slope_down_low", "slope down, 26.6\xC2\xB0, low half"}, TileShape::Kind::slope, 1, 0},
    {{"half", "lower half"}, TileShape::Kind::slope, 1, 1},
    {{"ceiling_up", "ceiling, thick on the right"}, TileShape::Kind::slope, 0, 2, true},
    {{"ceiling_down", "ceiling, thick on the left"}, TileShape::Kind::slope, 2, 0, true},
}};

bool has_word(std::span<const LdtkWord> words, const std::string& wanted) {
  return std::any_of(words.begin(), words.end(), [&](const LdtkWord& word) { return word.word == wanted; });
}

TileShape shape_of_ldtk_word(const std::string& word, TileSize tile) {
  TileShape shape;
  for (const LdtkShapeRow& row : kLdtkShapes) {
    if (row.word.word != word) continue;
    shape.kind = row.kind;
    shape.one_way = row.is_one_way;
    if (row.kind == TileShape::Kind::slope)
      shape.heights = {row.left * tile.height / 2.0, row.right * tile.height / 2.0};
    if (row.is_ceiling) shape.side = TileShape::Side::ceiling;
  }
  return shape;
}

// Lays a choice over what a name says.
LdtkMeaning chosen_meaning(LdtkMeaning usual, const LdtkMapping::Choice* choice, const std::string& own_name,
                           TileSize tile) {
  if (choice == nullptr) return usual;
  if (!choice->shape.empty()) {
    usual.shape = shape_of_ldtk_word(choice->shape, tile);
    usual.has_shape = true;
    usual.is_unclear = false;
  }
  if (choice->flag.empty()) return usual;
  usual.flag = choice->flag == kOwnFlag ? own_name : "";
  for (const FlagRoleInfo& role : flag_role_infos()) {
    if (role.key == choice->flag) usual.role = role.flag;
  }
  return usual;
}

const LdtkValue* find_ldtk_value(const LdtkProject& project, LdtkCellValue value) {
  if (value.layer < 0) return nullptr;
  const auto& values = project.layers[static_cast<std::size_t>(value.layer)].values;
  const auto found = std::find_if(values.begin(), values.end(),
                                  [&](const LdtkValue& each) { return each.value == value.value; });
  return found == values.end() ? nullptr : &*found;
}

// A value is solid unless its name says otherwise.
LdtkMeaning usual_of_value(const std::string& name, TileSize tile) {
  const auto ground = ldtk_ground_of_name(name, tile);
  if (!ground) return {.shape = {.kind = TileShape::Kind::solid}, .flag = name};
  return {.shape = ground->shape, .flag = ground->is_plain ? "" : name, .is_unclear = ground->is_unclear};
}

LdtkMeaning usual_of_tag(const std::string& name, TileSize tile) {
  const auto ground = ldtk_ground_of_name(name, tile);
  const bool is_shape = ground && ground->shape.kind != TileShape::Kind::none && !ground->is_unclear;
  LdtkMeaning usual{.has_shape = is_shape};
  if (is_shape) usual.shape = ground->shape;
  if (!is_shape || !ground->is_plain) usual.flag = name;
  return usual;
}

// The shape that a tile's tags give it, as its flips turn it.
TileShape flipped_shape(TileShape shape, int flips) {
  if ((flips & 1) != 0) std::reverse(shape.heights.begin(), shape.heights.end());
  if ((flips & 2) != 0 && has_heights(shape)) {
    shape.side = shape.side == TileShape::Side::floor ? TileShape::Side::ceiling : TileShape::Side::floor;
  }
  return shape;
}

// Works each value and tag out once.
class LdtkTileReader {
 public:
  LdtkTileReader(const LdtkProject& project, const LdtkMapping& mapping, const LdtkTiles& tiles,
                 ImportDrops& drops)
      : project_(project), mapping_(mapping), tiles_(tiles), drops_(drops) {}

  LdtkTileMeaning meaning_of(const LdtkCell& cell) {
    LdtkTileMeaning meaning;
    std::optional<TileShape> shape;      // of tags
    std::set<std::pair<int, int>> seen;  // by tileset and tile: a cell may show one many times
    for (auto part = cell.parts.rbegin(); part != cell.parts.rend(); ++part) {
      const LdtkSource& source = tiles_.sources[part->source];
      if (!is_in_place(*part, source, tiles_.map.tile_size())) continue;
      if (!seen.insert({source.tileset, source.id}).second) continue;
      const std::vector<LdtkMeaning>& tags = tags_of(source);
      if (tags.size() > kMaxTagsRead - tags_read_) {
        drops_.add("tags of tiles beyond " + std::to_string(kMaxTagsRead));
        continue;
      }
      tags_read_ += tags.size();
      const bool had_shape = shape.has_value();
      for (const LdtkMeaning& tag : tags) {
        add_flags(tag, meaning);
        if (!had_shape && !shape && tag.has_shape) shape = flipped_shape(tag.shape, source.flips);
      }
    }
    if (cell.value.value != 0 && cell.value.layer != LdtkCellValue::kNoCell) {
      const LdtkMeaning& value = value_of(cell.value);
      meaning.shape = value.shape;
      add_flags(value, meaning);
    }
    const bool is_plain =
        meaning.shape.kind == TileShape::Kind::none || meaning.shape.kind == TileShape::Kind::solid;
    if (shape && is_plain) meaning.shape = *shape;
    return meaning;
  }

 private:
  static void add_flags(const LdtkMeaning& of, LdtkTileMeaning& meaning) {
    if (!of.flag.empty()) {
      const auto at = std::lower_bound(meaning.flags.begin(), meaning.flags.end(), of.flag);
      if (at == meaning.flags.end() || *at != of.flag) meaning.flags.insert(at, of.flag);
    }
    const bool has_role =
        std::find(meaning.roles.begin(), meaning.roles.end(), of.role) != meaning.roles.end();
    if (of.role != nullptr && !has_role) meaning.roles.push_back(of.role);
  }
  const LdtkMeaning& value_of(LdtkCellValue value) {
    const auto [known, is_new] = values_.try_emplace(value);
    if (!is_new) return known->second;
    known->second = ldtk_meaning_of_value(project_, mapping_, value, tiles_.map.tile_size());
    if (known->second.is_unclear) {
      drops_.add("the slope of the value " + quoted_name(find_ldtk_value(project_, value)->name) +
                 ", as its name does not tell how it goes: it is a full tile");
    }
    return known->second;
  }
  const std::vector<LdtkMeaning>& tags_of(const LdtkSource& source) {
    const auto [known, is_new] = tags_.try_emplace({source.tileset, source.id});
    if (!is_new || source.tileset < 0) return known->second;
    const LdtkTileset& tileset = project_.tilesets[static_cast<std::size_t>(source.tileset)];
    for (const LdtkTag& tag : tileset.tags) {
      if (std::binary_search(tag.tiles.begin(), tag.tiles.end(), source.id))
        known->second.push_back(
            ldtk_meaning_of_tag(mapping_, tileset.name, tag.name, tiles_.map.tile_size()));
    }
    return known->second;
  }

  const LdtkProject& project_;
  const LdtkMapping& mapping_;
  const LdtkTiles& tiles_;
  ImportDrops& drops_;
  std::map<LdtkCellValue, LdtkMeaning> values_;
  std::map<std::pair<int, int>, std::vector<LdtkMeaning>> tags_;  // by tileset and tile
  static constexpr std::size_t kMaxTagsRead = std::size_t{1} << 24;
  std::size_t tags_read_ = 0;  // of the tiles in all cells
};

std::string usual_text(const LdtkMeaning& meaning) {
  const TileShape& shape = meaning.shape;
  std::string text = !meaning.has_shape                     ? ""
                     : shape.kind == TileShape::Kind::none  ? "nothing"
                     : shape.kind == TileShape::Kind::slope ? "a slope"
                     : shape.one_way                        ? "one-way"
                                                            : "solid";
  if (!meaning.flag.empty()) text += std::string(text.empty() ? "" : ", ") + "its own flag";
  return text.empty() ? "nothing" : text;
}

}  // namespace

std::span<const LdtkWord> ldtk_shape_words() {
  static const auto words = [] {
    std::array<LdtkWord, kLdtkShapes.size()> list;
    for (std::size_t i = 0; i < list.size(); ++i) list[i] = kLdtkShapes[i].word;
    return list;
  }();
  return words;
}

std::span<const LdtkWord> ldtk_flag_words() {
  static const auto words = [] {
    std::vector<LdtkWord> list = {{kNothing, "no flag"}, {kOwnFlag, "a flag of its name"}};
    for (const FlagRoleInfo& role : flag_role_infos()) list.push_back({role.key, role.label});
    return list;
  }();
  return words;
}

std::span<const LdtkWord> ldtk_body_words() {
  static const auto words = [] {
    std::vector<LdtkWord> list = {{kNothing, "nothing"}};
    for (const BodyTraits& kind : body_kinds()) list.push_back({kind.word, kind.word});
    return list;
  }();
  return words;
}

bool is_good(const LdtkMapping::Choice& choice) {
  const bool is_entity = choice.kind == Kind::entity;
  return (choice.shape.empty() || (!is_entity && has_word(ldtk_shape_words(), choice.shape))) &&
         (choice.flag.empty() || (!is_entity && has_word(ldtk_flag_words(), choice.flag))) &&
         (choice.body.empty() || (is_entity && has_word(ldtk_body_words(), choice.body)));
}

LdtkMeaning ldtk_meaning_of_value(const LdtkProject& project, const LdtkMapping& mapping, LdtkCellValue value,
                                  TileSize tile) {
  const LdtkValue* const known = find_ldtk_value(project, value);
  const std::string name = known != nullptr ? known->name : "";
  const std::string number = std::to_string(value.value);
  const std::string layer = value.layer < 0 ? "" : project.layers[static_cast<std::size_t>(value.layer)].name;
  return chosen_meaning(usual_of_value(name, tile), mapping.find(Kind::value, layer, number),
                        name.empty() ? "value " + number : name, tile);
}

LdtkMeaning ldtk_meaning_of_tag(const LdtkMapping& mapping, const std::string& tileset,
                                const std::string& tag, TileSize tile) {
  return chosen_meaning(usual_of_tag(tag, tile), mapping.find(Kind::tag, tileset, tag), tag, tile);
}

std::optional<BodyKind> ldtk_meaning_of_entity(const LdtkMapping& mapping, const std::string& type) {
  const LdtkMapping::Choice* const choice = mapping.find(Kind::entity, "", type);
  return choice == nullptr || choice->body.empty() ? ldtk_body_of_name(type) : find_body_kind(choice->body);
}

std::vector<LdtkTileMeaning> ldtk_tile_meanings(const LdtkProject& project, const LdtkMapping& mapping,
                                                const LdtkTiles& tiles, ImportDrops& drops) {
  LdtkTileReader reader(project, mapping, tiles, drops);
  std::vector<LdtkTileMeaning> meanings;
  meanings.reserve(tiles.cells.size());
  for (const LdtkCell& cell : tiles.cells) meanings.push_back(reader.meaning_of(cell));
  return meanings;
}

std::vector<LdtkThing> ldtk_things_of(const LdtkProject& project, const LdtkLevel& level) {
  std::map<std::pair<int, int>, int> values, tiles;  // by layer and value, by tileset and tile
  std::map<std::string, int> entities;
  for (const LdtkLayer& layer : level.layers) {
    for (const int value : layer.values) ++values[{layer.def, value}];
    for (const LdtkTile& tile : layer.tiles) ++tiles[{layer.tileset, tile.id}];
    for (const LdtkEntity& entity : layer.entities) ++entities[entity.type];
  }
  std::vector<LdtkThing> things;
  const auto add = [&](LdtkThing thing) {
    if (things.size() < kMaxLdtkThings) things.push_back(std::move(thing));
  };
  for (std::size_t i = 0; i < project.layers.size(); ++i) {
    for (const LdtkValue& value : project.layers[i].values) {
      const std::string number = std::to_string(value.value);
      add({{Kind::value, project.layers[i].name, number},
           printable_line(value.name.empty() ? "value " + number : value.name),
           usual_text(usual_of_value(value.name, {})),
           value.color,
           values[{static_cast<int>(i), value.value}]});
    }
  }
  for (std::size_t i = 0; i < project.tilesets.size(); ++i) {
    for (const LdtkTag& tag : project.tilesets[i].tags) {
      int count = 0;
      for (const int tile : tag.tiles) {
        const auto found = tiles.find({static_cast<int>(i), tile});
        if (found != tiles.end()) count += found->second;
      }
      add({{Kind::tag, project.tilesets[i].name, tag.name},
           printable_line(tag.name),
           usual_text(usual_of_tag(tag.name, {})),
           std::nullopt,
           count});
    }
  }
  for (const LdtkEntityDef& def : project.entities) entities.try_emplace(def.name, 0);
  for (const auto& type : entities) {
    const auto def = std::find_if(project.entities.begin(), project.entities.end(),
                                  [&](const LdtkEntityDef& each) { return each.name == type.first; });
    const auto body = ldtk_body_of_name(type.first);
    add({{Kind::entity, "", type.first},
         printable_line(type.first),
         body ? std::string(traits_of(*body).word) : "nothing",
         def == project.entities.end() ? std::nullopt : std::optional(def->color),
         type.second});
  }
  return things;
}

}  // namespace talus
