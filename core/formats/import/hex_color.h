// Colours in the files of other programs.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <talus/level/tileset.h>

namespace talus {

// The colour of "#1a1c2c", or of "#ff1a1c2c", whose first two digits are its opacity, or of "#fa0", each
// digit of which stands for two; also without "#". Nothing for other texts.
std::optional<Rgb> color_of_hex(std::string_view text);

// The same with its opacity, which is full unless it has eight digits.
std::optional<Rgba> rgba_of_hex(std::string_view text);

// The opacity, 0..1, of such a colour: 1 unless it has eight digits.
double opacity_of_hex(std::string_view text);

// "#1a1c2c", or "#801a1c2c" if it is not opaque.
std::string hex_of(Rgba color);

}  // namespace talus
