#include "native_object_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <talus/level/limits.h>
#include "native_layers.h"
#include "native_members.h"

namespace talus {
namespace {

constexpr std::array<std::string_view, 6> kObjectForms = {"box",      "ellipse", "polygon",
                                                          "polyline", "tile",    "other"};
constexpr double kMaxRotation = 1e9;  // degrees, to either side

FormatResult<MapObject> take_object(Json& json, const std::string& path, const NativePictures& pictures) {
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
  take.optional("visible", object.visible);
  take_part(take, pictures, object.picture);
  take.optional("anchor", object.anchor);
  const auto is_share = [](double share) { return share >= 0 && share <= 1; };
  if (!is_share(object.anchor.x) || !is_share(object.anchor.y))
    take.fail("anchor", "must be [x, y], each from 0 to 1");
  take.member("tile", [&](const Json& tile) {
    constexpr std::int64_t kMax = std::numeric_limits<std::uint32_t>::max();
    if (!is_whole(tile, 0, kMax)) return take.fail("tile", range_text(0, kMax, "", true));
    object.tile = tile.get<std::uint32_t>();
  });
  take.member("properties", [&](const Json& its) {
    if (!its.is_object()) return take.fail("properties", "must be an object");
    object.properties = its.dump();
  });
  std::optional<std::string> problem;
  if (json.is_object() && !json.empty())
    problem = "has the key \"" + json.begin().key() + "\", which no object has";
  for (const Vec2 point : object.points) {
    const bool is_near = std::abs(point.x) <= kMaxObjectPlace && std::abs(point.y) <= kMaxObjectPlace;
    if (!is_near) take.fail("points", "has a point further than 16777216 px from its position");
  }
  return take.result(std::move(object), std::move(problem));
}

FormatResult<Json> json_of_object(const MapObject& object, const std::string& path,
                                  const NativePictures& pictures) {
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
  if (!object.visible) json["visible"] = false;
  put_part(object.picture, pictures, json);
  if (object.anchor != usual.anchor) put("anchor", object.anchor);
  if (!object.properties.empty()) {
    auto properties = parse_extra(object.properties);
    if (!properties) return properties;
    json["properties"] = *std::move(properties);
  }
  Json copy = json;  // what a reader would refuse is not written
  if (const auto good = take_object(copy, path, pictures); !good) return tl::unexpected(good.error());
  return json;
}

FormatResult<LayerImage> take_image(Json& json, const std::string& path, const NativePictures& pictures) {
  MemberTaker take(json, path);
  LayerImage image;
  take.optional("path", image.path);
  take_part(take, pictures, image.part);
  take.optional("repeats_x", image.repeats_x);
  take.optional("repeats_y", image.repeats_y);
  std::optional<std::string> problem;
  if (json.is_object() && !json.empty())
    problem = "has the key \"" + json.begin().key() + "\", which no picture of a layer has";
  return take.result(std::move(image), std::move(problem));
}

Json json_of_image(const LayerImage& image, const NativePictures& pictures) {
  Json json = Json::object();
  if (!image.path.empty()) json["path"] = image.path;
  put_part(image.part, pictures, json);
  if (image.repeats_x) json["repeats_x"] = true;
  if (image.repeats_y) json["repeats_y"] = true;
  return json;
}

FormatResult<ObjectLayer> take_layer_of_objects(Json& json, const std::string& path,
                                                const NativePictures& pictures) {
  MemberTaker take(json, path);
  ObjectLayer layer;
  take.optional("name", layer.name);
  take.optional("ground", layer.is_ground);
  take.optional("group", layer.group);
  take_looks(take, layer);
  take.optional("by_y", layer.by_y);
  take.member("place", [&](const Json& place) {
    if (!is_whole(place, 0, kMaxLayers))
      return take.fail("place", "must be a whole number from 0 to " + std::to_string(kMaxLayers));
    layer.place = place.get<int>();
  });
  Json list = Json::array(), image;
  take.member("objects", [&](const Json& its) { list = its; });
  take.member("image", [&](const Json& its) { image = its; });
  if (const auto good = take.result(true); !good) return tl::unexpected(good.error());
  const auto take_one = [&](Json& its, const std::string& place) {
    return take_object(its, place, pictures);
  };
  auto objects = take_list<MapObject>(list, path + ".objects", take_one, kMaxMapObjects,
                                      "must be a list of up to 262144 objects");
  if (!objects) return tl::unexpected(objects.error());
  layer.objects = *std::move(objects);
  if (!image.is_null()) {
    auto taken = take_image(image, path + ".image", pictures);
    if (!taken) return tl::unexpected(taken.error());
    layer.image = *std::move(taken);
  }
  layer.extra = take.rest();
  return layer;
}

FormatResult<Json> json_of_layer_of_objects(const ObjectLayer& layer, const std::string& path,
                                            const NativePictures& pictures) {
  if (const auto good = check_looks(layer, path); !good) return tl::unexpected(good.error());
  auto json = parse_extra(layer.extra);
  if (!json) return json;
  if (!layer.name.empty()) (*json)["name"] = layer.name;
  if (layer.is_ground) (*json)["ground"] = true;
  if (layer.group >= 0) (*json)["group"] = layer.group;
  put_looks(layer, *json);
  if (layer.by_y) (*json)["by_y"] = true;
  if (layer.place <= kMaxLayers) (*json)["place"] = std::max(0, layer.place);
  if (layer.image) (*json)["image"] = json_of_image(*layer.image, pictures);
  const auto put_one = [&](const MapObject& object, const std::string& place) {
    return json_of_object(object, place, pictures);
  };
  auto objects = put_list(layer.objects, path + ".objects", put_one);
  if (!objects) return objects;
  (*json)["objects"] = *std::move(objects);
  return json;
}

}  // namespace

FormatResult<std::vector<ObjectLayer>> take_object_layers(Json& list, const std::string& path,
                                                          const NativePictures& pictures) {
  const auto take = [&](Json& its, const std::string& place) {
    return take_layer_of_objects(its, place, pictures);
  };
  return take_list<ObjectLayer>(list, path, take, kMaxObjectLayers,
                                "must be a list of up to 4096 layers of objects");
}

FormatResult<Json> json_of(const std::vector<ObjectLayer>& layers, const std::string& path,
                           const NativePictures& pictures) {
  return put_list(layers, path, [&](const ObjectLayer& layer, const std::string& place) {
    return json_of_layer_of_objects(layer, place, pictures);
  });
}

bool has_new_objects(const std::vector<ObjectLayer>& layers) {
  const MapObject usual;
  const auto is_new = [&](const MapObject& object) {
    return !object.visible || object.picture.picture != nullptr || object.anchor != usual.anchor;
  };
  return std::any_of(layers.begin(), layers.end(), [&](const ObjectLayer& layer) {
    return layer.image || std::any_of(layer.objects.begin(), layer.objects.end(), is_new);
  });
}

}  // namespace talus
