// Reads maps and tilesets of Tiled from JSON: from TMJ and TSJ, or from the JSON that tiled_xml.h makes of
// TMX and TSX.
#pragma once

#include "../text/json_text.h"
#include "tiled_map.h"
#include "tiled_templates.h"

namespace talus {

// An error is anything that cannot become a level: another orientation than orthogonal, tiles of another size
// than 1 to 256 px a side, data that does not fit the size. What is left out is
// added to `drops`. An infinite map becomes the part around its tiles. A tileset in a file of its own has
// only `source`. progress: receives how many of the layers are read, and may stop the work, which is an
// error.
// find_template: finds the templates that objects of the map name. A template that cannot be found is
// dropped. frame: see join_chunks().
FormatResult<TiledMap> read_tiled_map(const Json& json, const FindTiledTemplate& find_template,
                                      const TiledFrame* frame, ImportDrops& drops,
                                      const Progress& progress = {});
FormatResult<TiledTileset> read_tiled_tileset(const Json& json, const FindTiledTemplate& find_template,
                                              ImportDrops& drops);

}  // namespace talus
