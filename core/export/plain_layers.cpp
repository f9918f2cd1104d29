#include "plain_layers.h"

#include <array>

#include "../formats/text/json_text.h"
#include "../formats/tiled/tiled_map.h"

namespace talus {
namespace {

std::string_view form_word(const MapObject& object) {
  constexpr std::array<std::string_view, 6> kWords = {"box",      "ellipse", "polygon",
                                                      "polyline", "tile",    "other"};
  const bool is_point = object.form == MapObject::Form::box && object.size == Vec2();
  return is_point ? "point" : kWords[static_cast<std::size_t>(object.form)];
}

constexpr std::uint32_t kTiledFlips = kTiledFlipX | kTiledFlipY | kTiledFlipXY;

TileTurn turn_of_gid(std::uint32_t gid) {
  return turn_of((gid & kTiledFlipXY) != 0, (gid & kTiledFlipX) != 0, (gid & kTiledFlipY) != 0);
}

// px of the map, with the rotation of the object.
std::vector<Vec2> points_of(const MapObject& object) {
  if (object.form == MapObject::Form::polygon) return outline_of(object);
  return line_of(object);
}

void put_looks(const LayerLooks& looks, OrderedJson& json) {
  if (!looks.visible) json["hidden"] = true;
  const auto number = [&](const char* key, double value, double usual) {
    if (value != usual) json[key] = json_number(value);
  };
  number("opacity", looks.opacity, 1);
  number("x", looks.offset.x, 0);
  number("y", looks.offset.y, 0);
  number("parallax_x", looks.parallax.x, 1);
  number("parallax_y", looks.parallax.y, 1);
  if (looks.tint != Rgb{255, 255, 255}) json["tint"] = {looks.tint.r, looks.tint.g, looks.tint.b};
}

}  // namespace

std::vector<ObjectPlace> objects_in_order(const Level& level) {
  std::vector<ObjectPlace> places;
  for (const LayerInOrder in_order : layers_in_order(level)) {
    if (in_order.has_tiles) continue;
    const ObjectLayer& layer = level.objects[static_cast<std::size_t>(in_order.index)];
    for (const MapObject& object : layer.objects) places.push_back({&layer, &object});
  }
  return places;
}

OrderedJson plain_object_json(const Level& level, ObjectPlace place) {
  const MapObject& object = *place.object;
  const Vec2 offset = shown_looks(level.layers.groups, *place.layer).offset;
  const Vec2 corner = top_left_of(object) + offset;
  OrderedJson json = {{"layer", place.layer->name},
                      {"form", form_word(object)},
                      {"class", object.type},
                      {"name", object.name},
                      {"x", json_number(corner.x)},
                      {"y", json_number(corner.y)},
                      {"w", json_number(object.size.x)},
                      {"h", json_number(object.size.y)}};
  const std::vector<Vec2> points = points_of(object);
  if (object.tile != 0) json["tile"] = object.tile & ~kTiledFlips;
  if (const TileTurn turn = turn_of_gid(object.tile); turn != TileTurn::none)
    json["turn"] = static_cast<int>(turn);
  if (object.rotation != 0 && points.empty()) json["rotation"] = json_number(object.rotation);
  for (const Vec2 point : points) {
    json["points"].emplace_back(json_number(point.x + offset.x));
    json["points"].emplace_back(json_number(point.y + offset.y));
  }
  if (place.layer->is_ground) json["ground"] = true;
  if (object.one_way) json["one_way"] = true;
  if (!object.visible) json["hidden"] = true;
  json["properties"] = plain_properties(object.properties);
  return json;
}

bool has_plain_layers(const Level& level) {
  return !level.layers.is_plain() || level.map.cells().has_turned() || !level.objects.empty();
}

OrderedJson plain_layer_json(const Level& level, LayerInOrder in_order) {
  const auto index = static_cast<std::size_t>(in_order.index);
  if (in_order.has_tiles) {
    const TileLayer& layer = level.layers.list[index];
    OrderedJson json = {{"kind", "tiles"}, {"name", layer.name}};
    if (layer.is_ground) json["ground"] = true;
    put_looks(shown_looks(level.layers.groups, layer), json);
    return json;
  }
  const ObjectLayer& layer = level.objects[index];
  OrderedJson json = {{"kind", layer.image ? "picture" : "objects"}, {"name", layer.name}};
  if (layer.is_ground) json["ground"] = true;
  put_looks(shown_looks(level.layers.groups, layer), json);
  if (!layer.image) return json;
  json["path"] = layer.image->path;
  if (layer.image->repeats_x) json["repeats_x"] = true;
  if (layer.image->repeats_y) json["repeats_y"] = true;
  return json;
}

OrderedJson plain_flag_names(const Level& level) {
  OrderedJson names = OrderedJson::object();
  for (std::size_t flag = 0; flag < level.flag_names.size(); ++flag)
    if (!level.flag_names[flag].empty()) names[std::to_string(flag)] = level.flag_names[flag];
  return names;
}

OrderedJson plain_roles(const FlagRoles& roles) {
  OrderedJson json = OrderedJson::object();
  for (const FlagRoleInfo& info : flag_role_infos()) {
    const int flag = roles.*info.flag;
    if (flag != FlagRoles::kUnused) json[std::string(info.key)] = flag;
  }
  return json;
}

OrderedJson plain_body_picture(const BodyPicture& picture) {
  OrderedJson json = OrderedJson::object();
  if (picture.sheet == SheetId::sprites) json["sheet"] = "sprites";
  json["columns"] = picture.columns;
  json["rows"] = picture.rows;
  json["steps"] = picture.steps;
  for (std::size_t act = 0; act < kBodyActWords.size(); ++act) {
    const BodyFrames& frames = frames_of(picture, static_cast<BodyAct>(act));
    json[std::string(kBodyActWords[act])] = {frames.first, frames.count};
  }
  return json;
}

OrderedJson plain_tilesets(const Level& level) {
  OrderedJson list = OrderedJson::array();
  for (const Tileset& tileset : level.tilesets) {
    OrderedJson& json = list.emplace_back(OrderedJson{{"name", tileset.name},
                                                      {"first", tileset.first},
                                                      {"count", tileset.count},
                                                      {"columns", tileset.columns}});
    if (tileset.link) json["path"] = tileset.link->path;
  }
  return list;
}

OrderedJson plain_animations(const Level& level) {
  OrderedJson list = OrderedJson::object();
  for (const auto& [tile, animation] : level.animations) {
    OrderedJson& numbers = list[std::to_string(tile)];
    for (const AnimationFrame& frame : animation) {
      numbers.push_back(frame.tile);
      numbers.push_back(frame.duration);
    }
  }
  return list;
}

OrderedJson plain_notes(const Level& level) {
  OrderedJson list = OrderedJson::object();
  for (const auto& [tile, note] : level.tile_notes) {
    OrderedJson& entry = list[std::to_string(tile)] = OrderedJson::object();
    if (!note.type.empty()) entry["class"] = note.type;
    if (note.probability != 1) entry["probability"] = json_number(note.probability);
    OrderedJson properties = plain_properties(note.properties);
    if (!properties.empty()) entry["properties"] = std::move(properties);
  }
  return list;
}

OrderedJson plain_properties(const std::string& properties) {
  OrderedJson json = OrderedJson::parse(properties, nullptr, false);
  return json.is_object() ? json : OrderedJson::object();
}

}  // namespace talus
