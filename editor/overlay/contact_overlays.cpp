// Overlays of contacts: the touched sides, and the times.
#include <algorithm>

#include "number_label.h"
#include "overlay_pen.h"

namespace talus {
namespace {

constexpr double kTouchedLength = 8;      // px
constexpr double kLeastLabelled = 0.005;  // of an impulse; less would be "0.00"

// Returns the middle of the common part of two intervals, or of the gap between them if they have none.
double shared_middle(double a_min, double a_max, double b_min, double b_max) {
  return (std::max(a_min, b_min) + std::min(a_max, b_max)) / 2;
}

// Returns where the mover's box meets the obstacle at the contact: the middle of the common part of the
// touched side. A contact without a direction gives the middle of the overlap.
Vec2 touched_point(const ContactRecord& contact, const Rect& body) {
  const Rect& o = contact.other.box;
  const Vec2 at = contact.touch, n = contact.normal;
  Vec2 point{shared_middle(at.x, at.x + body.w, o.x, o.right()),
             shared_middle(at.y, at.y + body.h, o.y, o.bottom())};
  if (n.x != 0) point.x = n.x < 0 ? o.x : o.right();
  if (n.y != 0) point.y = n.y < 0 ? o.y : o.bottom();
  return point;
}

void draw_contact_normal(const OverlaySource&, const ContactRecord& contact, const Body& body,
                         OverlayPen& pen) {
  if (contact.normal == Vec2{}) return;
  const Vec2 point = touched_point(contact, body.box);
  pen.line(point, point + contact.normal * kTouchedLength, true);
}

void draw_floor_normal(const OverlaySource&, const SlopeProbe& probe, const Body& body, OverlayPen& pen) {
  const Vec2 floor{body.box.center().x, probe.floor_y};
  pen.line(floor, floor + probe.normal * kTouchedLength, true);
}

void draw_impulse(const OverlaySource&, const ContactRecord& contact, const Body& body, OverlayPen& pen) {
  if (!(contact.impulse > 0)) return;
  const Vec2 point = touched_point(contact, body.box);
  const double change = contact.impulse / mass_of(body.kind, {body.box.w, body.box.h});
  const Vec2 end = point + contact.normal * (change * kPixelsPerVelocity);
  pen.line(point, end, true);
  if (contact.impulse >= kLeastLabelled) pen.label(end, two_decimals(contact.impulse), body);
}

void draw_touch_point(const OverlaySource&, const ContactRecord& contact, const Body& body, OverlayPen& pen) {
  const Vec2 point = touched_point(contact, body.box);
  pen.mark(point);
  pen.label(point, time_label(contact.ti, contact.overlaps), body);
}

}  // namespace

namespace overlay {

const Overlay normals{
    .key = "normals",
    .label = "contact normals",
    .help = "Arrows out of the touched sides, and out of the slopes that a body was put on.",
    .group = OverlayGroup::contact,
    .color = 0xe69f00,
    .safe_color = 0x8c8c00,
    .digit = '2',
    .is_short_from_far = true,
    .draw_contact = draw_contact_normal,
    .draw_probe = draw_floor_normal,
    .draw_swatch =
        [](OverlayPen& pen) {
          pen.line({4, 7.5}, {4, 0.5}, true);
        },
};

const Overlay impulses{
    .key = "impulses",
    .label = "impulses",
    .help =
        "Arrows along the speed that each contact gave its body, 4 px long for each px/frame, and the "
        "impulse: mass times speed. Only exact.",
    .group = OverlayGroup::contact,
    .color = 0xffd9a0,
    .safe_color = 0xccfcf0,
    .digit = '9',
    .shift = true,
    .draw_contact = draw_impulse,
    .draw_swatch =
        [](OverlayPen& pen) {
          pen.line({4, 7.5}, {4, 1}, true);
        },
};

const Overlay touch_points{
    .key = "touch_points",
    .label = "touch points",
    .help = "Crosses where bodies met something, with the fraction of the move done by then.",
    .group = OverlayGroup::contact,
    .color = 0xf0e442,
    .safe_color = 0xc8c828,
    .digit = '3',
    .draw_contact = draw_touch_point,
    .draw_swatch =
        [](OverlayPen& pen) {
          pen.mark({4, 4});
        },
};

}  // namespace overlay
}  // namespace talus
