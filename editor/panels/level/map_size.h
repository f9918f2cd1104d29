// What the dialogs about the size of a map have in common.
#pragma once

#include <string>

#include <talus/level/tile_map.h>
#include "panels/ui/ui.h"

namespace talus {

// Why there is no map of so many cells of this size, as a sentence; empty if there is one.
std::string problem_of_map_size(int width, int height, TileSize tile);
// The sizes that maps have, for the help of a field.
std::string text_of_map_limits();
inline constexpr float kMapLabel = 72;  // px at scale 1, the width of a label
// A label and a field for a whole number.
void draw_map_number(const char* name, const char* label, int& value, const std::string& help, Ui& ui);
// A line of text in a colour of the theme.
void draw_map_note(const std::string& text, std::uint32_t color);

}  // namespace talus
