// A level as a map of Tiled, for the writers of its three forms.
#pragma once

#include "../formats/tiled/tiled_map.h"
#include "exporter.h"

namespace talus {

// The map with one tileset whose picture is NAME-tiles.png, as tiled_map.h tells, and nothing of the base but
// objects and cells: no property `talus_level`. Cells have tile numbers + 1, or 0 for a blank tile 0.
TiledMap tiled_map_of(const ExportRequest& request);
// `flags` and the bools of the flags that are set; nothing of a tile without flags.
TiledProperties tiled_flag_properties(const Level& level, std::uint8_t flags);
// Whether cells with tile 0 are empty: it has neither colours nor flags nor a shape.
bool is_tile_0_blank(const Level& level);

// The files: the map's text, and the picture of the tileset's tiles, which are those of the level and then
// more of them. With "-" as name the picture is not to be had, and `dropped` says so.
Exported tiled_files(const ExportRequest& request, std::string text, std::string picture,
                     std::vector<std::string> dropped);

// The text of a map as Tiled's JSON and as its Lua.
std::string tiled_json_text(const TiledMap& map);
std::string tiled_lua_text(const TiledMap& map);

}  // namespace talus
