#include "reference.h"

#include <algorithm>
#include <cmath>

namespace talus {
namespace {

constexpr Wide kTurn = 6.283185307179586476925286766559005768L;

// Bisects [low, high] to the last bit; `after(t)` is false before the result and true from there on.
template <class After>
Wide bisect(Wide low, Wide high, After after) {
  for (int i = 0; i < 200; ++i) {
    const Wide middle = low + (high - low) / 2;
    if (!(middle > low && middle < high)) break;
    (after(middle) ? high : low) = middle;
  }
  return high;
}

Wide height(const LineFloor& f, Wide x) { return f.y0 + (x - f.x0) * (f.y1 - f.y0) / (f.x1 - f.x0); }
Wide height(const ArcFloor& f, Wide x) {
  const Wide u = x - f.center_x;
  return f.center_y - std::sqrt((f.radius - u) * (f.radius + u));
}
Wide height(const SineFloor& f, Wide x) {
  return f.middle + f.amplitude * std::sin(kTurn * (x - f.origin) / f.wavelength);
}

// The highest point between two x, if it is not at one of them.
Wide crest(const LineFloor& f, Wide left, Wide) { return height(f, left); }
Wide crest(const ArcFloor& f, Wide left, Wide right) {
  return height(f, std::clamp(f.center_x, left, right));
}
Wide crest(const SineFloor& f, Wide left, Wide right) {
  const Wide phase = f.amplitude > 0 ? 0.75L : 0.25L;
  const Wide wave = std::ceil((left - f.origin) / f.wavelength - phase);
  const Wide x = f.origin + (wave + phase) * f.wavelength;
  return x <= right ? f.middle - std::abs(f.amplitude) : height(f, left);
}

// A flight under constant gravity, or towards a speed. Times in frames.
class Flight {
 public:
  explicit Flight(const Tuning& t)
      : gravity_(t.exact.gravity),
        limit_(t.shared.fall_speed),
        kept_(1 - static_cast<Wide>(t.shared.fall_blend)) {}

  // The speed at which a flight in frames that begins at rest starts on its curve.
  Wide from_rest() const {
    return gravity_ > 0 ? gravity_ / 2 : limit_ - limit_ * kept_ * rate() / (1 - kept_);
  }
  Wide speed(Wide v, Wide t) const {
    return gravity_ > 0 ? v + gravity_ * t : limit_ + (v - limit_) * std::exp(-rate() * t);
  }
  Wide way(Wide v, Wide t) const {
    if (gravity_ > 0) return v * t + gravity_ * t * t / 2;
    return limit_ * t - (v - limit_) * std::expm1(-rate() * t) / rate();
  }
  // The time at which a flight that begins `above` px over the floor meets it.
  Wide landing(Wide above, Wide v) const {
    const Wide most = 10000;
    const Wide apex = v >= 0 ? 0 : bisect(0, most, [&](Wide t) { return speed(v, t) >= 0; });
    return bisect(apex, most, [&](Wide t) { return way(v, t) >= above; });
  }

 private:
  Wide rate() const { return -std::log(kept_); }
  Wide gravity_, limit_, kept_;
};

}  // namespace

Wide highest(const TrueFloor& floor, Wide left, Wide right) {
  return std::visit(
      [&](const auto& f) {
        return std::min({height(f, left), height(f, right), crest(f, left, right)});
      },
      floor);
}

Wide time_of_impact(const TrueFloor& floor, const WideBox& box, Wide dx, Wide dy) {
  const auto is_under = [&](Wide t) {
    const Wide x = box.x + t * dx;
    return box.y + box.h + t * dy >= highest(floor, x, x + box.w);
  };
  const Wide end = 1.5L;
  return is_under(end) ? bisect(0, end, is_under) : end;
}

void step_ball(WideBall& ball, const Tuning& tuning, Wide through_x, Wide through_y, Wide slope, int parts) {
  const SharedTuning& t = tuning.shared;
  ball.vy = (1 - static_cast<Wide>(t.fall_blend)) * ball.vy + static_cast<Wide>(t.fall_blend) * t.fall_speed;
  ball.vx =
      (1 - static_cast<Wide>(t.drift_blend)) * ball.vx + static_cast<Wide>(t.drift_blend) * t.drift_speed;
  const Wide length = std::sqrt(1 + slope * slope);
  const Wide nx = slope / length, ny = -1 / length;
  for (int i = 0; i < parts; ++i) {
    const Wide dx = ball.vx / parts, dy = ball.vy / parts;
    const Wide floor = through_y + (ball.x - through_x) * slope;
    const Wide closing = dy - dx * slope, gap = floor - ball.y;
    if (!(closing > 0) || gap >= closing) {
      ball.x += dx;
      ball.y += dy;
      continue;
    }
    const Wide time = std::max<Wide>(gap, 0) / closing, rest = 1 - time;
    const Wide along = (-dx * ny + dy * nx) * rest;
    ball.x += dx * time - ny * along;
    ball.y = through_y + (ball.x - through_x) * slope;
    const Wide into = -(ball.vx * nx + ball.vy * ny), kept = (-ball.vx * ny + ball.vy * nx) * t.floor_grip;
    ball.vx = -ny * kept + nx * into * t.floor_bounce;
    ball.vy = nx * kept + ny * into * t.floor_bounce;
  }
}

std::vector<double> bouncing(const Tuning& tuning, double start, int frames) {
  const Flight flight(tuning);
  std::vector<double> heights;
  Wide began = 0, y = start, v = flight.from_rest();
  Wide lands = flight.landing(-y, v);
  for (int frame = 0; frame <= frames; ++frame) {
    while (frame > began + lands) {
      v = -flight.speed(v, lands) * tuning.shared.floor_bounce;
      began += lands;
      y = 0;
      lands = flight.landing(0, v);
    }
    heights.push_back(static_cast<double>(y + flight.way(v, frame - began)));
  }
  return heights;
}

}  // namespace talus
