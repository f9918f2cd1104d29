// A level as a Lua table, for the runtime in assets/runtime.
//
// The table, all lengths in px:
//   width, height     cells
//   tiles             width * height tile numbers, row by row
//   shapes            by tile number: kind ("solid", "slope", "profile"); unless default: side ("floor"),
//                     one_way (false), tiles (width, 1); heights, for slopes and profiles
//   balls             by tile number, of tiles that are bodies: their kind, such as "ball"
//   curves            kind, faces ("up", "down", "both") and the numbers of talus/collision/shape.h
//   spawns            kind, name, x, y, w, h, vx, vy, foot ("box", "centre")
//   kinds             by their word, all kinds of bodies: rule ("fall", "run"), w, h, foot, look ("tile",
//                     "figure"); takes_keys (false)
//   tuning            of exact, player, and what they share with the article, by key
//   parts             of the runtime, that the level needs (lua_parts.h)
//   layers            only if there are several, or one that is not drawn as it is: what is drawn, from the
//   back to
//                     the front: name, tiles (as above); unless default: opacity (1), x, y (0, the offset),
//                     parallax_x, parallax_y (1), tint ({255, 255, 255}), hidden (false), ground (false: only
//                     drawn)
#pragma once

#include <string>

#include <talus/level/level.h>
#include "lua_runtime.h"

namespace talus {

// "return {...}", with numbers as the shortest decimals that read back as the same doubles. Unusable shapes
// (see lint) are left out, as the solver ignores them. readable: one line for each row of the map, shape,
// curve, body and number of the tuning. small: without tiles and parts, as a cart has the map itself, and
// without what the runtime takes anyway for a spawn: size and foot of its kind, no velocity.
// layered: the level that has the layers, as ExportRequest::layered; null: none are written.
std::string lua_level(const Level& level, LuaForm form = LuaForm::readable, const Progress& progress = {},
                      const Level* layered = nullptr);

}  // namespace talus
