// The colours of a picture in true colour, as a palette to choose from.
#pragma once

#include <string>
#include <vector>

#include "sprite_area.h"

namespace talus {

inline constexpr std::size_t kMaxPictureColors = 40;

// The most used colours of an area in true colour and of the tileset that it belongs to, or of the whole
// sheet; those of the area count more. Of colours that hardly differ, the most used one stands for
// all, if there are more than kMaxPictureColors. Greys come first, then the colours by hue, each from dark
// to light. Empty for a sheet in 16 colours. Looks at some of the pixels of a large sheet.
std::vector<Rgba> picture_palette(const Level& level, const SpriteArea& area);

std::string hex_text(Rgba color);  // "#f4f4f4", and with opacity "#f4f4f480"

}  // namespace talus
