// Which layers and groups a map of Tiled gets when a level is saved into it.
#pragma once

#include <vector>

#include <talus/level/level.h>
#include "tiled_edits.h"
#include "tiled_object_writer.h"

namespace talus {

// What is known of the layers of a level and of the map that it came from.
struct TiledLayerSources {
  std::vector<int> tiles;  // by layer of tiles of the level, its number in the map; -1: new; empty: none is
  TiledObjectEdits objects;
  // By layer of tiles and by layer of objects of the map, whether the opened level has it.
  std::vector<bool> opened_tiles, opened_objects;
};

struct TiledArrangement {
  TiledLayerTree tree;
  bool is_new = false;  // whether the map has another one
  // Their numbers in that tree among those of their kind; -1: it lacks them.
  std::vector<int> objects;  // by place in the order of the layers of objects
  std::vector<int> groups;   // by group of the level
};

// map: as it is. Layers of the map that the opened level does not have, such as those of bodies, and groups
// of none but those, stay in front of the layer of tiles or group that is behind them. A group of the level
// is that of the map with which it has most layers in common; a name in common counts more.
TiledArrangement arrange_layers(const Level& level, const TiledLayerTree& map,
                                const TiledLayerSources& sources);

// Whether the map's own layers of tiles stand in it as in the map.
bool has_tiles_in_order(const TiledLayerTree& tree);

}  // namespace talus
