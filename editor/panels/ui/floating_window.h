// Windows that float over the panels, such as the settings, until the user closes them.
#pragma once

#include "ui.h"

namespace talus {

struct FloatingWindow {
  const char* title;            // the name of the window, too
  bool* open;                   // its cross sets it to false
  ImVec2 place = {0.5f, 0.5f};  // where it appears, as shares of the program's window
  ImVec2 pivot = {0.5f, 0.5f};  // the point of the window that is there, as shares of its size
  ImVec2 size = {};             // px of the screen, when it appears; {0,0}: it always fits its content
  ImVec2 least = {};            // px of the screen: the user makes it no smaller
  ImGuiWindowFlags flags = 0;   // besides those of all such windows
};

// Begins a window that is never larger than the program's window, and never beyond its edges. Returns whether
// its content is seen; ImGui::End() must follow in any case.
bool begin_floating_window(const FloatingWindow& window);

}  // namespace talus
