#include "slope.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace talus {
namespace {

// px under the floor at which a foot still counts as on it: far more than rounding, far less than a pixel.
constexpr double kSlack = 1e-6;

double rise_of(const Slope& slope) { return slope.box.h - slope.low; }

Rect mirrored(const Rect& box) { return {box.x, -(box.y + box.h), box.w, box.h}; }

// A ceiling, mirrored.
Slope floor_of(const Slope& ceiling) {
  Slope floor = ceiling;
  floor.box = mirrored(ceiling.box);
  floor.ceiling = false;
  return floor;
}

// A box that moves over a slope; `t` is the fraction of the motion.
class Passage {
 public:
  Passage(const Slope& slope, const Rect& mover, Vec2 goal)
      : slope_(slope), mover_(mover), d_(goal - mover.position()) {}

  // The part of the motion on which the box is above, in or under the slope; nothing if enter >= leave.
  double enter() const {
    return d_.x == 0 ? (beside() ? 1 : 0) : std::clamp(std::min(to_left(), to_right()), 0.0, 1.0);
  }
  double leave() const { return d_.x == 0 ? 1 : std::clamp(std::max(to_left(), to_right()), 0.0, 1.0); }
  // The time at which the foot passes the slope's high end, the only bend of the floor.
  double bend() const { return d_.x == 0 ? 0 : (high_end() - corner(mover_.x)) / d_.x; }

  bool is_past_line() const { return !beside() && depth(0) > kSlack; }
  double depth(double t) const { return mover_.bottom() + t * d_.y - floor_at(mover_.x + t * d_.x); }
  bool on_high_end(double t) const {
    const double past = corner(mover_.x + t * d_.x) - high_end();
    return slope_.direction > 0 ? past >= 0 : past <= 0;
  }

  // Whether a foot under the floor is lifted onto it: only if that is the shortest way out, as when rounding
  // or an edit of the level has sunk it a little.
  bool lifts() const {
    const Rect& box = slope_.box;
    const double side = slope_.direction > 0 ? box.right() - mover_.x : mover_.right() - box.x;
    return mover_.bottom() <= box.bottom() + kSlack && depth(0) <= side;
  }

  SlopeContact surface(double t, bool on_high_end) const {
    SlopeContact contact;
    contact.kind = SlopeContact::Kind::surface;
    contact.ti = t;
    const double x = mover_.x + t * d_.x;
    contact.floor_y = floor_at(x);
    contact.delta = (foot(x) - slope_.box.x) / slope_.box.w;
    contact.touch = {x, contact.floor_y - mover_.h};
    contact.normal = on_high_end ? Vec2{0, -1} : slope_normal(slope_);
    const Vec2 rest = d_ * (1 - t);
    const Vec2 along{-contact.normal.y, contact.normal.x};
    const double into = rest.x * contact.normal.x + rest.y * contact.normal.y;
    contact.goal = contact.touch + (into < 0 ? along * (rest.x * along.x + rest.y * along.y) : rest);
    // Along the slope, the slope's line gives the height, as the sum would be rounded.
    if (into < 0 && !on_high_end) contact.goal.y = line(corner(contact.goal.x)) - mover_.h;
    return contact;
  }

 private:
  bool beside() const { return mover_.right() <= slope_.box.x || mover_.x >= slope_.box.right(); }
  double to_left() const { return (slope_.box.x - mover_.right()) / d_.x; }
  double to_right() const { return (slope_.box.right() - mover_.x) / d_.x; }
  double high_end() const { return slope_.direction > 0 ? slope_.box.right() : slope_.box.x; }
  double corner(double x) const { return slope_.direction > 0 ? x + mover_.w : x; }
  double foot(double x) const { return std::clamp(corner(x), slope_.box.x, slope_.box.right()); }
  double line(double x) const {
    const Rect& box = slope_.box;
    const double run = slope_.direction > 0 ? x - box.x : box.right() - x;
    return box.bottom() - slope_.low - rise_of(slope_) * run / box.w;
  }
  double floor_at(double x) const { return line(foot(x)); }

  const Slope& slope_;
  const Rect& mover_;
  Vec2 d_;
};

}  // namespace

double slope_direction(TileRole role) {
  if (role == TileRole::up_slope) return 1;
  if (role == TileRole::down_slope) return -1;
  return 0;
}

Vec2 slope_normal(const Slope& slope) {
  const double width = slope.box.w, rise = rise_of(slope);
  const double length = std::sqrt(width * width + rise * rise);
  return {-slope.direction * rise / length, (slope.ceiling ? width : -width) / length};
}

bool is_past_line(const Slope& slope, const Rect& box) {
  if (slope.ceiling) return is_past_line(floor_of(slope), mirrored(box));
  return Passage(slope, box, box.position()).is_past_line();
}

SlopeContact meet_slope(const Slope& slope, const Rect& mover, Vec2 goal) {
  if (slope.ceiling) {
    SlopeContact contact = meet_slope(floor_of(slope), mirrored(mover), {goal.x, -(goal.y + mover.h)});
    contact.touch.y = -(contact.touch.y + mover.h);
    contact.goal.y = -(contact.goal.y + mover.h);
    contact.normal.y = -contact.normal.y;
    contact.floor_y = -contact.floor_y;
    return contact;
  }
  const Passage passage(slope, mover, goal);
  const double enter = passage.enter(), leave = passage.leave();
  if (enter >= leave) return {};
  if (passage.depth(enter) > kSlack) {
    if (slope.one_way) return {};
    if (enter == 0 && passage.lifts()) return passage.surface(0, passage.on_high_end(0));
    SlopeContact contact;
    contact.kind = SlopeContact::Kind::solid;
    return contact;
  }
  // The depth is linear on both sides of the bend.
  const std::array times = {enter, std::clamp(passage.bend(), enter, leave), leave};
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double from = times[i - 1], to = times[i];
    const double before = passage.depth(from), after = passage.depth(to);
    if (from >= to || after <= kSlack) continue;
    const double t = before < 0 ? from + (to - from) * (-before / (after - before)) : from;
    return passage.surface(t, passage.on_high_end((from + to) / 2));
  }
  return {};
}

}  // namespace talus
