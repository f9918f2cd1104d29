// "properties":{"solid":true} becomes "properties":[{"name":"solid","value":true}]; "tiles":{"3":{}} and
// "tileproperties":{"3":{"solid":true}} become "tiles":[{"id":3,"properties":[...]}].
#include "tiled_old_json.h"

#include <charconv>
#include <map>

namespace talus {
namespace {

bool is_object(const Json& owner, const char* key) {
  const auto found = owner.find(key);
  return found != owner.end() && found->is_object();
}

Json list_of_properties(const Json& properties) {
  Json list = Json::array();
  for (auto it = properties.begin(); it != properties.end(); ++it)
    list.push_back({{"name", it.key()}, {"value", it.value()}});
  return list;
}

void modernise_properties(Json& owner) {
  if (!owner.is_object() || !is_object(owner, "properties")) return;
  owner["properties"] = list_of_properties(owner["properties"]);
  owner.erase("propertytypes");
}

// Calls use(entry) for each value of a list that may be missing.
template <class Use>
void for_values(Json& owner, const char* key, Use use) {
  const auto list = owner.is_object() ? owner.find(key) : owner.end();
  if (list == owner.end() || !list->is_array()) return;
  for (Json& entry : *list) use(entry);
}

void modernise_layer(Json& layer) {
  modernise_properties(layer);
  for_values(layer, "objects", modernise_properties);
  for_values(layer, "layers", modernise_layer);
}

// A text that is no number stays one, which the reader reports.
Json id_of(const std::string& text) {
  int id = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, problem] = std::from_chars(text.data(), end, id);
  return problem == std::errc() && stopped == end ? Json(id) : Json(text);
}

void modernise_tileset(Json& tileset) {
  modernise_properties(tileset);
  if (!tileset.is_object()) return;
  const bool has_properties = is_object(tileset, "tileproperties");
  if (is_object(tileset, "tiles") || (has_properties && !tileset.contains("tiles"))) {
    Json tiles = tileset.value("tiles", Json::object());
    if (has_properties) {
      for (auto it = tileset["tileproperties"].begin(); it != tileset["tileproperties"].end(); ++it) {
        Json& tile = tiles[it.key()];
        if (tile.is_null()) tile = Json::object();
        if (tile.is_object()) tile["properties"] = it.value();
      }
    }
    Json list = Json::array();
    for (auto it = tiles.begin(); it != tiles.end(); ++it) {
      if (it.value().is_object()) it.value()["id"] = id_of(it.key());
      list.push_back(it.value());
    }
    tileset["tiles"] = std::move(list);
    tileset.erase("tileproperties");
    tileset.erase("tilepropertytypes");
  }
  for_values(tileset, "tiles", [](Json& tile) {
    modernise_properties(tile);
    if (tile.is_object() && is_object(tile, "objectgroup")) modernise_layer(tile["objectgroup"]);
  });
}

}  // namespace

void modernise_tiled_json(Json& json) {
  if (!json.is_object()) return;
  if (json.contains("tilesets")) modernise_properties(json);
  for_values(json, "tilesets", modernise_tileset);
  for_values(json, "layers", modernise_layer);
  const bool is_map = json.contains("layers") || json.contains("tilesets");
  if (!is_map && json.contains("tilewidth")) {
    if (!json.contains("type")) json["type"] = "tileset";
    modernise_tileset(json);
  }
  if (is_object(json, "object")) modernise_properties(json["object"]);
}

}  // namespace talus
