// A level with several layers of tiles, made one for formats that have one.
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
// all layers that are ground. A cell with tiles of several layers, or with a tile that its layer changes,
// gets a tile of its own, behind the others. An error if there would be more than kMaxTiles tiles, or a
// picture of them that is too large.
FormatResult<FlatLevel> flat_level(const Level& level);

}  // namespace talus
