// Tools for the bodies placed by hand. Each makes an Edit and changes nothing itself.
#pragma once

#include <talus/collision/terrain.h>
#include "level/edit.h"

namespace talus {

Edit add_spawn(const Level& level, Spawn spawn);  // appends it
// A new player that stands on the ground in the nearest column to a place, px, on the map; at the place
// itself if there is no such ground among the columns that are tried. ground: null: there is none.
Spawn player_near(const Level& level, const Terrain* ground, Vec2 place);
// index: of Level::spawns (asserted).
Edit remove_spawn(const Level& level, int index);
// Copies a spawn one tile further to the right or, if the map ends there, to the left. The copy is the last
// spawn then.
Edit duplicate_spawn(const Level& level, int index);
// The name on screen: its name, or its kind and its number from 1, "player 2".
std::string title_of_spawn(const Level& level, int index);

// Returns the last spawn whose box contains the point, px; -1 if there is none.
int spawn_at(const Level& level, Vec2 point);

}  // namespace talus
