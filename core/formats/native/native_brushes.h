// The brushes and the auto-tile set in a native level, both optional:
//   "brushes": [{"name": "bush", "random": true, "rows": ["0a0b", "1a1b"]}]    tiles as in the map's rows
//   "auto_tiles": {"inside": 16, "top": 1, ...}    by the names of the parts; tiles from 1
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <talus/level/level.h>
#include "../text/json_text.h"

namespace talus {

// How many hexadecimal digits a tile has in rows of the map and of brushes: 2, or 4 if a level has more than
// 256 tiles.
std::size_t digits_of_tile(int tile_count);
// The same as a word, for messages: "two" or "four".
std::string word_of_digits(std::size_t digits);
// Appends a tile to a row; tile 0 is written as dots.
void append_tile(std::string& text, TileNumber tile, std::size_t digits);
// Reads up to four digits, or dots; nothing if another character is among them.
std::optional<TileNumber> tile_of_digits(std::string_view digits);

// Each function takes the members that it knows out of the JSON and leaves the others. An error has its place
// by key. Tiles must be less than `tile_count`.
FormatResult<std::vector<Brush>> take_brushes(Json& list, int tile_count);
FormatResult<AutoTiles> take_auto_tiles(Json& json, int tile_count);

// An empty list or set gives an empty list or object.
FormatResult<Json> json_of(const std::vector<Brush>& brushes, int tile_count);
void put_auto_tiles(const AutoTiles& tiles, Json& json);

}  // namespace talus
