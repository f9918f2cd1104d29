#include "tiled_object_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "../text/name_words.h"
#include "tiled_properties.h"

namespace talus {
namespace {

constexpr std::array<std::string_view, 5> kCollisionWords = {"collision", "collider", "collidable", "solid",
                                                             "obstacle"};
constexpr std::array<std::string_view, 2> kWallWords = {"wall", "platform"};
constexpr std::array<std::string_view, 1> kGroundWords = {"ground"};
constexpr std::array<std::span<const std::string_view>, 3> kWordsOfGround = {kCollisionWords, kWallWords,
                                                                             kGroundWords};

// Whether the name is one of these words, or its plural, but for numbers, what is in brackets, and words that
// say what a layer is: "Walls 2", "CollisionLayer", "Ground tiles".
bool is_word_of(std::span<const std::string_view> words, const std::string& text) {
  constexpr std::array<std::string_view, 3> kPlain = {"layer", "tile", "map"};
  std::string name = text.substr(0, text.find('('));
  std::erase_if(name, [](char c) { return c >= '0' && c <= '9'; });
  std::vector<std::string> left = name_words(name);
  std::erase_if(left, [&](const std::string& word) {
    return std::find(kPlain.begin(), kPlain.end(), word) != kPlain.end();
  });
  return left.size() == 1 && std::find(words.begin(), words.end(), left.front()) != words.end();
}

bool is_ground_word(const std::string& text) {
  return std::any_of(kWordsOfGround.begin(), kWordsOfGround.end(),
                     [&](std::span<const std::string_view> words) { return is_word_of(words, text); });
}

}  // namespace

ObjectLayer object_layer_of(const TiledLayer& layer) {
  ObjectLayer made;
  made.name = layer.name;
  made.visible = layer.looks.visible;
  made.locked = layer.looks.locked;
  made.opacity = layer.looks.opacity;
  made.offset = layer.looks.offset;
  made.parallax = layer.looks.parallax;
  made.tint = layer.looks.tint;
  made.group = layer.looks.group;
  made.by_y = layer.by_y;
  made.is_ground = is_ground_word(layer.name) || is_ground_word(layer.type);
  made.is_ground = ground_by_word(layer.properties).value_or(made.is_ground);
  return made;
}

void choose_tile_ground(TiledMap& map) {
  const bool is_own = find_property<std::string>(map.properties, kTiledLevelProperty) != nullptr;
  const auto is_named = [](const TiledLayer& layer) {
    return layer.has_tiles && layer.says_ground.value_or(true) &&
           (is_ground_word(layer.name) || is_ground_word(layer.type));
  };
  const bool has_named = !is_own && std::any_of(map.layers.begin(), map.layers.end(), is_named);
  for (TiledLayer& layer : map.layers)
    if (layer.has_tiles) layer.looks.is_ground = layer.says_ground.value_or(!has_named || is_named(layer));
}

std::optional<int> rank_of_ground(const TiledLayer& layer) {
  for (std::size_t rank = 0; rank < kWordsOfGround.size(); ++rank)
    if (is_word_of(kWordsOfGround[rank], layer.name) || is_word_of(kWordsOfGround[rank], layer.type))
      return static_cast<int>(rank);
  return std::nullopt;
}

bool is_well_placed(const MapObject& object) {
  constexpr double kMaxTurn = 1e9;  // degrees
  const auto is_near = [](Vec2 p) {
    return std::abs(p.x) <= kMaxObjectPlace && std::abs(p.y) <= kMaxObjectPlace;
  };
  return is_near(object.position) && is_near(object.size) && object.size.x >= 0 && object.size.y >= 0 &&
         std::abs(object.rotation) <= kMaxTurn &&
         std::all_of(object.points.begin(), object.points.end(), is_near);
}

MapObject map_object_of(const TiledObject& object, const std::string& type) {
  using From = TiledObject::Form;
  using To = MapObject::Form;
  MapObject made;
  made.form = object.form == From::box        ? To::box
              : object.form == From::ellipse  ? To::ellipse
              : object.form == From::polygon  ? To::polygon
              : object.form == From::polyline ? To::polyline
              : object.form == From::tile     ? To::tile
                                              : To::other;
  made.name = object.name;
  made.type = type;
  made.position = object.position;
  made.size = object.points.empty() ? object.size : Vec2();
  made.rotation = object.rotation;
  made.visible = object.visible;
  made.points = object.points;
  made.tile = object.gid;
  const bool* const one_way = find_property<bool>(object.properties, "one_way");
  made.one_way = one_way != nullptr && *one_way;
  made.properties = json_of_properties(object.properties);
  return made;
}

TiledObject tiled_object(const MapObject& object) {
  using From = MapObject::Form;
  using To = TiledObject::Form;
  TiledObject made;
  made.form = object.form == From::ellipse    ? To::ellipse
              : object.form == From::polygon  ? To::polygon
              : object.form == From::polyline ? To::polyline
              : object.form == From::tile     ? To::tile
              : object.form == From::other    ? To::other
                                              : To::box;
  made.name = object.name;
  made.type = object.type;
  made.gid = object.tile;
  made.position = object.position;
  made.size = object.size;
  made.rotation = object.rotation;
  made.visible = object.visible;
  made.points = object.points;
  return made;
}

}  // namespace talus
