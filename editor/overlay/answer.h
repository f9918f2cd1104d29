// The right answer of a hard case, as lines and boxes in level pixels.
#pragma once

#include <talus/level/level.h>
#include "level/hard_case.h"
#include "overlay.h"

namespace talus {

// Adds where bodies start, where they should be, their paths there, and the floor that they should stay on.
// visible: level px; things that lie wholly outside are left out. Long paths are drawn in longer lines, and
// of many paths the first.
void add_answer(const HardCase& hard, const Level& level, Rect visible, OverlayDrawing& drawing);

}  // namespace talus
