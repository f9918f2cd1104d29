// Words for the tiles of a level, and finding tiles by them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <talus/level/level.h>

namespace talus {

// What describes a tile, in lower case: its number, the name of its tileset ("grass", "set:grass"), its
// class ("door", "class:door"), the names, roles and numbers of its flags and the named values of its fields
// ("water", "flag:water", "flag:3"), and words of its shape.
std::vector<std::string> words_of_tile(const Level& level, TileNumber tile);
// "none", "solid", "slope", "profile", "polygon", "group", "ceiling", "one-way", each once; also those of
// parts.
std::vector<std::string> words_of_shape(const TileShape& shape);

// By tile: whether each word of the text is in it. A number finds only that tile; "flag:" before a name or a
// number finds only flags, "set:" only tilesets, "class:" only classes. Words between quotes are one:
// flag:"win zone". Upper and lower case are the same. Empty if the text has no word.
std::vector<bool> find_tiles(const Level& level, std::string_view text);

// By tile: the number of cells of all layers that have it.
std::vector<std::size_t> count_tiles(const Level& level);

}  // namespace talus
