// Strokes the overlays: each with a thin dark outline, so that it shows on any palette, and labels that keep
// clear of one another and of what they label.
#pragma once

#include <span>

#include "camera.h"
#include "overlay/overlay.h"

namespace talus {

// `scale`: of the interface; line widths and text follow it. `keep_clear`: level px that no label may cover.
// `pointed_at`: id of the body under the mouse, 0 for none: the labels that find no room beside it are
// listed.
void paint_overlays(ImDrawList& list, const OverlayDrawing& drawing, std::span<const Rect> keep_clear,
                    const CanvasView& view, float scale, int pointed_at);

// The overlay's colour and shape in a square, for the legend.
void paint_overlay_swatch(ImDrawList& list, OverlayId id, ImVec2 at, float size, OverlayPalette palette);

}  // namespace talus
