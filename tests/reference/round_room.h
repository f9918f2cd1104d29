// A reference for bodies that meet: circles and boxes in a closed room, without gravity and friction. They go
// straight on from one impact to the next. No code of the core, and in a higher precision.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace talus::reference {

using Number = long double;

// A box with round corners: a circle has no half, and a box no radius.
struct RoomBody {
  Number x = 0, y = 0;            // px, of its middle
  Number vx = 0, vy = 0;          // px/frame
  Number half_x = 0, half_y = 0;  // px
  Number radius = 0;              // px
  Number mass = 1;
};

class Room {
 public:
  // From 0, 0 to this corner. bounce: share of the approaching speed that is left, reversed.
  Room(Number width, Number height, Number bounce, std::vector<RoomBody> bodies)
      : width_(width), height_(height), bounce_(bounce), bodies_(std::move(bodies)) {}

  const std::vector<RoomBody>& bodies() const { return bodies_; }

  // Lets one frame pass. Returns the number of impacts; after kMax of them it stops: bodies that lose speed
  // may hit one another for ever in no time.
  static constexpr int kMax = 500;
  int step() {
    int impacts = 0;
    for (Number left = 1; left > 0 && impacts < kMax;) {
      const Impact next = first_impact(left);
      for (RoomBody& body : bodies_) {
        body.x += body.vx * next.time;
        body.y += body.vy * next.time;
      }
      left -= next.time;
      if (!next.happens) break;
      resolve(next);
      ++impacts;
    }
    return impacts;
  }

 private:
  static constexpr std::size_t kWall = static_cast<std::size_t>(-1);
  struct Impact {
    Number time = 0;
    bool happens = false;
    std::size_t a = 0, b = kWall;
    Number nx = 0, ny = 0;  // out of b
  };

  Impact first_impact(Number most) const {
    Impact first{most};
    const auto offer = [&](Number time, std::size_t a, std::size_t b, Number nx, Number ny) {
      if (time < first.time) first = {std::max<Number>(time, 0), true, a, b, nx, ny};
    };
    for (std::size_t a = 0; a < bodies_.size(); ++a) {
      const RoomBody& body = bodies_[a];
      const Number reach_x = body.half_x + body.radius, reach_y = body.half_y + body.radius;
      if (body.vx < 0) offer((reach_x - body.x) / body.vx, a, kWall, 1, 0);
      if (body.vx > 0) offer((width_ - reach_x - body.x) / body.vx, a, kWall, -1, 0);
      if (body.vy < 0) offer((reach_y - body.y) / body.vy, a, kWall, 0, 1);
      if (body.vy > 0) offer((height_ - reach_y - body.y) / body.vy, a, kWall, 0, -1);
      for (std::size_t b = a + 1; b < bodies_.size(); ++b) offer_pair(a, b, offer);
    }
    return first;
  }

  // The first body as a point, and the other one grown by it.
  template <class Offer>
  void offer_pair(std::size_t a, std::size_t b, const Offer& offer) const {
    const RoomBody &one = bodies_[a], &other = bodies_[b];
    const Number x = one.x - other.x, y = one.y - other.y, vx = one.vx - other.vx, vy = one.vy - other.vy;
    const Number half_x = one.half_x + other.half_x, half_y = one.half_y + other.half_y;
    const Number radius = one.radius + other.radius;
    for (const int side : {-1, 1}) {
      const Number at_x = (side * (half_x + radius) - x) / vx, at_y = (side * (half_y + radius) - y) / vy;
      if (side * vx < 0 && at_x > -kSlack && std::abs(y + vy * at_x) <= half_y) offer(at_x, a, b, side, 0);
      if (side * vy < 0 && at_y > -kSlack && std::abs(x + vx * at_y) <= half_x) offer(at_y, a, b, 0, side);
    }
    if (radius == 0) return;
    for (const int right : {-1, 1}) {
      for (const int down : {-1, 1}) {
        const Number cx = x - right * half_x, cy = y - down * half_y;
        const Number closing = cx * vx + cy * vy, square = vx * vx + vy * vy;
        const Number inside = closing * closing - square * (cx * cx + cy * cy - radius * radius);
        if (!(closing < 0) || inside < 0) continue;
        const Number time = (cx * cx + cy * cy - radius * radius) / (std::sqrt(inside) - closing);
        const Number nx = (cx + vx * time) / radius, ny = (cy + vy * time) / radius;
        if (time > -kSlack && nx * right >= 0 && ny * down >= 0) offer(time, a, b, nx, ny);
      }
    }
  }

  void resolve(const Impact& impact) {
    RoomBody& a = bodies_[impact.a];
    const bool is_wall = impact.b == kWall;
    RoomBody still;
    RoomBody& b = is_wall ? still : bodies_[impact.b];
    const Number speed = (a.vx - b.vx) * impact.nx + (a.vy - b.vy) * impact.ny;
    const Number yields = 1 / a.mass + (is_wall ? 0 : 1 / b.mass);
    const Number impulse = -(1 + bounce_) * speed / yields;
    a.vx += impulse / a.mass * impact.nx;
    a.vy += impulse / a.mass * impact.ny;
    if (is_wall) return;
    b.vx -= impulse / b.mass * impact.nx;
    b.vy -= impulse / b.mass * impact.ny;
  }

  static constexpr Number kSlack = 1e-12L;  // frames
  Number width_, height_, bounce_;
  std::vector<RoomBody> bodies_;
};

}  // namespace talus::reference
