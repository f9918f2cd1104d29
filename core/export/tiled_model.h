// TiledMap of a level, for the writers of its three forms.
#pragma once

#include "../formats/tiled/tiled_map.h"
#include "exporter.h"

namespace talus {

// The format of the maps, and the version of Tiled that has it: Excalibur's plugin reads no map without.
inline constexpr const char *kTiledFormat = "1.10", *kTiledVersion = "1.10.2";

struct TiledExport {
  TiledMap map;
  std::vector<ObjectLayer> objects;    // of the level, as the map shows them: see ExportedLayers::level
  std::vector<ExportedFile> pictures;  // of objects and layers, beside the map
  std::vector<std::string> dropped;    // what of objects, layers and large tiles the map has not
};

// The map with a tileset whose picture is NAME-tiles.png, as tiled_map.h describes, and without the property
// `talus_level`. Cells have tile number + 1, or 0 for a blank tile 0.
TiledExport tiled_export_of(const ExportRequest& request);
// `flags`, and a bool for each flag that is set; nothing for a tile without flags.
TiledProperties tiled_flag_properties(const Level& level, FlagSet flags);
// Gives a tile of a map what a tile of the level says; of two properties of one name the map's stays.
void add_note(const TileNote& note, TiledTile& tile);
// Whether a layer is only drawn, as the bool `ground`; nothing for a layer that is ground.
TiledProperties tiled_properties(const TileLayer& looks);
// Whether cells with tile 0 are empty: tile 0 has neither colours nor flags nor a shape.
bool is_tile_0_blank(const Level& level);

// The files: the text of the map, the other pictures, and the picture with the level's tiles. For the output
// "-" there is no picture, and `dropped` says so.
Exported tiled_files(const ExportRequest& request, std::string text, std::vector<ExportedFile> pictures,
                     std::string tiles, std::vector<std::string> dropped);

// The text of a map as Tiled's JSON, and as its Lua.
std::string tiled_json_text(const TiledMap& map);
std::string tiled_lua_text(const TiledMap& map);

}  // namespace talus
