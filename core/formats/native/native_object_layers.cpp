#include "native_object_layers.h"

#include <array>
#include <cmath>

#include "native_members.h"

namespace talus {
namespace {

constexpr std::array<std::string_view, 6> kObjectForms = {"box",      "ellipse", "polygon",
                                                          "polyline", "tile",    "other"};
constexpr double kMaxRotation = 1e9;  // degrees, to either side

FormatResult<MapObject> take_object(Json& json, const std::string& path) {
  MemberTaker take(json, path);
  MapObject object;
  take.choice("form", kObjectForms, object.form);
  take.optional("name", object.name);
  take.optional("class", object.type);
  take.ranged("x", -kMaxObjectPlace, kMaxObjectPlace, "px", object.position.x);
  take.ranged("y", -kMaxObjectPlace, kMaxObjectPlace, "px", object.position.y);
  take.ranged("width", 0, kMaxObjectPlace, "px", object.size.x);
  take.ranged("height", 0, kMaxObjectPlace, "px", object.size.y);
  take.ranged("rotation", -kMaxRotation, kMaxRotation, "degrees", object.rotation);
  take.optional("points", object.points);
  take.optional("one_way", object.one_way);
  double tile = 0;
  take.ranged("tile", 0, 4294967295.0, "", tile);
  object.tile = static_cast<std::uint32_t>(tile);
  take.member("properties", [&](const Json& its) {
    if (!its.is_object()) return take.fail("properties", "must be an object");
    object.properties = its.dump();
  });
  std::optional<std::string> problem;
  if (json.is_object() && !json.empty())
    problem = "has the key \"" + json.begin().key() + "\", which no object has";
  for (const Vec2 point : object.points) {
    const bool is_near = std::abs(point.x) <= kMaxObjectPlace && std::abs(point.y) <= kMaxObjectPlace;
    if (!is_near) problem = "has a point further than 16777216 px from its position";
  }
  return take.result(std::move(object), std::move(problem));
}

FormatResult<Json> json_of_object(const MapObject& object, const std::string& path) {
  Json json = Json::object();
  MemberPutter put(json);
  const MapObject usual;
  if (object.form != usual.form) json["form"] = kObjectForms[static_cast<std::size_t>(object.form)];
  if (!object.name.empty()) json["name"] = object.name;
  if (!object.type.empty()) json["class"] = object.type;
  put("x", object.position.x);
  put("y", object.position.y);
  if (object.size.x != 0) put("width", object.size.x);
  if (object.size.y != 0) put("height", object.size.y);
  if (object.rotation != 0) put("rotation", object.rotation);
  if (!object.points.empty()) put("points", object.points);
  if (object.one_way) json["one_way"] = true;
  if (object.tile != 0) json["tile"] = object.tile;
  if (!object.properties.empty()) {
    auto properties = parse_extra(object.properties);
    if (!properties) return properties;
    json["properties"] = *std::move(properties);
  }
  Json copy = json;  // what a reader would refuse is not written
  if (const auto good = take_object(copy, path); !good) return tl::unexpected(good.error());
  return json;
}

FormatResult<ObjectLayer> take_layer_of_objects(Json& json, const std::string& path) {
  MemberTaker take(json, path);
  ObjectLayer layer;
  take.optional("name", layer.name);
  take.optional("ground", layer.is_ground);
  take.optional("visible", layer.visible);
  Json list = Json::array();
  take.member("objects", [&](const Json& its) { list = its; });
  if (const auto good = take.result(true); !good) return tl::unexpected(good.error());
  auto objects = take_list<MapObject>(list, path + ".objects", take_object, kMaxMapObjects,
                                      "must be a list of up to 262144 objects");
  if (!objects) return tl::unexpected(objects.error());
  layer.objects = *std::move(objects);
  layer.extra = take.rest();
  return layer;
}

FormatResult<Json> json_of_layer_of_objects(const ObjectLayer& layer, const std::string& path) {
  auto json = parse_extra(layer.extra);
  if (!json) return json;
  if (!layer.name.empty()) (*json)["name"] = layer.name;
  if (layer.is_ground) (*json)["ground"] = true;
  if (!layer.visible) (*json)["visible"] = false;
  auto objects = put_list(layer.objects, path + ".objects", json_of_object);
  if (!objects) return objects;
  (*json)["objects"] = *std::move(objects);
  return json;
}

}  // namespace

FormatResult<std::vector<ObjectLayer>> take_object_layers(Json& list, const std::string& path) {
  return take_list<ObjectLayer>(list, path, take_layer_of_objects, kMaxObjectLayers,
                                "must be a list of up to 4096 layers of objects");
}

FormatResult<Json> json_of(const std::vector<ObjectLayer>& layers, const std::string& path) {
  return put_list(layers, path, json_of_layer_of_objects);
}

}  // namespace talus
