// Objects of Tiled that are neither bodies nor curves of a level.
#pragma once

#include <talus/level/object_layer.h>
#include "tiled_map.h"

namespace talus {

// The layer without its objects. It is ground if one of its properties `ground`, `solid` and `collidable` is
// true, or, without these, if its name or its class is one of: collision, collisions, collider, colliders,
// solid, solids, wall, walls, ground, platform, platforms; in any case of letters.
ObjectLayer object_layer_of(const TiledLayer& layer);

// type: the class that it has, by itself or by its tile.
MapObject map_object_of(const TiledObject& object, const std::string& type);

// The counterpart, without its properties.
TiledObject tiled_object(const MapObject& object);

// Whether its numbers are within the ranges that an object of a level has.
bool is_well_placed(const MapObject& object);

}  // namespace talus
