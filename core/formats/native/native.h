// Talus's own levels, `.talus.json`: JSON that people can read, and that diffs row by row.
//
//   "talus"        version of the file: 7 if it has groups of layers; else 6 if it has flags above 7, turned
//                  tiles, notes of tiles, pictures besides the sheet's, or objects that are hidden or have
//                  other anchors; else 5 if it has tilesets or layers of objects; else 4 if it has layers;
//                  else 3 if its sheet of tiles does not have 16 columns of 256 tiles, or has a picture, or a
//                  shape is a polygon or a group; else 2 if its tiles do not have 8x8 px; else 1. Older
//                  versions of Talus could not read it. A newer version is refused. This is the only key that
//                  must be there.
//   "palette"      16 colours "rrggbb". Default: Sweetie 16.
//   "flag_names"   up to 32 strings, by flag; "" for a flag without a name. Default: no names.
//   "flag_fields"  numbers over several flags: "name" (""); "first", the flag of the lowest bit, 0..30;
//                  "bits", 2..8; "values", up to 2^bits names of the values from 0, "" for a value without
//                  a name (no names). No two fields share a flag. Default: no fields.
//   "roles"        which flag, 0..31 or null for no flag, is "solid" (0), "up_slope" (2), "down_slope" (3),
//                  "ball" (1), "one_way" (null), "ceiling" (null).
//   "flag_shapes"  by flag "0".."31": the shape that the flag stands for, as in "tile_shapes".
//   "tuning"       "solver", "article", "bump" or "exact"; the numbers of level/tuning.h by their keys,
//                  units and ranges; and objects "exact" and "player" with the numbers of these groups,
//                  each written only if a number in it differs from its default.
//   "spawns"       bodies placed by hand: "name" (""); "x", "y" in px (0) and "vx", "vy" in px/frame (0),
//                  each within 100 million; "kind", a word of level/body_kind_list.cpp ("ball"); "size",
//                  [width, height], each 1/256..1024 px, and "foot", "box" or "centre" (default: by kind);
//                  "picture", {"stand": [tile, frames], "run": ..., "jump": ..., "fall": ..., "size":
//                  [columns, rows] of a frame in tiles ([1, 1]), "steps" of a frame (6)}.
//   "curves"       curves free of the grid: "name" (""); "faces", "up", "down" or "both" ("up"); "conveyor",
//                  px/frame, -64..64 (0); "kind", "segment", "arc", "parabola", "cubic", "sine" or
//                  "polyline"; and the members of the struct of that name in collision/shape.h, with points
//                  as [x, y]. All are needed except "upper" (true). The ends lie on the map.
//   "brushes"      up to 1000 named brushes: "name" (""), up to 1000 bytes; "random", whether each cell
//                  takes a random tile of the brush (false); "rows", 1..256 rows of one length, 1..256
//                  cells, as in the map; "turns", rows as in the map.
//   "auto_tiles"   which tile, not 0, plays which part of painted ground, by the names of the parts in
//                  level/auto_tiles.h ("inside", "slope_up", ...). Default: no tiles.
//   "animations"   by tile number, from "0": what the tile shows in play, a list of [tile, ms], each frame
//                  1 to 60000 ms, and up to 65536 frames in all. Default: each tile shows itself.
//   "tile_notes"   by tile number, from "0": "class" (""); "probability", its weight among tiles that are
//                  chosen at random, 0..1000000 (1); "properties", an object of what its user wrote there;
//                  16777216 bytes of classes and properties in all. Default: no notes.
//   "exports"      up to 100 presets of exports: "name" (""); "to", the id of an exporter (""), kept if it
//                  is unknown; "path" of the file or folder, with '/', absolute or relative to the folder
//                  of the level's file (""); "parts", those of the Lua runtime besides those that the level
//                  uses (""), as in "players, pairs"; each up to 4096 bytes; "on_save", whether the editor
//                  exports it whenever it saves the level (false). Default: no presets.
//   "tile_shapes"  by tile number, from "0": "kind", "solid", "slope", "profile" (default: the flags
//                  give the shape); "side", "floor" or "ceiling" ("floor"); "one_way" (false); "tiles",
//                  1..8 (1); "heights", a list of numbers: 2 for a slope, 3 to 8 times the tile's width and
//                  one for a profile; each 0 px to 8 times the tile's height. Or "polygon", with "points", a
//                  list of 3..256 points [x, y] in px from the tile's top left, none further than 8 tiles
//                  from it, and no two sides that meet but neighbours; or "group", with "parts", 1..64 shapes
//                  that are no groups, with up to 1024 points in all, and without other members but
//                  "conveyor". Each may have "conveyor", px/frame, -64..64 (0); without "kind" it makes
//                  the shape that the flags give a conveyor, and there has to be one.
//   "tiles"        by tile number, from "0": "flags", a list of the flags that are set (default: no
//                  flags), and "pixels", eight rows of eight hexadecimal palette indices, "." for 0
//                  (default: all 0). Blank tiles are left out.
//   "sprites"      the same for the images that are not on the map.
//   "sheet_size"   [columns, tiles] of the sheet of tiles: 1..2048 columns, 1..65536 tiles, at most
//                  2048 rows. Default: [16, 256]. With more than 256 tiles each cell has four digits.
//   "picture"      how the tiles look in true colour: lines of Base64, together a PNG with the tiles at their
//                  places on the sheet, each as large as a cell. Default: "pixels" say how they look.
//   "tilesets"     up to 1024 parts of the sheet of tiles, in the order of their tiles: "name" (""); "first",
//                  the tile in the top left corner; "count", the numbers from there to the last tile;
//                  "columns", the tiles in a row. No two share a number. "image", the path of a PNG below the
//                  folder of the file, with '/': it has the tiles' pixels, which are not stored then;
//                  "tile_size", [width, height] of a tile in it, 1..256 px each ([8, 8]); "spacing" between
//                  its tiles and "margin" around them, 0..1024 px (0); "offset", [x, y] in px, by which tiles
//                  are shown right of and below their places, each within 1024 ([0, 0]). Default: no
//                  tilesets.
//   "pictures"     pictures in true colour, each as lines of Base64 with a PNG, up to 33554432 px in all.
//                  Parts of them are named by "picture", its number in the list; "rect", [x, y, width,
//                  height] in px of the picture (all of it); "shift", [x, y] in px of the picture, by which
//                  it is drawn right of and below its place, each within 1024 ([0, 0]); "keeps_ratio",
//                  whether it is as large as fits its place, or else fills it (false); "swaps_axes", then
//                  "mirrors_x" and "mirrors_y", how it is turned (false).
//   "large_tiles"  by tile number, from "0": the part of a picture that the tile is drawn by, and "size",
//                  [width, height] in px, each 1..4096, of its place, whose bottom left corner is the cell's.
//   "tile_size"    [width, height] of the cells of the map, 1..256 px each. Default: [8, 8].
//   "map"          "width" (240) and "height" (136), 1..2097152 cells each, 16777216 cells in all, and
//                  at most 16777216 px each; "rows", from the top: two hexadecimal digits for each cell, ".."
//                  for tile 0. Empty cells at the end of a row and empty rows at the end are left out.
//                  "turns", rows of a digit for each cell: how the tile is turned, the sum of 1 for Tiled's
//                  diagonal flip, which comes first, 2 if top and bottom change places, and 4 for left and
//                  right; "." for a tile that is not turned, also at the end of a row. Default: none is.
//   "layers"       1..100 layers of tiles, from the back to the front, with up to 67108864 cells in all:
//                  "name" (""); "ground", whether its tiles are ground and bodies (true); "visible" (true);
//                  "locked" (false); "opacity", 0..1 (1); "offset", [x, y] in px, of its picture, each within
//                  1000000 ([0, 0]); "parallax", [x, y], each within 100 ([1, 1]); "tint", a colour "rrggbb"
//                  that its own are multiplied by ("ffffff"); "rows", as those of "map", which has none then,
//                  or, for a map of more than 1048576 cells, "packed", lines of Base64 with a zlib stream of
//                  the numbers of all cells, the low byte first; "turns", as those of "map", or, with
//                  "packed", "packed_turns", a stream of a byte for each cell. Default: one layer with the
//                  rows of "map".
//   "groups"       up to 4096 groups of layers, each before those in it: "name" (""); "group", the number of
//                  the group that it is in; "visible", "locked", "opacity", "offset", "parallax" and "tint"
//                  as in "layers", which join those of its layers. A layer in one of them, also of "objects",
//                  has "group", the number of the group, from 0. Default: no groups.
//   "render_order" in which order the cells of a layer are drawn: "right-down", "right-up", "left-down" or
//                  "left-up" ("right-down").
//   "objects"      layers of objects and of pictures, from the back to the front, which lie beside those of
//                  tiles: "name" (""); "ground", whether areas and lines among them are ground (false);
//                  "visible", "locked", "opacity", "offset", "parallax" and "tint" as in "layers", but the
//                  offset moves its ground, too; "place", how many layers of tiles are behind it (all);
//                  "by_y", whether objects are drawn in the order of their y (false); "image", of a layer of
//                  a picture: a part of a picture, its "path" (""), "repeats_x" and "repeats_y" (false);
//                  "objects", a list: "form", "box", "ellipse", "polygon", "polyline", "tile" or "other"
//                  ("box"); "name" (""); "class" (""); "x", "y", px; "width", "height", px (0); "rotation",
//                  degrees clockwise about [x, y] (0); "points", of polygons and polylines, [x, y] in px from
//                  there; "one_way" (false); "visible" (true); "tile", of a tile, its number in the map that
//                  it came from, the part of a picture that it shows, and "anchor", [x, y], where its
//                  position is in its box, shares of its size, each 0..1 ([0, 1]); "properties", an object of
//                  what its user wrote there. Default: none.
//   "cart"         the rest of the cart that the level came from (see native_cart.h). Default: no cart.
//
// With the member "companion" a file is not a level, but what a cart's level has beyond the cart (see
// companion.h).
//
// Unknown keys are kept, in every object except the chunks and lines of "cart", which a newer version cannot
// extend. A value outside of its range, or of another type, is an error with its place; so is a shape or
// curve that cannot be used (see problem_of in collision/shape.h and level/level.h). What a reader would
// refuse is not written. Keys that came after the first version are written only if they are not the default,
// so that older files keep their bytes.
#pragma once

#include <talus/formats/format.h>

namespace talus {

inline constexpr int kNativeVersion = 7;   // of levels with groups of layers
inline constexpr int kNoteVersion = 6;     // of levels without, but with what "talus" says above
inline constexpr int kTilesetVersion = 5;  // of levels without, but with tilesets or layers of objects
inline constexpr int kLayerVersion = 4;    // of levels without, but with layers of tiles
// Of levels without all of these, but with another sheet, a picture in true colour, polygons or groups.
inline constexpr int kSheetVersion = 3;
inline constexpr int kTileSizeVersion = 2;  // of levels with none of that, but tiles of other than 8x8 px

bool accepts_native(std::string_view bytes, const FormatContext& context);
FormatResult<Level> read_native(std::string_view bytes, const FormatContext& context);
FormatResult<WrittenLevel> write_native(const Level& level, const FormatContext& context);

}  // namespace talus
