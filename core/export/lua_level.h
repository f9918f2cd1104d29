// A level as a table of Lua: what the runtime in assets/runtime is for.
//
// The table, all lengths in px:
//   width, height     cells
//   tiles             width * height tile numbers, row by row
//   shapes            by tile number: kind ("solid", "slope", "profile"), and, where they are not so, side
//                     ("floor"), one_way (false), tiles (1, in width); heights, of slopes and profiles
//   balls             by tile number: true where a tile of the map is a ball
//   curves            kind, faces ("up", "down", "both") and the numbers of
//   core/include/talus/collision/shape.h spawns            kind, name, x, y, w, h, vx, vy, foot ("box",
//   "centre") tuning            of exact, player, and what they share with the article, by key parts of the
//   runtime, that the level needs (lua_parts.h)
#pragma once

#include <string>

#include <talus/level/level.h>
#include "lua_runtime.h"

namespace talus {

// "return {...}", numbers as the shortest decimals that read back as the same doubles. What cannot be used
// (see lint) is left out, as the solver leaves it out. readable: a row of the map, a shape, a curve, a body
// and a number of the tuning a line; small: without tiles and parts, as a cart has the map itself.
std::string lua_level(const Level& level, LuaForm form = LuaForm::readable, const Progress& progress = {});

}  // namespace talus
