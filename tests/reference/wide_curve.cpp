// A cast lists every moment at which the position of the box relative to the curve may change: a corner is on
// the curve, or a side of the box is at a turning point or an end. Nothing changes between two such moments,
// so one test in the middle is enough.
#include "wide_curve.h"

#include <algorithm>
#include <cmath>

namespace talus::reference {
namespace {

// Returns where f changes its sign between a and b, by bisection down to neighbouring numbers.
template <class F>
void add_zero(Wide a, Wide b, F f, std::vector<Wide>& zeros) {
  const bool a_negative = f(a) < 0;
  if (a_negative == (f(b) < 0)) return;
  for (;;) {
    const Wide middle = a + (b - a) / 2;
    if (!(middle > a && middle < b)) break;
    ((f(middle) < 0) == a_negative ? a : b) = middle;
  }
  zeros.push_back(a);
  zeros.push_back(b);
}

void add_quadratic_roots(Wide a, Wide b, Wide c, std::vector<Wide>& roots) {
  const Wide inside = b * b - 4 * a * c;
  if (inside < 0) return;
  const Wide q = -(b + std::copysign(std::sqrt(inside), b)) / 2;
  if (a != 0) roots.push_back(q / a);
  if (q != 0) roots.push_back(c / q);
}

enum class Relation { beside, above, below, inside };  // where the box is relative to the curve

Relation relation(const WideCurve& curve, const WideBox& box) {
  const Wide from = std::max(curve.x0, box.x), to = std::min(curve.x1, box.x + box.w);
  if (!(from < to)) return Relation::beside;
  const auto [least, greatest] = curve.range(from, to);
  if (least >= box.y + box.h) return Relation::above;
  if (greatest <= box.y) return Relation::below;
  return Relation::inside;
}

// Adds the times at which a corner of the box is on the curve.
void add_corner_times(const WideCurve& curve, Wide x, Wide y, Wide dx, Wide dy, std::vector<Wide>& times) {
  const auto gap = [&](Wide t) { return curve.f(std::clamp(x + t * dx, curve.x0, curve.x1)) - (y + t * dy); };
  if (dx == 0) {
    if (x >= curve.x0 && x <= curve.x1 && dy != 0) times.push_back((curve.f(x) - y) / dy);
    return;
  }
  Wide enter = (curve.x0 - x) / dx, leave = (curve.x1 - x) / dx;
  if (enter > leave) std::swap(enter, leave);
  enter = std::max<Wide>(enter, 0), leave = std::min<Wide>(leave, 1);
  if (!(enter < leave)) return;
  // Between these the gap only grows or only shrinks.
  std::vector<Wide> cuts = {enter, leave};
  for (const Wide at : curve.where_slope_is(dy / dx)) {
    const Wide t = (at - x) / dx;
    if (t > enter && t < leave) cuts.push_back(t);
  }
  std::sort(cuts.begin(), cuts.end());
  times.insert(times.end(), cuts.begin(), cuts.end());
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) add_zero(cuts[i], cuts[i + 1], gap, times);
}

std::vector<Wide> times_of_change(const WideCurve& curve, const WideBox& box, Wide dx, Wide dy) {
  std::vector<Wide> times = {0, 1};
  for (const Wide x : {box.x, box.x + box.w}) {
    for (const Wide y : {box.y, box.y + box.h}) add_corner_times(curve, x, y, dx, dy, times);
  }
  std::vector<Wide> points = curve.where_slope_is(0);
  points.push_back(curve.x0);
  points.push_back(curve.x1);
  for (const Wide px : points) {
    if (dy != 0)
      times.push_back((curve.f(px) - box.y) / dy), times.push_back((curve.f(px) - box.y - box.h) / dy);
    if (dx != 0) times.push_back((px - box.x) / dx), times.push_back((px - box.x - box.w) / dx);
  }
  std::erase_if(times, [](Wide t) { return !(t >= 0 && t <= 1); });
  std::sort(times.begin(), times.end());
  return times;
}

}  // namespace

WideCurve::Range WideCurve::range(Wide from, Wide to) const {
  Range r{f(from), f(from)};
  const auto add = [&](Wide x) {
    const Wide y = f(x);
    r.least = std::min(r.least, y);
    r.greatest = std::max(r.greatest, y);
  };
  add(to);
  for (const Wide x : where_slope_is(0)) {
    if (x > from && x < to) add(x);
  }
  return r;
}

WideCurve wide_arc(Wide center_x, Wide center_y, Wide radius, Wide x0, Wide x1, bool upper) {
  const Wide sign = upper ? -1 : 1;
  WideCurve c;
  c.x0 = x0, c.x1 = x1;
  c.f = [=](Wide x) {
    const Wide u = x - center_x;
    return center_y + sign * std::sqrt(std::max<Wide>(0, (radius - u) * (radius + u)));
  };
  c.slope = [=](Wide x) {
    const Wide u = x - center_x;
    return -sign * u / std::sqrt(std::max<Wide>(0, (radius - u) * (radius + u)));
  };
  c.where_slope_is = [=](Wide slope) {
    const Wide x = center_x - sign * slope * radius / std::sqrt(1 + slope * slope);
    return x >= x0 && x <= x1 ? std::vector<Wide>{x} : std::vector<Wide>{};
  };
  return c;
}

WideCurve wide_polynomial(Wide x0, Wide x1, const Wide (&k)[4]) {
  const Wide c0 = k[0], c1 = k[1], c2 = k[2], c3 = k[3];
  WideCurve c;
  c.x0 = x0, c.x1 = x1;
  c.f = [=](Wide x) {
    const Wide u = x - x0;
    return c0 + u * (c1 + u * (c2 + u * c3));
  };
  c.slope = [=](Wide x) { return c1 + (x - x0) * (2 * c2 + (x - x0) * 3 * c3); };
  c.where_slope_is = [=](Wide slope) {
    std::vector<Wide> all;
    add_quadratic_roots(3 * c3, 2 * c2, c1 - slope, all);
    for (Wide& x : all) x += x0;
    std::erase_if(all, [=](Wide x) { return !(x >= x0 && x <= x1); });
    return all;
  };
  return c;
}

WideCurve wide_sine(Wide x0, Wide x1, Wide middle, Wide amplitude, Wide wavelength, Wide origin) {
  const Wide two_pi = 6.283185307179586476925286766559005768L;
  WideCurve c;
  c.x0 = x0, c.x1 = x1;
  c.f = [=](Wide x) {
    const Wide turns = (x - origin) / wavelength;
    return middle + amplitude * std::sin(two_pi * (turns - std::round(turns)));
  };
  c.slope = [=](Wide x) {
    const Wide turns = (x - origin) / wavelength;
    return amplitude * two_pi / wavelength * std::cos(two_pi * (turns - std::round(turns)));
  };
  c.where_slope_is = [=](Wide slope) {
    std::vector<Wide> all;
    const Wide cosine = slope * wavelength / (two_pi * amplitude);
    if (!(cosine >= -1 && cosine <= 1)) return all;
    const Wide turn = std::acos(cosine) / two_pi;
    for (Wide wave = std::floor((x0 - origin) / wavelength) - 1; origin + wave * wavelength <= x1; ++wave) {
      for (const Wide x : {origin + (wave + turn) * wavelength, origin + (wave + 1 - turn) * wavelength}) {
        if (x >= x0 && x <= x1) all.push_back(x);
      }
    }
    return all;
  };
  return c;
}

WideCurve with_welded_ends(const WideCurve& curve) {
  const auto on_grid = [](Wide v) { return std::round(v * 256) / 256; };
  const Wide x0 = on_grid(curve.x0), x1 = on_grid(curve.x1);
  const auto width_at = [&](Wide x) -> Wide {
    // Heights of the grid that were computed differ from it by rounding alone.
    if (x == on_grid(x) && std::abs(curve.f(x) - on_grid(curve.f(x))) < 1e-15L) return 0;
    const Wide slope = curve.slope(on_grid(x)), width = on_grid(0.25L / std::sqrt(1 + slope * slope));
    return std::min(std::max<Wide>(width, 1.0L / 256), (x1 - x0) / 2);
  };
  const Wide from = x0 + width_at(curve.x0), to = x1 - width_at(curve.x1);
  const Wide y0 = on_grid(curve.f(curve.x0)), y1 = on_grid(curve.f(curve.x1));
  WideCurve welded = curve;
  welded.x0 = x0, welded.x1 = x1;
  welded.f = [=](Wide x) {
    if (x < from) return y0 + (curve.f(from) - y0) * ((x - x0) / (from - x0));
    if (x > to) return y1 + (curve.f(to) - y1) * ((x1 - x) / (x1 - to));
    return curve.f(x);
  };
  welded.where_slope_is = [=](Wide slope) {
    std::vector<Wide> all = curve.where_slope_is(slope);
    std::erase_if(all, [&](Wide x) { return x < from || x > to; });
    if (from > x0) all.push_back(from);
    if (to < x1) all.push_back(to);
    return all;
  };
  return welded;
}

bool meets(const WideCurve& curve, const WideBox& box) { return relation(curve, box) == Relation::inside; }

std::optional<Wide> cast(const WideCurve& curve, const WideBox& box, Wide dx, Wide dy, Wide reach) {
  const std::vector<Wide> times = times_of_change(curve, box, dx, dy);
  Relation before = relation(curve, box);
  if (before == Relation::inside) {  // perhaps only slightly inside
    before = relation(curve, box.grown(-reach));
  }
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    if (!(times[i] < times[i + 1])) continue;
    const Wide middle = times[i] + (times[i + 1] - times[i]) / 2;
    const Relation now = relation(curve, box.moved(middle * dx, middle * dy));
    if (now == Relation::inside && before != Relation::inside) {
      const bool stops =
          curve.stops == WideCurve::Stops::everywhere ||
          before == (curve.stops == WideCurve::Stops::from_above ? Relation::above : Relation::below);
      if (stops) return times[i];
    }
    before = now;
  }
  return {};
}

std::optional<Wide> floor_below(const WideCurve& curve, const WideBox& box) {
  const Wide from = std::max(curve.x0, box.x), to = std::min(curve.x1, box.x + box.w);
  if (!(from <= to)) return {};
  const Wide y = curve.range(from, to).least;
  return y >= box.y + box.h ? std::optional<Wide>(y) : std::nullopt;
}

}  // namespace talus::reference
