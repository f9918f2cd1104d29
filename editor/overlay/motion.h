// The motion of bodies in the last step, and in the frames before it.
#pragma once

#include "overlay.h"

namespace talus {

// Adds the path of each body from contact to contact, with its box at each, and the strip that it swept.
void add_swept_paths(const OverlaySource& source, Rect visible, OverlayDrawing& drawing);

// Adds lines from frame to frame; older ones are fainter. color: the overlay whose colour they have.
void add_trails(std::span<const Trail> trails, const Overlay* color, Rect visible, OverlayDrawing& drawing);

}  // namespace talus
