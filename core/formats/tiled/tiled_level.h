// Makes a level from a map of Tiled.
#pragma once

#include <vector>

#include "tiled_tiles.h"

namespace talus {

// Where the bodies, curves and objects of a level come from in the map that it was made of.
struct TiledSources {
  struct Place {
    int layer = 0;  // among the layers of objects of the map, from 0
    int index = 0;  // among its objects
    friend bool operator==(const Place&, const Place&) = default;
  };
  struct Layer {
    int layer = 0;
    std::vector<int> objects;  // by object of the level's layer, its index
  };
  std::vector<Place> spawns;  // by body of the level
  std::vector<Place> curves;  // by curve; those of one object follow each other
  std::vector<Layer> layers;  // by layer of objects of the level
};

// pictures: one for each tileset of the map. What the level cannot hold is added to `drops`. It is an error
// if the level cannot be made without a choice (see ImportChoices), or if the map's own `talus_level` cannot
// be read.
//
// Flags: the int `flags`, then each true bool with the name of a flag (tiled_flag_names). Other true bools
// name a flag that the same tiles have by number, or else one that nothing is known about. Shapes: the first
// outline of a tile that tile_shape_of knows, or else what comes nearest. It is one-way if `shape_one_way` is
// true or, without that property, `one_way` of the outline. `collidable` without an outline is a solid tile.
// The level's origin gets its layer and its frame. If the picture has up to 16 colours, they become the
// palette. progress: receives how much of the level is made. sources: receives where objects come from; may
// be null.
FormatResult<Level> level_of_tiled(const TiledMap& map, const TiledPictures& pictures,
                                   const ImportChoices& choices, ImportDrops& drops,
                                   const Progress& progress = {}, TiledSources* sources = nullptr);

}  // namespace talus
