// An overlay added as docs/adding.md says: its row beside its drawing.
#include "overlay/overlay_pen.h"

namespace talus::overlay {

extern const Overlay centres;
const Overlay centres{
    .key = "centres",
    .label = "centres",
    .help = "Crosses at the bodies' centres.",
    .color = 0xffffff,
    .safe_color = 0xffffff,
    .draw_body = [](const OverlaySource&, const Body& body, OverlayPen& pen) { pen.mark(body.box.center()); },
    .draw_swatch =
        [](OverlayPen& pen) {
          pen.mark({4, 4});
        },
};

}  // namespace talus::overlay
