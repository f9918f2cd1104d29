// The squares that are seen through what is not opaque.
#pragma once

#include <imgui.h>

#include "edit/pixel_color.h"

namespace talus {

// Squares of `side` px of the screen, where the list draws and the rectangle is.
void draw_checkered(ImDrawList& list, ImVec2 from, ImVec2 to, float side);

// A colour over such squares.
void draw_color(ImDrawList& list, Rgba color, ImVec2 from, ImVec2 to, float side);

}  // namespace talus
