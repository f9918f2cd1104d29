// How bodies moved: in the last step, and in the frames before it.
#pragma once

#include "overlay.h"

namespace talus {

// The way of each body from contact to contact, with its box at each, and the strip that it swept.
void add_swept_paths(const OverlaySource& source, Rect visible, OverlayDrawing& drawing);

// Lines from frame to frame, fainter the older. color: the overlay whose colour they have.
void add_trails(std::span<const Trail> trails, const Overlay* color, Rect visible, OverlayDrawing& drawing);

}  // namespace talus
