// The layouts of the window that come with the program: which columns are open, and which tabs are in front.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "panels/view.h"

namespace talus {

struct LayoutPreset {
  std::string_view key;                // "debug"
  std::string_view label;              // on its button
  std::string_view help;               // a sentence
  bool left, right, right_low, dock;   // whether they are open: see WindowView
  std::vector<std::string_view> tabs;  // ids of the panels in front
};
// In the order of their buttons. A new layout is a row here.
std::span<const LayoutPreset> layout_presets();
// The id of the command that shows it: "view/layout_debug".
std::string layout_command(const LayoutPreset& preset);
// Opens and closes columns, and brings tabs to the front; the zoom stays, and the body stays in the middle.
void show_layout(const LayoutPreset& preset, View& view);
// Whether the same columns are open.
bool is_shown(const LayoutPreset& preset, const View& view);

}  // namespace talus
