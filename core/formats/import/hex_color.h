// Colours in the files of other programs.
#pragma once

#include <optional>
#include <string_view>

#include <talus/level/tileset.h>

namespace talus {

// The colour of "#1a1c2c", also without "#"; nothing for other texts.
std::optional<Rgb> color_of_hex(std::string_view text);

}  // namespace talus
