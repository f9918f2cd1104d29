// Reading maps and tilesets of Tiled from JSON, TMJ and TSJ, or from what tiled_xml.h makes of TMX and TSX.
#pragma once

#include "../text/json_text.h"
#include "tiled_map.h"

namespace talus {

// In an object that was an element of XML, the number of its line, for errors.
inline constexpr const char* kTiledLineKey = "@line";

// An error for what no level can be made of: another orientation than orthogonal, an infinite map, tiles that
// are not 8x8 px, tilesets of many pictures, data that does not fit the size. What is left out is named in
// `drops`. Tilesets in files of their own have nothing but `source`. progress: told how many of the layers
// are read; where it says so, that is an error.
FormatResult<TiledMap> read_tiled_map(const Json& json, TiledDrops& drops, const Progress& progress = {});
FormatResult<TiledTileset> read_tiled_tileset(const Json& json, TiledDrops& drops);

}  // namespace talus
