// Which tiles of the tilesets have to be changed so that they give the flags and shapes of a level.
#pragma once

#include <array>
#include <set>
#include <string>
#include <utility>

#include "tiled_content.h"
#include "tiled_edits.h"

namespace talus {

// By the path of the tileset's own file, and its number among the tilesets of the map; without a file the
// path is empty. Of a tileset's own file the number is 0.
using TiledTilesetPlace = std::pair<std::string, int>;

struct TiledTilesetEdits {
  std::map<TiledTilesetPlace, TiledTileEdits> of;
  std::set<TileNumber> tiles;  // those of the level that are written
};

// The tiles that differ from the level as the files gave it, without those that are left out and those that
// no tileset has. names: those of the flags.
TiledTilesetEdits tileset_edits(const Level& level, const TiledOrigin& origin, const TiledContent& model,
                                const std::array<std::string, kMaxFlags>& names,
                                const std::set<TileNumber>& left_out);

// The name that a flag has in the files, or gets there: that of the files, or else that of the level. Without
// `takes_new` the level's names do not count.
std::array<std::string, kMaxFlags> names_for_tiled(const Level& level, const Level& opened, bool takes_new);

}  // namespace talus
