// The exact sweeps: bump's, operation for operation, and the robust one.
#include "sweep.h"

#include <algorithm>
#include <limits>

namespace talus {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Clips by one side. p: speed out of the box across the side. q: distance from the side inwards.
bool clip_side(double p, double q, Vec2 normal, Clip& clip) {
  if (p == 0) return !(q <= 0);
  const double r = q / p;
  if (p < 0) {
    if (r > clip.ti2) return false;
    if (r > clip.ti1) {
      clip.ti1 = r;
      clip.normal = normal;
    }
    return true;
  }
  if (r < clip.ti1) return false;
  if (r < clip.ti2) clip.ti2 = r;
  return true;
}

// The nearer to the origin of two sides at a and b; the far one if both are equally near.
double nearest(double a, double b) { return std::abs(a) < std::abs(b) ? a : b; }

double sign(double v) { return v > 0 ? 1 : v == 0 ? 0 : -1; }

bool leave_overlap(const Sweep& sweep, const Sides& difference, SweepContact& contact) {
  const Rect& box = sweep.box;
  Vec2 push{nearest(difference.left, difference.right), nearest(difference.top, difference.bottom)};
  contact.overlaps = true;
  contact.ti = -std::min(box.w, std::abs(push.x)) * std::min(box.h, std::abs(push.y));
  if (sweep.d.x == 0 && sweep.d.y == 0) {
    (std::abs(push.x) < std::abs(push.y) ? push.y : push.x) = 0;
    contact.normal = {sign(push.x), sign(push.y)};
    contact.touch = {box.x + push.x, box.y + push.y};
    return true;
  }
  Clip clip{-kInfinity, 1, {}};
  if (!clip_line(difference, {}, sweep.d, clip)) return false;
  contact.normal = clip.normal;
  contact.touch = {box.x + sweep.d.x * clip.ti1, box.y + sweep.d.y * clip.ti1};
  return true;
}

// Sides within this many units in the last place of the operands are flush: there is no gap and no overlap.
constexpr double kFlush = 4 * std::numeric_limits<double>::epsilon();

double snap(double v, double tolerance) { return std::abs(v) <= tolerance ? 0 : v; }

// One axis of the robust sweep: where the mover may stand, [at, at + size], beside the other box, [lo, lo +
// extent].
struct Axis {
  double at, size, lo, extent;

  double tolerance() const { return kFlush * std::max(std::abs(at) + size, std::abs(lo) + extent); }

  // The coordinate just outside of the other box, on the side of the normal (-1 or 1): the contact
  // coordinate, nudged outwards until the overlap test sees nothing. The step grows, which bounds the loop.
  double contact(double normal) const {
    double touch = normal < 0 ? lo - size : lo + extent;
    double step = std::abs(std::nextafter(touch, normal * kInfinity) - touch);
    while (normal < 0 ? lo - touch - size < 0 : lo - touch - size + (size + extent) > 0) {
      touch += normal * step;
      step *= 2;
    }
    return touch;
  }
};

// The shortest way out of an overlap; of two equal ones, the way back to where the mover came from.
Vec2 way_out(const Sides& difference, Vec2 d) {
  const auto out = [](double lo, double hi, double motion) {
    if (-lo == hi) return motion < 0 ? 1.0 : -1.0;
    return -lo < hi ? -1.0 : 1.0;
  };
  const double nx = out(difference.left, difference.right, d.x);
  const double ny = out(difference.top, difference.bottom, d.y);
  const double depth_x = nx < 0 ? -difference.left : difference.right;
  const double depth_y = ny < 0 ? -difference.top : difference.bottom;
  const bool equal_and_from_y = depth_x == depth_y && nx * d.x >= 0 && ny * d.y < 0;
  return depth_x <= depth_y && !equal_and_from_y ? Vec2{nx, 0} : Vec2{0, ny};
}

}  // namespace

bool clip_line(const Sides& box, Vec2 from, Vec2 d, Clip& clip) {
  return clip_side(-d.x, from.x - box.left, {-1, 0}, clip) &&
         clip_side(d.x, box.right - from.x, {1, 0}, clip) &&
         clip_side(-d.y, from.y - box.top, {0, -1}, clip) &&
         clip_side(d.y, box.bottom - from.y, {0, 1}, clip);
}

bool detect_faithful(const Sweep& sweep, const Sides& difference, SweepContact& contact) {
  if (contains(difference, {})) return leave_overlap(sweep, difference, contact);
  Clip clip{-kInfinity, kInfinity, {}};
  if (!clip_line(difference, {}, sweep.d, clip)) return false;
  const bool through_corner = !(std::abs(clip.ti1 - clip.ti2) >= kDelta);
  const bool ahead = 0 < clip.ti1 + kDelta || (clip.ti1 == 0 && clip.ti2 > 0);
  if (!(clip.ti1 < 1) || through_corner || !ahead) return false;
  contact = {
      false, clip.ti1, clip.normal, {sweep.box.x + sweep.d.x * clip.ti1, sweep.box.y + sweep.d.y * clip.ti1}};
  return true;
}

bool detect_robust(const Sweep& sweep, const Rect& other, SweepContact& contact) {
  const Rect& box = sweep.box;
  const Axis x{box.x, box.w, other.x, other.w};
  const Axis y{box.y, box.h, other.y, other.h};
  Sides sides = minkowski_difference(box, other);
  sides = {snap(sides.left, x.tolerance()), snap(sides.top, y.tolerance()), snap(sides.right, x.tolerance()),
           snap(sides.bottom, y.tolerance())};
  if (misses(sides, sweep.d)) return false;
  contact.overlaps = sides.left < 0 && sides.top < 0 && sides.right > 0 && sides.bottom > 0;
  if (contact.overlaps) {
    contact.normal = way_out(sides, sweep.d);
    contact.ti = -std::min({box.w, -sides.left, sides.right}) * std::min({box.h, -sides.top, sides.bottom});
    contact.touch = box.position();
  } else {
    Clip clip{-kInfinity, kInfinity, {}};
    if (!clip_line(sides, {}, sweep.d, clip)) return false;
    if (!(0 <= clip.ti1 && clip.ti1 < 1 && clip.ti1 < clip.ti2)) return false;
    contact.normal = clip.normal;
    contact.ti = clip.ti1;
    contact.touch = {box.x + sweep.d.x * clip.ti1, box.y + sweep.d.y * clip.ti1};
  }
  if (contact.normal.x != 0) {
    contact.touch.x = x.contact(contact.normal.x);
  } else {
    contact.touch.y = y.contact(contact.normal.y);
  }
  return true;
}

}  // namespace talus
