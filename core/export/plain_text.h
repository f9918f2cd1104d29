// Plain data as text: JSON, or a table of Lua, by one printer.
//
// The object that plain_json makes, and that the exporters `json` and `lua` write; lengths in px, y down:
//   width, height, tile_size   of the map in cells; of a cell, 8
//   map        height rows of width tile numbers
//   flags      tiles, sprites: 256 numbers each; bit n is flag n
//   roles      which flag means what: solid, ball, up_slope, down_slope, one_way, ceiling; those in use
//   shapes     by tile number, tiles without one left out: kind ("solid", "slope", "profile"), one_way, tiles
//              (width), and `floor`, or `ceiling` if the shape hangs from the tile's top: 8 * tiles heights,
//              measured from the tile's top downwards, in the middle of each column of pixels: x = 0.5, 1.5,
//              ... A floor of 8 or a ceiling of 0 is where the shape has no ground. A floor's ground reaches
//              down to the tile's bottom, a ceiling's up to its top; a one-way shape is its line alone. What
//              is beyond the first 8 reaches over the cells to the right.
//   polygons   the outline of all ground: hole, and points (x, y, x, y, ...), as GroundPolygon
//   lines      what stops bodies on one side alone, and free curves as lines through points, at most 1/64 px
//              off: kind ("one_way", "curve"), name, both_sides, points; as PlainLine
//   spawns     bodies placed by hand: name, kind ("ball", "player"), x, y (top left), w, h, vx, vy
//   (px/frame),
//              foot ("box", "centre")
// In Lua lists begin at 1, so that the tile at a column and row is map[row + 1][column + 1], and the flags of
// a tile flags.tiles[tile + 1]; shapes are found by the tile's number itself, in JSON as a string.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "../level/level.h"
#include "plain_data.h"
#include "../level/progress.h"

namespace talus {

using OrderedJson = nlohmann::ordered_json;  // keeps members as they were put

// One of its shapes, and one of its spawns.
OrderedJson plain_shape_json(const PlainShape& shape);
OrderedJson plain_spawn_json(const Spawn& spawn);

enum class Dialect { json, lua };

// A member of the whole a line, and of a list of lists or objects in it an entry a line; in Lua with the
// `return` before it, and, where lists are too long for LuaJIT, with a function that joins their parts.
std::string plain_text(const Level& level, Dialect dialect, const Progress& progress = {});

}  // namespace talus
