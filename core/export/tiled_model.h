// TiledMap of a level, for the writers of its three forms.
#pragma once

#include "../formats/tiled/tiled_map.h"
#include "exporter.h"

namespace talus {

// The map with one tileset whose picture is NAME-tiles.png, as tiled_map.h describes. The base has only
// objects and cells, and no property `talus_level`. Cells have tile number + 1, or 0 for a blank tile 0.
TiledMap tiled_map_of(const ExportRequest& request);
// `flags`, and a bool for each flag that is set; nothing for a tile without flags.
TiledProperties tiled_flag_properties(const Level& level, std::uint8_t flags);
// Whether a layer is only drawn, as the bool `ground`; nothing for a layer that is ground.
TiledProperties tiled_properties(const TileLayer& looks);
// Whether cells with tile 0 are empty: tile 0 has neither colours nor flags nor a shape.
bool is_tile_0_blank(const Level& level);

// The files: the text of the map, and the picture with the level's tiles and those added to them. For the
// output "-" there is no picture, and `dropped` says so.
Exported tiled_files(const ExportRequest& request, std::string text, std::string picture,
                     std::vector<std::string> dropped);

// The text of a map as Tiled's JSON, and as its Lua.
std::string tiled_json_text(const TiledMap& map);
std::string tiled_lua_text(const TiledMap& map);

}  // namespace talus
