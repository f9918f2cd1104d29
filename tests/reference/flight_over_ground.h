// A reference for balls that fly under gravity and bounce without loss off ground y = f(x). No code of the
// core, and in a higher precision.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace talus::reference {

using Precise = long double;

// Ground below a height, px, y down.
struct HeightGround {
  std::function<Precise(Precise)> height, slope;  // of x: px, and its dy/dx
  std::vector<Precise> tops;                      // x of the peaks, on which the bottom of a box may lie
};

// Where the middle of a ball's bottom is, px, and its velocity there, px/frame.
struct BallFlight {
  Precise x = 0, y = 0, vx = 0, vy = 0;
  bool is_slow = false;  // it has left the ground no faster than gravity pulls in a frame
};

class FlightOverGround {
 public:
  // width: px, of the box that meets the ground with all of its bottom; 0: with the middle of it alone.
  FlightOverGround(HeightGround ground, Precise gravity, Precise width)
      : ground_(std::move(ground)), gravity_(gravity), width_(width) {}

  // px and dy/dx of the ground at the place where a ball with its middle at x would lie.
  struct Support {
    Precise y = 0, slope = 0;
  };
  Support support(Precise x) const {
    const Precise left = x - width_ / 2, right = x + width_ / 2;
    const Support a{ground_.height(left), ground_.slope(left)},
        b{ground_.height(right), ground_.slope(right)};
    Support highest = a.y < b.y ? a : b;
    if (std::abs(a.y - b.y) < kSame && std::abs(a.slope + b.slope) < kSame)
      highest.slope = 0;  // mirror images
    for (const Precise top : ground_.tops)
      if (top > left && top < right && ground_.height(top) < highest.y) highest = {ground_.height(top), 0};
    return highest;
  }

  // Lets a frame pass. Returns the number of bounces.
  int frame(BallFlight& ball) const {
    constexpr int kMaxBounces = 20;
    Precise left = 1;
    for (int bounces = 0; bounces < kMaxBounces; ++bounces) {
      const Precise time = time_to_ground(ball, left);
      ball = after(ball, std::min(time, left));
      if (!(time <= left)) return bounces;
      left -= time;
      const Precise slope = support(ball.x).slope, length = std::sqrt(1 + slope * slope);
      const Precise nx = slope / length, ny = -1 / length, into = -(ball.vx * nx + ball.vy * ny);
      ball.is_slow = ball.is_slow || into <= -gravity_ * ny;
      ball.vx += 2 * into * nx;
      ball.vy += 2 * into * ny;
    }
    return kMaxBounces;
  }

 private:
  static constexpr Precise kSame = 1e-12L;   // px, and dy/dx
  static constexpr Precise kLeaves = 1e-7L;  // frames, in which a ball leaves the ground that it has hit

  BallFlight after(const BallFlight& from, Precise time) const {
    return {from.x + from.vx * time, from.y + from.vy * time + gravity_ * time * time / 2, from.vx,
            from.vy + gravity_ * time, from.is_slow};
  }
  Precise gap(const BallFlight& ball, Precise time) const {
    const BallFlight there = after(ball, time);
    return support(there.x).y - there.y;
  }

  // More than `most`: it does not meet the ground before that. The gap is looked at in small steps, and the
  // place where it closes is halved.
  Precise time_to_ground(const BallFlight& ball, Precise most) const {
    constexpr int kSteps = 64, kHalvings = 70;
    const bool is_on_ground = gap(ball, 0) < 1e-9L;
    if (is_on_ground && ball.vy > support(ball.x).slope * ball.vx) return 0;
    const Precise start = is_on_ground ? std::min(most, kLeaves) : 0;
    Precise open = start;
    for (int i = 1; i <= kSteps; ++i) {
      Precise closed = start + (most - start) * i / kSteps;
      if (gap(ball, closed) >= 0) {
        open = closed;
        continue;
      }
      for (int j = 0; j < kHalvings; ++j) {
        const Precise middle = (open + closed) / 2;
        (gap(ball, middle) < 0 ? closed : open) = middle;
      }
      return open;
    }
    return most + 1;
  }

  HeightGround ground_;
  Precise gravity_, width_;
};

}  // namespace talus::reference
