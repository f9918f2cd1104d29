// Which objects of a map have to be changed so that they give the bodies, curves and objects of a level.
#pragma once

#include <map>
#include <string_view>
#include <vector>

#include "tiled_edits.h"
#include "tiled_level.h"

namespace talus {

struct TiledObjectEdits {
  std::vector<TiledLayerSlot> order;               // of the map's layers of objects
  std::map<int, std::vector<TiledObjectEdit>> of;  // by place in the order
  std::vector<int> layers;                         // by layer of objects of the level, its place in the order
};

// opened: the level that the map gives, with its sources. An object that gives a body or a curve keeps all
// that was not edited. New ones come where they are read in their order: before the object of the next one,
// or into the layer `bodies` or `curves`, which comes in front of all if it has to be made.
TiledObjectEdits object_edits(const Level& level, const Level& opened, const TiledMap& map,
                              const TiledSources& sources);

}  // namespace talus
