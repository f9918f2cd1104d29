// Overlays of the bodies: their boxes, their velocity, and their parts in the ground.
#include <algorithm>
#include <cmath>

#include "collision/ground_queries.h"
#include "number_label.h"
#include "overlay_pen.h"
#include "sim/body_in_ground.h"
#include "visible_items.h"

namespace talus {
namespace {

void draw_boxes(const OverlaySource& source, OverlayPen& pen) {
  for_each_visible_item(source.scene, pen.visible(), [&](const SceneItem& item) {
    if (item.role != TileRole::ball) pen.box(item.box);
  });
  for (const Body& body : source.state.bodies) pen.box(body.box);
}

void draw_velocity(const OverlaySource&, const Body& body, OverlayPen& pen) {
  if (body.velocity == Vec2{}) return;
  const Vec2 from = body.box.center(), to = from + body.velocity * kPixelsPerVelocity;
  pen.line(from, to, true);
  pen.label(to, two_decimals(body.velocity.x) + ", " + two_decimals(body.velocity.y), body);
}

// Draws the part of the body that is in the ground: the strip at the side with the shortest way out.
void draw_penetration(const OverlaySource& source, const Body& body, OverlayPen& pen) {
  if (source.ground == nullptr || !pen.sees(body.box)) return;
  BodyWork work(pen.drawing(), body.id == source.chosen_body);
  if (!work.is_left()) return;
  const auto out = way_out_of(source.scene, *source.ground, body, work.budget());
  if (!out) return;
  Rect inside = body.box;
  if (out->x != 0) {
    inside.w = std::min(inside.w, std::abs(out->x));
    if (out->x < 0) inside.x = body.box.right() - inside.w;
  } else {
    inside.h = std::min(inside.h, std::abs(out->y));
    if (out->y < 0) inside.y = body.box.bottom() - inside.h;
  }
  pen.box(inside, true);
  const Vec2 from = inside.center();
  pen.line(from, from + *out, true);
  pen.label(from, "in " + two_decimals(std::abs(out->x) + std::abs(out->y)), body);
}

}  // namespace

namespace overlay {

const Overlay boxes{
    .key = "boxes",
    .label = "boxes",
    .help =
        "Outlines of the bodies, and of the solids and slopes that article and bump test: exact has the "
        "outline instead.",
    .color = 0x56b4e9,
    .safe_color = 0x50aac8,
    .digit = '1',
    .near_only = true,
    .layer = -3,
    .draw = draw_boxes,
    .draw_swatch =
        [](OverlayPen& pen) {
          pen.box({1, 1, 6, 6});
        },
};

const Overlay velocity{
    .key = "velocity",
    .label = "velocity",
    .help = "Arrows from the bodies' centres, 4 px long for each px/frame.",
    .color = 0x009e73,
    .safe_color = 0x6ec88c,
    .digit = '4',
    .labels_outside = true,  // an arrow inside its body needs no label
    .draw_body = draw_velocity,
    .draw_swatch =
        [](OverlayPen& pen) {
          pen.line({0.5, 6}, {7.5, 2}, true);
        },
};

const Overlay penetration{
    .key = "penetration",
    .label = "penetration",
    .help = "In red, how deep a body is inside the ground, and the shortest way out.",
    .color = 0xff6b6b,
    .safe_color = 0xc850ff,
    .digit = '5',
    .shift = true,
    .needs_ground = true,
    .draw_body = draw_penetration,
    .draw_swatch =
        [](OverlayPen& pen) {
          pen.box({1, 4, 6, 4}, true);
          pen.line({4, 6}, {4, 1}, true);
        },
};

}  // namespace overlay
}  // namespace talus
