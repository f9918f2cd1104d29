// Picture: draws Dear ImGui's current draw data into memory and writes it as a PNG.
#pragma once

#include <cstdint>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "formats/files/atomic_file.h"

namespace talus {

struct Picture {
  int width = 0, height = 0;       // px
  std::vector<std::uint8_t> rgba;  // from the top left, row by row
};

// Draws what was last rendered, at the size of the current display; ImGui::Render() must have been called. A
// size that the graphics driver cannot draw is an error.
tl::expected<Picture, std::string> draw_picture();

tl::expected<void, std::string> write_png(const Picture& picture, const std::string& path,
                                          InPlace in_place = InPlace::follow_links);

}  // namespace talus
