// References for bodies that meet: the closed forms of textbooks. No code of the core.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace talus::reference {

// Newton's cradle: the velocities after the impact of equal bodies in a row, of which the first and the last
// ones came at one speed, at one time, without loss. As many leave to each side as came from the other one.
inline std::vector<double> cradle(int count, int from_left, int from_right, double speed) {
  std::vector<double> after(static_cast<std::size_t>(count), 0.0);
  std::fill(after.begin(), after.begin() + from_right, -speed);
  std::fill(after.end() - from_left, after.end(), speed);
  return after;
}

// Two bodies on one line.
struct Two {
  double a = 0, b = 0;  // masses, or velocities
};
inline Two after_impact(Two mass, Two velocity, double bounce) {
  const double common = (mass.a * velocity.a + mass.b * velocity.b) / (mass.a + mass.b);
  const double apart = bounce * (velocity.a - velocity.b) / (mass.a + mass.b);
  return {common - mass.b * apart, common + mass.a * apart};
}

// How fast a crate gains speed down an incline from rest: 0 if friction holds it. slope: |dy/dx|.
inline double gain_down_incline(double gravity, double slope, double friction) {
  const double length = std::hypot(1.0, slope);
  return slope <= friction ? 0 : gravity * (slope - friction) / length;
}

// A disc of even density: half of its mass counts at its rim.

// How fast a disc gains speed down an incline from rest, and at its rim: it rolls where friction can turn it
// as fast, and slides otherwise. slope: |dy/dx|.
struct Rolling {
  double gain = 0, rim = 0;
};
inline Rolling disc_down_incline(double gravity, double slope, double friction) {
  const double length = std::hypot(1.0, slope), along = gravity * slope / length;
  if (slope <= 3 * friction) return {along * 2 / 3, along * 2 / 3};
  const double rubs = friction * gravity / length;
  return {along - rubs, 2 * rubs};
}

// A disc that slides over a level floor until it rolls.
struct Slide {
  double speed = 0, gravity = 0, friction = 0;
  double rolls_at() const { return speed / (3 * friction * gravity); }
  double way(double time) const {
    const double slides = std::min(time, rolls_at());
    return speed * slides - friction * gravity * slides * slides / 2 + (time - slides) * speed * 2 / 3;
  }
  double rim(double time) const { return 2 * friction * gravity * std::min(time, rolls_at()); }
};

// A body that rubs on a conveyor, which goes along a straight line, until it goes as fast. gain: what
// friction and gravity give it along the line, px/frame^2, towards the conveyor's speed.
struct Carried {
  double start = 0, conveyor = 0, gain = 0;
  double keeps_up_at() const { return std::abs(conveyor - start) / gain; }
  double way(double time) const {
    const double rubs = std::min(time, keeps_up_at());
    const double towards = conveyor > start ? gain : -gain;
    return start * rubs + towards * rubs * rubs / 2 + (time - rubs) * conveyor;
  }
};

// The cosine of the angle from above at which a body leaves what is round, on which it slid without friction.
// start: its speed on top; around: the radius of its way.
inline double cosine_where_it_leaves(double start, double gravity, double around) {
  return 2.0 / 3 + start * start / (3 * gravity * around);
}

// Swings to and fro around the lowest place of its round way, by the method of Runge and Kutta. angle:
// radians, from there; gain: what pulls it along its way where that is upright, by the way's radius,
// 1/frame^2.
struct Pendulum {
  double angle = 0, gain = 0, speed = 0;
  void frame() {
    constexpr int kParts = 64;
    constexpr double kStep = 1.0 / kParts;
    for (int i = 0; i < kParts; ++i) {
      const auto pull = [&](double at) { return -gain * std::sin(at); };
      const double v1 = speed, a1 = pull(angle), v2 = speed + kStep / 2 * a1,
                   a2 = pull(angle + kStep / 2 * v1);
      const double v3 = speed + kStep / 2 * a2, a3 = pull(angle + kStep / 2 * v2);
      const double v4 = speed + kStep * a3, a4 = pull(angle + kStep * v3);
      angle += kStep / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
      speed += kStep / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
  }
};

// A body that falls from rest, and bounces.
struct Fall {
  double height = 0, gravity = 0, bounce = 0;  // of the start above the floor
  double lands() const { return std::sqrt(2 * height / gravity); }
  double lands_again() const { return (1 + 2 * bounce) * lands(); }
  // Above the floor, until it lands again.
  double above(double time) const {
    const double since = time - lands();
    if (since < 0) return height - gravity * time * time / 2;
    return bounce * gravity * lands() * since - gravity * since * since / 2;
  }
  // Upwards, until it lands again.
  double rises(double time) const {
    const double since = time - lands();
    return since < 0 ? -gravity * time : bounce * gravity * lands() - gravity * since;
  }
};

}  // namespace talus::reference
