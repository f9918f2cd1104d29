// PixelColor: the colour of a pixel, whether its sheet has 16 colours or true colour.
#pragma once

#include <bit>
#include <cstdint>

#include <talus/level/tileset.h>

namespace talus {

// Of a sheet in 16 colours, the index, 0..15; of one in true colour, the bits of an Rgba.
using PixelColor = std::int32_t;

constexpr Rgba rgba_of(PixelColor color) { return std::bit_cast<Rgba>(color); }
// What is clear has no other colour: there is one eraser.
constexpr PixelColor pixel_color(Rgba color) { return color.a == 0 ? 0 : std::bit_cast<PixelColor>(color); }

}  // namespace talus
