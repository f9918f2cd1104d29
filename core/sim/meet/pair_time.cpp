#include "pair_time.h"

#include <algorithm>
#include <cmath>

#include "contact_set.h"
#include "round_time.h"

namespace talus {
namespace {

constexpr double kNear = 1e-9;               // px
constexpr double kRoundings = 64 * 0x1p-52;  // share of a coordinate
constexpr double kUsual = 8192;              // px: in levels up to this, a mirrored place has the same slack

// One axis of the way of one box as another sees it.
struct Axis {
  double place, speed, gain;  // px, px/frame, px/frame^2, of the first box, less those of the second
  double size, other;         // px, of the first box and of the second
  // px, between the two; less than 0: they overlap.
  double gap(double s) const {
    const double at = place + speed * s + gain * (s * s / 2);
    return std::max(at - other, -size - at);
  }
  double rate(double s) const { return speed + gain * s; }
};

// The time until the first box has come to the second from its side: 1 from the right or below, -1.
double time_from(const Axis& axis, double side, double slack, double still) {
  const double gap = side > 0 ? axis.place - axis.other : -axis.size - axis.place;
  const double speed = -side * axis.speed, gain = -side * axis.gain;
  if (gap < -slack) return HUGE_VAL;
  if (gap <= slack) {
    if (speed > still) return 0;
    if (!(gain > kStill)) return HUGE_VAL;
    return speed < -still ? -2 * speed / gain : 0;
  }
  return time_to_close(gap, speed, gain);
}

}  // namespace

double touch_slack(const Rect& a, const Rect& b) {
  const auto reach = [](const Rect& box) { return std::abs(box.x) + std::abs(box.y) + box.w + box.h; };
  return kNear + std::max({reach(a), reach(b), kUsual}) * kRoundings;
}

Rect touch_area(const Rect& box) {
  const double slack = 2 * touch_slack(box, box);
  return {box.x - slack, box.y - slack, box.w + 2 * slack, box.h + 2 * slack};
}

std::optional<Vec2> touching_normal(const Form& one, const Form& other, bool is_first) {
  const Rect &a = one.box, &b = other.box;
  if (one.is_round() || other.is_round()) {
    const Nearness near = nearness(one, other, is_first);
    return near.gap <= touch_slack(a, b) ? std::optional(near.normal) : std::nullopt;
  }
  const double x = std::max(a.x - b.right(), b.x - a.right()),
               y = std::max(a.y - b.bottom(), b.y - a.bottom());
  const double slack = touch_slack(a, b);
  if (x > slack || y > slack || (x > -slack && y > -slack)) return std::nullopt;
  const auto sign = [&](double ours, double theirs) {
    return ours < theirs || (ours == theirs && is_first) ? -1.0 : 1.0;
  };
  if (x > y) return Vec2{sign(a.x + a.w / 2, b.x + b.w / 2), 0};
  return Vec2{0, sign(a.y + a.h / 2, b.y + b.h / 2)};
}

std::optional<PairMeeting> next_meeting(const MovingBox& a, const MovingBox& b, double from, double to,
                                        double still) {
  const FallPath p = a.path.from(from), q = b.path.from(from);
  const double slack = touch_slack(a.at(from), b.at(from));
  if (a.is_round() || b.is_round()) {
    const FallPath way{0, {}, p.velocity - q.velocity, p.pull - q.pull};
    Form form = a.form_at(from);
    const Form there = b.form_at(from);
    const Vec2 start = form.box.position();
    const auto near_at = [&](double s) {
      const Vec2 place = start + way.way_to(s);
      form.box.x = place.x;
      form.box.y = place.y;
      return nearness(form, there, true);
    };
    const auto met = first_touch({way, to - from, slack, still, false}, near_at);
    if (!met) return std::nullopt;
    return PairMeeting{from + met->time, met->near.normal};
  }
  const Axis x{p.place.x - q.place.x, p.velocity.x - q.velocity.x, p.pull.x - q.pull.x, a.size.x, b.size.x};
  const Axis y{p.place.y - q.place.y, p.velocity.y - q.velocity.y, p.pull.y - q.pull.y, a.size.y, b.size.y};
  std::optional<PairMeeting> first;
  const auto offer = [&](const Axis& axis, const Axis& across, double side, Vec2 normal) {
    const double s = time_from(axis, side, slack, still);
    if (!(from + s < to) || (first && from + s >= first->time)) return;
    const double beside = across.gap(s);
    if (beside > slack) return;
    // Two corners meet only if the boxes come nearer on both axes. Rounding may say which one is first: it is
    // always the upper or lower side that counts.
    if (beside > -slack) {
      const double at = across.place + across.speed * s + across.gain * (s * s / 2);
      const double centre = at + (across.size - across.other) / 2;
      const double rate = centre < 0 ? across.rate(s) : -across.rate(s);
      const double gain = centre < 0 ? across.gain : -across.gain;
      if (!(rate > kStill || (rate >= -kStill && gain > kStill))) return;
      if (normal.y == 0) normal = {0, centre < 0 ? -1.0 : 1.0};
    }
    first = {from + s, normal};
  };
  offer(y, x, 1, {0, 1});
  offer(y, x, -1, {0, -1});
  offer(x, y, 1, {1, 0});
  offer(x, y, -1, {-1, 0});
  return first;
}

}  // namespace talus
