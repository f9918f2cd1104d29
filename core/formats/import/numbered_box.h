// Numbered boxes, which stand for tiles whose picture is missing.
#pragma once

#include <talus/level/level.h>

namespace talus {

// The colour at (x, y), 0..7, of a box with the last two digits of the number; the hundreds choose its
// colour. All colours are of default_palette(). number: at least 0.
Rgb color_of_box(int number, int x, int y);

}  // namespace talus
