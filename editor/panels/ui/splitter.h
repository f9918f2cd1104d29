// Splitter: a bar between two regions that can be dragged.
#pragma once

#include "ui.h"

namespace talus {

inline constexpr float kSplitterWidth = 4;  // px at scale 1

enum class SplitterAxis { horizontal, vertical };  // the direction in which it moves

// Draws it at the cursor. Returns by how many px of the screen it was dragged in this frame.
float splitter(std::string_view name, ImVec2 size, SplitterAxis axis, Ui& ui);

}  // namespace talus
