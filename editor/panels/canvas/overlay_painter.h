// Draws the overlays: each with a thin dark outline, so that it is visible on any palette, and labels that
// avoid one another and the things that they label.
#pragma once

#include <span>

#include "camera.h"
#include "overlay/overlay.h"

namespace talus {

// `scale`: of the interface; line widths and text follow it. `keep_clear`: px of the level that no label may
// cover. `pointed_at`: id of the body under the mouse, 0: no body; its labels without room are listed beside
// it.
void paint_overlays(ImDrawList& list, const OverlayDrawing& drawing, std::span<const Rect> keep_clear,
                    const CanvasView& view, float scale, int pointed_at);

// The overlay's colour and shape in a square, for the legend.
void paint_overlay_swatch(ImDrawList& list, const Overlay& overlay, ImVec2 at, float size,
                          OverlayPalette palette);

}  // namespace talus
