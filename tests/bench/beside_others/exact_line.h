// ExactLine: two bodies without friction or gravity on a line between two walls, from impact to impact.
#pragma once

#include <algorithm>
#include <cmath>

namespace talus::beside {

struct ExactLine {
  struct Body {
    double place = 0, size = 0, speed = 0;  // px, left end; px; px/frame
  };
  double left, right;             // px, the walls
  double light_mass, heavy_mass;  // `light` is the left one
  Body light, heavy;

  // Goes on for so many frames.
  void run(double frames) {
    while (frames > 0) {
      const double meet = until(heavy.place - light.place - light.size, light.speed - heavy.speed);
      const double at_left = until(light.place - left, -light.speed);
      const double at_right = until(right - heavy.place - heavy.size, heavy.speed);
      const double next = std::min({frames, meet, at_left, at_right});
      light.place += light.speed * next;
      heavy.place += heavy.speed * next;
      frames -= next;
      if (next == meet) reflect();
      if (next == at_left) light.speed = -light.speed;
      if (next == at_right) heavy.speed = -heavy.speed;
    }
  }

 private:
  // Frames until a gap closes.
  static double until(double gap, double speed) { return speed > 0 ? std::max(gap, 0.0) / speed : HUGE_VAL; }
  void reflect() {
    const double common = (light_mass * light.speed + heavy_mass * heavy.speed) / (light_mass + heavy_mass);
    light.speed = 2 * common - light.speed;
    heavy.speed = 2 * common - heavy.speed;
  }
};

}  // namespace talus::beside
