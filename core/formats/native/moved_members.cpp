#include "moved_members.h"

#include <cmath>

#include <talus/level/limits.h>
#include "level/transform.h"
#include "native_objects.h"

namespace talus {
namespace {

// Adds to two numbers of an entry, or of a list.
template <class Key>
void move_pair(Json& json, Key x, Key y, Vec2 by) {
  if (!json[x].is_number() || !json[y].is_number()) return;
  json[x] = json_number(json[x].template get<double>() + by.x);
  json[y] = json_number(json[y].template get<double>() + by.y);
}

void move_entry(Json& entry, Vec2 by) {
  if (entry.is_object() && entry.contains("x") && entry.contains("y")) move_pair(entry, "x", "y", by);
}

// A layer of a picture is moved by its offset, the others by their objects.
void move_layer(Json& layer, Vec2 by) {
  if (!layer.is_object()) return;
  if (layer.contains("image")) {
    Json& offset = layer["offset"];
    if (offset.is_null()) offset = {0, 0};
    if (offset.is_array() && offset.size() == 2) move_pair(offset, std::size_t{0}, std::size_t{1}, by);
  }
  const auto objects = layer.find("objects");
  if (objects == layer.end() || !objects->is_array()) return;
  for (Json& object : *objects) move_entry(object, by);
}

}  // namespace

TileMap map_with_sides(const Json& wide, const Json& high, int usual_width, int usual_height, TileSize tile) {
  const auto side = [](const Json& json, int usual) {
    return is_whole(json, 1, kMaxTerrainSide) ? json.get<int>() : usual;
  };
  const int width = side(wide, usual_width), height = side(high, usual_height);
  return is_terrain_size(width, height, tile) ? TileMap(width, height, tile)
                                              : TileMap(usual_width, usual_height, tile);
}

Json json_of_ground(const GroundPlace& place) {
  Json marks = Json::array();
  for (const GroundMark& mark : place.marks)
    marks.push_back({mark.place.x, mark.place.y, mark.cell.tile, static_cast<int>(mark.cell.turn)});
  return {{"map", {place.width, place.height}}, {"layer", place.layer}, {"marks", std::move(marks)}};
}

std::optional<GroundPlace> ground_of_json(const Json& json) {
  if (!json.is_object()) return std::nullopt;
  const Json size = json.value("map", Json()), layer = json.value("layer", Json());
  const Json marks = json.value("marks", Json());
  if (!size.is_array() || size.size() != 2 || !is_whole(size[0], 1, kMaxTerrainSide) ||
      !is_whole(size[1], 1, kMaxTerrainSide) || !is_whole(layer, 0, kMaxLayers) || !marks.is_array() ||
      marks.size() > kMaxGroundMarks)
    return std::nullopt;
  GroundPlace place{{}, size[0].get<int>(), size[1].get<int>(), layer.get<int>(), {}};
  for (const Json& mark : marks) {
    if (!mark.is_array() || mark.size() != 4 || !is_whole(mark[0], 0, place.width - 1) ||
        !is_whole(mark[1], 0, place.height - 1) || !is_whole(mark[2], 0, kMaxTiles - 1) ||
        !is_whole(mark[3], 0, kTileTurns - 1))
      return std::nullopt;
    place.marks.push_back({{mark[0].get<int>(), mark[1].get<int>()},
                           {mark[2].get<TileNumber>(), static_cast<TileTurn>(mark[3].get<int>())}});
  }
  return place;
}

void move_spawns(Json& list, Vec2 by) {
  if (!list.is_array()) return;
  for (Json& entry : list) move_entry(entry, by);
}

void move_objects(Json& layers, Vec2 by) {
  if (!layers.is_array()) return;
  for (Json& layer : layers) move_layer(layer, by);
}

int move_curves(Json& list, Vec2 by, const TileMap& from, const TileMap& to) {
  Json copy = list;
  auto curves = take_curves(copy, "curves", from);
  if (!curves) return 0;
  const auto gone = std::erase_if(*curves, [&](LevelCurve& curve) {
    curve.curve = moved(curve.curve, by);
    return problem_of(curve.curve, to).has_value();
  });
  if (auto json = json_of(*curves, "curves", to)) list = *std::move(json);
  return static_cast<int>(gone);
}

}  // namespace talus
