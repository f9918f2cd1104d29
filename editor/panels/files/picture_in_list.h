// Pictures and names of levels in lists.
#pragma once

#include <memory>
#include <string>

#include "panels/ui/ui.h"

namespace talus {

// Draws the picture as large as it fits into a dark field of the current window; null: only the field.
void draw_picture_in(const std::shared_ptr<const SheetPicture>& picture, ImVec2 min, ImVec2 max, Ui& ui);
// The same with the picture of a file that was open before, if one is known.
void draw_recent_picture(const std::string& file, ImVec2 min, ImVec2 max, Ui& ui);
// The name of a level that comes with the program, from its path: "25 numbers that are none".
std::string example_name(const std::string& path);

}  // namespace talus
