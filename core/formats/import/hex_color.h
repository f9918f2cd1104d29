// Colours in the files of other programs.
#pragma once

#include <optional>
#include <string_view>
#include <utility>

#include <talus/level/tileset.h>

namespace talus {

// The colour of "#1a1c2c", also without "#"; nothing for other texts.
std::optional<Rgb> color_of_hex(std::string_view text);

// The colour and the opacity, 0..1, of a tint as Tiled writes it: "#RRGGBB", or "#AARRGGBB". Other texts stay
// as they are, with 1. The text must outlive the result.
std::pair<std::string_view, double> split_tint(std::string_view text);

}  // namespace talus
