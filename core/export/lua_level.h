// A level as a Lua table, for the runtime in assets/runtime.
//
// The table, all lengths in px:
//   width, height     cells
//   background        what is seen where nothing is drawn: red, green, blue and opacity, 0..255; only if that
//   is
//                     something, and not in a small table
//   tiles             width * height tile numbers, row by row
//   shapes            by tile number: kind ("solid", "slope", "profile"); unless default: side ("floor"),
//                     one_way (false), conveyor (0), tiles (width, 1); heights, for slopes and profiles
//   balls             by tile number, of tiles that are bodies: their kind, such as "ball"
//   flags             by the name of a flag, the tiles that have it: true by tile number; only if flags have
//                     names, and not in a small table
//   roles             by the role, such as "solid", the number of its flag; not in a small table
//   curves            kind, faces ("up", "down", "both"), conveyor (0) and the numbers in
//                     talus/collision/shape.h
//   tile_flags        by tile number, the flags of tiles that have any: bit n is flag n
//   flag_names        by the number of the flag
//   tilesets          name, first (tile number), count, columns; path of its picture, if it is a file
//   objects           of all layers, from the back to the front: layer (its name), form ("box", "point",
//                     "ellipse", "polygon", "polyline", "tile", "other"), class, name, x, y (of the top left
//                     corner of its box, on the map), w, h, properties; unless default: rotation (0, degrees
//                     clockwise about x, y), points (of polygons and polylines: x and y on the map in turn,
//                     rotated), tile (of a map of Tiled), turn (0, as in turns), ground (false: its layer is
//                     none), one_way, hidden (false)
//   animations        by tile number, the tiles that it shows, and for how many ms, in turn
//   tile_notes        by tile number, what its user wrote: class, probability (1), properties
//   layer_name        of the only layer, if there are no layers and it has one
//   spawns            kind, name, x, y, w, h, vx, vy, foot ("box", "centre"); only if the body has a picture,
//                     picture: sheet ("tiles"; "sprites"), columns, rows (tiles of a frame), steps (for which
//                     it is shown), and for each of stand, run, jump and fall the tile, or sprite, of the
//                     first frame and the number of frames
//   kinds             by their word, all kinds of bodies: rule ("fall", "run"), w, h, foot, look ("tile",
//                     "figure"); takes_keys (false)
//   tuning            of exact, player, and what they share with the article, by key
//   parts             of the runtime, that the level needs (lua_parts.h)
//   layers            only if there are several, or one that is not drawn as it is: what is drawn, from the
//                     back to the front: name, tiles (as above); unless default: opacity (1), x, y (0, the
//                     offset), parallax_x, parallax_y (1), tint ({255, 255, 255}), hidden (false), ground
//                     (false: only drawn). Instead of tiles: parts, a list of parts of pictures; or image,
//                     such a part, with repeats_x, repeats_y (false)
//   pictures          only if tiles, objects or layers show them: the name of their file. A part of it is a
//                     list: x, y, w, h in the file, the x and y of its corner on the map, and the x and y by
//                     which a px to the right and a px down in it lead on the map
//   large_tiles       only with pictures: by tile number, the part that is drawn for it, from the corner of
//                     its cell
//   turned_large_tiles  only with turned ones: by tile number, and by the sum of the bits of its turn, as in
//                     turns, the same part where a cell turns it
//   render_order      only with pictures: "right-up", "left-down", "left-up"; default "right-down"
#pragma once

#include <string>

#include <talus/level/level.h>
#include "exporter.h"
#include "lua_pictures.h"
#include "lua_runtime.h"

namespace talus {

// "return {...}", with numbers as the shortest decimals that read back as the same doubles. Unusable shapes
// (see lint) are left out, as the solver ignores them. readable: one line for each row of the map, shape,
// curve, body and number of the tuning. small: without tiles, flags and parts, as a cart has the map itself,
// and without what the runtime takes anyway for a spawn: size and foot of its kind, no velocity. layered: the
// level that has the layers, as ExportRequest::layered; null: none are written. pictures: of that level;
// null: none are shown. whole: as ExportRequest::whole(), of which flags, tilesets and objects are; null:
// layered or level where the text is readable, none where it is small.
std::string lua_level(const Level& level, LuaForm form = LuaForm::readable, const Progress& progress = {},
                      const Level* layered = nullptr, const LuaPictures* pictures = nullptr,
                      const Level* whole = nullptr);

// Adds the files of a level that templates/pictures.lua draws: level.lua, sheet.png and, if there are any,
// pictures.png; and sprites.png, if bodies show sprites.
void add_drawn_level(const ExportRequest& request, Exported& out);

// Adds files of Lua, by their paths in the folder of assets; those of templates are starters.
FormatResult<void> add_assets(const ExportRequest& request, std::initializer_list<std::string> assets,
                              Exported& out);

}  // namespace talus
