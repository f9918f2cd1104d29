// What a companion says about the place of its level's ground, and its members moved to another place (see
// level/moved_ground.h).
#pragma once

#include <optional>

#include "../text/json_text.h"
#include "level/moved_ground.h"

namespace talus {

// {"map": [width, height], "layer": number, "marks": [[x, y, tile, turn], ...]}. Without the origin.
Json json_of_ground(const GroundPlace& place);
// The same read again; nothing if it is not what json_of_ground() gives.
std::optional<GroundPlace> ground_of_json(const Json& json);

// A map with these sides, in cells, for each of which a number that is no side of a map stands for the usual
// one; of the usual size if no map may have both.
TileMap map_with_sides(const Json& wide, const Json& high, int usual_width, int usual_height, TileSize tile);

// The list "spawns" of a native level, whose bodies go by so many px. Entries that are none stay.
void move_spawns(Json& list, Vec2 by);
// The list "objects", as above.
void move_objects(Json& layers, Vec2 by);
// The list "curves", as above. Curves whose ends are not on the map `to` then are removed; returns their
// number. from: the map that they are on. A list that cannot be read stays as it is.
int move_curves(Json& list, Vec2 by, const TileMap& from, const TileMap& to);

}  // namespace talus
