// A level as a table of Lua, and the parts of the runtime that it needs: what assets/runtime/talus.lua is
// for.
//
// The table, all lengths in px:
//   width, height     cells
//   tiles             width * height tile numbers, row by row
//   shapes            by tile number: kind ("solid", "slope", "profile"), and, where they are not so, side
//                     ("floor"), one_way (false), tiles (1, in width); heights, of slopes and profiles
//   balls             by tile number: true where a tile of the map is a ball
//   curves            kind, faces ("up", "down", "both") and the numbers of core/collision/shape.h
//   spawns            kind, name, x, y, w, h, vx, vy, foot ("box", "centre")
//   tuning            of exact, player, and what they share with the article, by key
#pragma once

#include <string>
#include <vector>

#include "../level/level.h"

namespace talus {

// "return {...}", numbers as the shortest decimals that read back as the same doubles. What cannot be used
// (see lint) is left out, as the solver leaves it out. with_tiles: false where the game has the map itself.
std::string lua_level(const Level& level, bool with_tiles = true);

// The names of the runtime's parts, in the order in which they are joined, for the exact solver with what the
// level uses: slopes, curves, players, bodies that block one another. The mouse is for debugging and tests.
std::vector<std::string> lua_runtime_parts(const Level& level, bool with_mouse);

// Joins parts into one module, without their comments and what spaces Lua does not need, but for the comment
// at the head. texts: in the order of the parts; no string in them has a quote, or two hyphens after a space.
std::string join_lua_parts(const std::vector<std::string>& texts);

}  // namespace talus
