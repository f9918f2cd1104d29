#include "reading_choices.h"

#include <talus/level/limits.h>
#include "ldtk/ldtk_companion.h"
#include "native/tiled_frame_json.h"

namespace talus {

std::string text_of_choices(const ImportChoices& choices) {
  Json json = Json::object();
  if (choices.layer_number > 0) json["layer"] = choices.layer_number;
  if (!choices.level.empty()) json["level"] = choices.level;
  if (choices.frame) json["frame"] = json_of_tiled_frame(*choices.frame);
  if (!choices.ldtk_tiles.empty()) json["tiles"] = choices.ldtk_tiles;
  if (choices.mapping) json["mapping"] = json_of_mapping(*choices.mapping);
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

ImportChoices choices_in(std::string_view text) {
  constexpr int kMaxNumber = 1 << 30;
  ImportChoices choices;
  const auto json = parse_json(text);
  if (!json || !json->is_object()) return choices;
  const Json layer = json->value("layer", Json()), level = json->value("level", Json()),
             tiles = json->value("tiles", Json());
  if (is_whole(layer, 1, kMaxNumber)) choices.layer_number = layer.get<int>();
  if (level.is_string()) choices.level = level.get<std::string>();
  choices.frame = tiled_frame_of_json(json->value("frame", Json()));
  if (tiles.is_array() && tiles.size() <= kMaxTiles) {
    for (const Json& tile : tiles)
      choices.ldtk_tiles.push_back(tile.is_string() ? tile.get<std::string>() : "");
  }
  if (json->contains("mapping")) choices.mapping = ldtk_mapping_in(text);
  return choices;
}

}  // namespace talus
