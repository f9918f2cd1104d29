#include "moved_companion.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include <talus/level/limits.h>
#include "moved_members.h"
#include "native_document.h"

namespace talus {
namespace {

// The map that a companion gives the level, or else a map of that size.
TileMap map_of_companion(const Json& companion, int width, int height, TileSize tile) {
  const auto map = companion.find("map");
  const bool has_map = map != companion.end() && map->is_object();
  const auto side = [&](const char* key) { return has_map ? map->value(key, Json()) : Json(); };
  return map_with_sides(side("width"), side("height"), width, height, tile);
}

// Sums of px differ in their last bits from what a file says. Few digits bring its numbers back.
void round_numbers(Json& json) {
  constexpr int kDigits = 12;
  if (json.is_structured()) {
    for (Json& part : json) round_numbers(part);
  } else if (json.is_number_float()) {
    std::array<char, 64> text = {};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), json.get<double>(),
                                   std::chars_format::general, kDigits)
                         .ptr;
    double rounded = 0;
    std::from_chars(text.data(), end, rounded);
    json = json_number(rounded);
  }
}

}  // namespace

std::optional<GroundPlace> ground_of_frame(const Json& about) {
  const Json frame = about.is_object() ? about.value("frame", Json()) : Json();
  if (!frame.is_object()) return std::nullopt;
  const Json area = frame.value("map", Json());
  constexpr std::int64_t kMaxPlace = 1 << 30;
  if (!area.is_array() || area.size() != 4 || !is_whole(area[0], -kMaxPlace, kMaxPlace) ||
      !is_whole(area[1], -kMaxPlace, kMaxPlace) || !is_whole(area[2], 1, kMaxTerrainSide) ||
      !is_whole(area[3], 1, kMaxTerrainSide))
    return std::nullopt;
  GroundPlace place{{}, area[2].get<int>(), area[3].get<int>(), 0, {}};
  if (const auto marked = ground_of_json(frame.value("ground", Json()));
      marked && marked->width == place.width && marked->height == place.height)
    place = *marked;
  place.origin = Cell{area[0].get<int>(), area[1].get<int>()};
  return place;
}

int move_companion(Json& companion, Cell by, const GroundPlace& place, const Level& held) {
  const TileSize tile = held.map.tile_size();
  const Vec2 px = held.map.corner_of(by);
  const auto curves = companion.find("curves");
  const bool has_curves = curves != companion.end() && curves->is_array();
  const TileMap from =
      has_curves ? map_of_companion(companion, place.width, place.height, tile) : TileMap(1, 1, tile);
  if (const auto map = companion.find("map"); map != companion.end() && map->is_object()) {
    const Cell growth = growth_at_corner(place, held.map, by);
    for (const auto& [key, cells] : {std::pair("width", growth.x), std::pair("height", growth.y)}) {
      if (!map->contains(key) || !is_whole((*map)[key], 1, kMaxTerrainSide)) continue;
      (*map)[key] = std::clamp((*map)[key].get<int>() + cells, 1, static_cast<int>(kMaxTerrainSide));
    }
  }
  if (companion.contains("spawns")) move_spawns(companion["spawns"], px);
  if (companion.contains("objects")) move_objects(companion["objects"], px);
  if (!has_curves) return 0;
  const TileMap now = map_of_companion(companion, held.map.width(), held.map.height(), tile);
  return move_curves(*curves, px, from, now);
}

std::optional<Json> document_before_shift(const Level& held, Cell by, const GroundPlace& place) {
  if (!is_terrain_size(place.width, place.height, held.map.tile_size())) return std::nullopt;
  Level then = with_moved_ground(held, {-by.x, -by.y}, place.width, place.height);
  std::erase_if(then.curves,
                [&](const LevelCurve& curve) { return problem_of(curve.curve, then.map).has_value(); });
  auto document = native_document(then);
  if (!document) return std::nullopt;
  for (const char* const key : {"spawns", "curves", "objects"})
    if (document->contains(key)) round_numbers((*document)[key]);
  return *std::move(document);
}

std::string with_shift_note(const std::string& note, const std::string& file, Cell by, bool has_grown,
                            int lost_curves) {
  std::string text = has_grown ? file + " begins " + words_for_shift(by)
                               : "The ground of " + file + " lies " + words_for_shift({-by.x, -by.y});
  text += " than it did, so what was added to it has moved with its ground";
  if (lost_curves > 0) {
    text += ", but " + std::to_string(lost_curves) + (lost_curves == 1 ? " curve" : " curves") +
            " would leave the map and " + (lost_curves == 1 ? "is" : "are") + " left out";
  }
  return note.empty() ? text : note + ". " + text;
}

}  // namespace talus
