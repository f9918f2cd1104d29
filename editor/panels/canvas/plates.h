// Texts on dark plates, readable over any art.
#pragma once

#include <string>
#include <vector>

#include "camera.h"
#include "panels/ui/ui.h"

namespace talus {

ImVec2 size_of_plate(const std::string& text, const Ui& ui);
void draw_plate(ImDrawList& list, ImVec2 at, const std::string& text, ImU32 color, const Ui& ui);
// A text as lines that each fit on a plate of the canvas.
std::vector<std::string> plate_lines(const std::string& text, const CanvasView& view, const Ui& ui);
// A text on plates below one another, above `low` px from the bottom of the canvas.
void draw_low_plates(ImDrawList& list, const CanvasView& view, const std::string& text, float low,
                     bool in_middle, ImU32 color, const Ui& ui);

}  // namespace talus
