// How the tiles in cells are turned, in native levels (see native.h).
#pragma once

#include <optional>
#include <string>

#include <talus/level/level.h>
#include "../text/json_text.h"

namespace talus {

// Turns the cells as the text of a reader says: rows of digits, one a cell, or a packed stream of bytes.
// width: cells of a row. path: of the object that has them, for messages.
FormatResult<void> take_turn_rows(const Json& rows, const std::string& path, int width, MapCells& cells);
FormatResult<void> take_packed_turns(const Json& lines, const std::string& path, MapCells& cells);

// The members "turns" and "packed_turns" of the object that has the cells; neither if nothing is turned.
// is_packed: which of the two.
void put_turns(const MapCells& cells, int width, bool is_packed, Json& json);

// A digit of a row, "." for a tile that is not turned. Nothing for other characters.
char digit_of_turn(TileTurn turn);
std::optional<TileTurn> turn_of_digit(char digit);

// Whether a level has turned tiles, on its map or in brushes, which came with version 6.
bool has_turned_tiles(const Level& level);

}  // namespace talus
