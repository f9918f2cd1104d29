// The cells of a level, its layers of tiles, and how layers look, in native levels (see native.h).
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <talus/level/level.h>
#include <talus/level/progress.h>
#include "../text/json_text.h"
#include "native_color.h"
#include "native_members.h"

namespace talus {

// "must be [x, y], each from -100 to 100".
std::string pair_text(double most);
bool is_pair_within(Vec2 pair, double most);
void take_pair(MemberTaker& take, const char* key, double most, Vec2& value);

// The members that say how a layer of tiles or of objects, or a group of them, looks.
template <class Layer>
void take_looks(MemberTaker& take, Layer& layer) {
  take.optional("visible", layer.visible);
  take.optional("locked", layer.locked);
  take.ranged("opacity", 0, 1, "", layer.opacity);
  take_pair(take, "offset", kMaxLayerOffset, layer.offset);
  take_pair(take, "parallax", kMaxParallax, layer.parallax);
  take.member("tint", [&](const Json& tint) {
    const auto color = color_of(tint);
    if (!color) return take.fail("tint", kColorText);
    layer.tint = *color;
  });
}

// Whether they can be written.
template <class Layer>
FormatResult<void> check_looks(const Layer& layer, const std::string& path) {
  const auto wrong = [&](const char* key, std::string message) {
    return tl::unexpected(FormatError{"key " + path + key, std::move(message)});
  };
  if (!(layer.opacity >= 0 && layer.opacity <= 1)) return wrong(".opacity", range_text(0, 1, ""));
  if (!is_pair_within(layer.offset, kMaxLayerOffset)) return wrong(".offset", pair_text(kMaxLayerOffset));
  if (!is_pair_within(layer.parallax, kMaxParallax)) return wrong(".parallax", pair_text(kMaxParallax));
  return {};
}

// Writes those that are not as usual.
template <class Layer>
void put_looks(const Layer& layer, Json& json) {
  const Layer usual;
  MemberPutter put(json);
  if (layer.visible != usual.visible) json["visible"] = layer.visible;
  if (layer.locked != usual.locked) json["locked"] = layer.locked;
  if (layer.opacity != usual.opacity) put("opacity", layer.opacity);
  if (layer.offset != usual.offset) put("offset", layer.offset);
  if (layer.parallax != usual.parallax) put("parallax", layer.parallax);
  if (layer.tint != usual.tint) json["tint"] = text_of(layer.tint);
}

// Reads rows of cells into the map's size and tiles of a level; rows and cells that are missing have tile 0.
// key: of the rows, for messages; row: what a row is called, "map row ".
FormatResult<std::vector<TileNumber>> read_rows(const Json& rows, const std::string& key,
                                                const std::string& row, const Level& level,
                                                const Progress& progress);
// The rows of cells, without what is 0 at the ends.
Json json_of_rows(const std::vector<TileNumber>& cells, const Level& level);

// Puts a list of layers into a level, whose map has its size and whose tiles are known. The first layer of
// ground is the chosen one, or the first of all.
FormatResult<void> take_layers(Json& list, Level& level, const Progress& progress);
// The layers of a level as a list, which is empty if they are plain (see TileLayers) and have no name.
FormatResult<Json> json_of_layers(const Level& level);

}  // namespace talus
