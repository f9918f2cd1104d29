// The cells of a level, and its layers of tiles, in native levels (see native.h).
#pragma once

#include <string>
#include <vector>

#include <talus/level/level.h>
#include <talus/level/progress.h>
#include "../text/json_text.h"

namespace talus {

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
