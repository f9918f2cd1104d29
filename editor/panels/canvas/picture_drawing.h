// Pictures of large tiles, objects and layers on a canvas.
#pragma once

#include <talus/level/level.h>
#include <talus/level/placed_picture.h>
#include "camera.h"
#include "panels/ui/ui.h"

namespace talus {

// Draws nothing without PictureTextures.
void draw_picture(ImDrawList& list, const PlacedPicture& picture, const CanvasView& view, const Ui& ui,
                  ImU32 color);
// The pictures of a layer's objects, or its own one. view: where the layer is.
void draw_pictures(ImDrawList& list, const ObjectLayer& layer, const CanvasView& view, const Ui& ui,
                   ImU32 color);

}  // namespace talus
