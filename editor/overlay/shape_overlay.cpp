// The overlay of the tiles' shapes. The canvas and the sheet draw it, as they also draw the shape that is
// edited.
#include "overlay_pen.h"

namespace talus::overlay {

const Overlay shapes{
    .key = "shapes",
    .label = "shapes",
    .help = "The shapes of the tiles that make the ground, on the map, in the play view and on the sheet.",
    .group = OverlayGroup::ground,
    .color = 0xff5cf0,
    .safe_color = 0xffff6e,
    .digit = '6',
    .shift = true,
    .draw_swatch =
        [](OverlayPen& pen) {
          pen.line({0, 7}, {5, 2});
          pen.line({5, 2}, {8, 2});
        },
};

}  // namespace talus::overlay
