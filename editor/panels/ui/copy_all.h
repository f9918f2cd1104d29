// A button beside a text whose end is not shown.
#pragma once

#include <string>

#include "ui.h"

namespace talus {

// Copies the whole text to the clipboard. Draws nothing if draw_scrolled_text() shows all of it.
void draw_copy_all(std::string_view name, const std::string& text, Ui& ui);

}  // namespace talus
