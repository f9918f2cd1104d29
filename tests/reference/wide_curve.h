// The reference for curves: long double, brackets and bisection, and no code of the core. It uses only f, f'
// and the places where f' has a given value.
#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace talus::reference {

using Wide = long double;

struct WideBox {
  Wide x, y, w, h;
  WideBox grown(Wide by) const { return {x - by, y - by, w + 2 * by, h + 2 * by}; }
  WideBox moved(Wide dx, Wide dy) const { return {x + dx, y + dy, w, h}; }
};

// y = f(x), x0 <= x <= x1.
struct WideCurve {
  enum class Stops { everywhere, from_above, from_below };
  Wide x0 = 0, x1 = 0;
  Stops stops = Stops::everywhere;
  std::function<Wide(Wide x)> f;
  std::function<Wide(Wide x)> slope;                            // f'
  std::function<std::vector<Wide>(Wide slope)> where_slope_is;  // in x0..x1, in any order; and at each kink

  // The least and the greatest f between two places.
  struct Range {
    Wide least, greatest;
  };
  Range range(Wide from, Wide to) const;
};

WideCurve wide_arc(Wide center_x, Wide center_y, Wide radius, Wide x0, Wide x1, bool upper);
// c[0] + c[1] u + c[2] u^2 + c[3] u^3, u = x - x0
WideCurve wide_polynomial(Wide x0, Wide x1, const Wide (&c)[4]);
WideCurve wide_sine(Wide x0, Wide x1, Wide middle, Wide amplitude, Wide wavelength, Wide origin);

// The curve as a terrain has it, with its ends on the grid of 1/256 px. Where that puts an end off the curve,
// the last quarter of a px, but at most half of the curve, is a straight line to it.
WideCurve with_welded_ends(const WideCurve& curve);

// Whether the curve is inside the box.
bool meets(const WideCurve& curve, const WideBox& box);

// Returns the earliest time from which on the curve is inside the moving box, as ExactGround::cast does;
// empty if there is none. A box that touches at most `reach` px deep at the beginning counts as outside, on
// the side where it touches.
std::optional<Wide> cast(const WideCurve& curve, const WideBox& box, Wide dx, Wide dy, Wide reach);

// Returns the highest point of the curve within the box's width, if it is not above the box's bottom; empty
// otherwise.
std::optional<Wide> floor_below(const WideCurve& curve, const WideBox& box);

}  // namespace talus::reference
