// Objects of Tiled that are neither bodies nor curves of a level.
#pragma once

#include <optional>

#include <talus/level/object_layer.h>
#include "tiled_map.h"

namespace talus {

// The layer without its objects. It is ground if its properties say so (kTiledGroundWords), or, without
// these, if its name or its class is one of: collision, collisions, collider, colliders, solid, solids, wall,
// walls, ground, platform, platforms; in any case of letters.
ObjectLayer object_layer_of(const TiledLayer& layer);

// Chooses which layers of tiles are ground, where their properties do not say it. If the name or the class of
// any of them is one of these words, only such layers are; else all are, as in a map that Talus wrote.
void choose_tile_ground(TiledMap& map);

// How clearly the name or the class of the layer says that its tiles are ground: 0: collision, collider or
// solid; 1: wall or platform; each also in the plural; 2: ground. Nothing: it does not.
std::optional<int> rank_of_ground(const TiledLayer& layer);

// type: the class that it has, by itself or by its tile.
MapObject map_object_of(const TiledObject& object, const std::string& type);

// The counterpart, without its properties.
TiledObject tiled_object(const MapObject& object);

// Whether its numbers are within the ranges that an object of a level has.
bool is_well_placed(const MapObject& object);

}  // namespace talus
