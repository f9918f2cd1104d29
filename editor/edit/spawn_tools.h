// Tools for the bodies placed by hand. Each makes an Edit and changes nothing itself.
#pragma once

#include "edit.h"

namespace talus {

Edit add_spawn(const Level& level, Spawn spawn);  // as the last one
// index: of Level::spawns (asserted).
Edit change_spawn(const Level& level, int index, Spawn spawn, std::string label);
Edit remove_spawn(const Level& level, int index);
// A copy a tile further to the right, or, where the map ends, to the left; the last spawn of the level then.
Edit duplicate_spawn(const Level& level, int index);
// What it is called on screen: its name, or its kind and its number, from 1: "player 2".
std::string title_of_spawn(const Level& level, int index);

// The last spawn whose box holds the point, px; -1: none.
int spawn_at(const Level& level, Vec2 point);

}  // namespace talus
