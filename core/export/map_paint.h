// The whole map with all of its layers as pixels.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <talus/level/level.h>

namespace talus {

// Four bytes for each px of some rows of px of the map, row by row: red, green, blue and opacity of the
// visible layers as the editor shows them while nothing moves, over nothing, or over colour 0 in a level
// without a background of its own. top: the first row. goes_on: asked with 0..1 now and then; the pixels are
// not complete if it says no.
std::vector<std::uint8_t> map_pixels(const Level& level, int top, int rows,
                                     const std::function<bool(double)>& goes_on);

}  // namespace talus
