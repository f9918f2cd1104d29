#include "tiled_object_layers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "../text/json_text.h"

namespace talus {
namespace {

constexpr std::array<std::string_view, 11> kGroundWords = {"collision", "collisions", "collider", "colliders",
                                                           "solid",     "solids",     "wall",     "walls",
                                                           "ground",    "platform",   "platforms"};

bool is_ground_word(const std::string& text) {
  std::string lower = text;
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return std::find(kGroundWords.begin(), kGroundWords.end(), lower) != kGroundWords.end();
}

Json json_of_value(const TiledProperty& property) {
  return std::visit([](const auto& value) { return Json(value); }, property.value);
}

}  // namespace

ObjectLayer object_layer_of(const TiledLayer& layer) {
  ObjectLayer made;
  made.name = layer.name;
  made.visible = layer.looks.visible;
  made.is_ground = is_ground_word(layer.name) || is_ground_word(layer.type);
  for (const char* word : {"collidable", "solid", "ground"})
    if (const bool* is_ground = find_property<bool>(layer.properties, word)) made.is_ground = *is_ground;
  return made;
}

bool is_well_placed(const MapObject& object) {
  constexpr double kMostTurn = 1e9;  // degrees
  const auto is_near = [](Vec2 p) {
    return std::abs(p.x) <= kMaxObjectPlace && std::abs(p.y) <= kMaxObjectPlace;
  };
  return is_near(object.position) && is_near(object.size) && object.size.x >= 0 && object.size.y >= 0 &&
         std::abs(object.rotation) <= kMostTurn &&
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
  made.points = object.points;
  made.tile = object.gid;
  const bool* const one_way = find_property<bool>(object.properties, "one_way");
  made.one_way = one_way != nullptr && *one_way;
  if (object.properties.empty()) return made;
  Json properties = Json::object();
  for (const TiledProperty& property : object.properties) properties[property.name] = json_of_value(property);
  made.properties = properties.dump(-1, ' ', false, Json::error_handler_t::replace);
  return made;
}

}  // namespace talus
