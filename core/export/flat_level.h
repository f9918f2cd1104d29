// A level with several layers of tiles, or with turned ones, for formats that have one layer, and no turns or
// only mirrored tiles.
#pragma once

#include <string>
#include <vector>

#include <talus/formats/format.h>

namespace talus {

struct FlatLevel {
  Level level;
  std::vector<std::string> dropped;  // what of the layers is not in it, one phrase each
};

// The level with one layer of tiles. It shows what the visible layers show together, and has the ground of
// all layers that are ground. A cell with tiles of several layers, or with a tile that its layer changes or
// that is turned, gets a tile of its own, behind the others. keeps_mirrors: whether a cell may mirror its
// tile, so that only those with a quarter turn get tiles of their own. An error if there would be more than
// kMaxTiles tiles, or a picture of them that is too large.
FormatResult<FlatLevel> flat_level(const Level& level, bool keeps_mirrors = false);

// The level with its tiles behind the 256 of a cart in the places of blank ones that nothing uses; unchanged
// if these are too few.
Level with_cart_tiles(Level level);

}  // namespace talus
