// The reference for curves: long double, brackets and bisection, and no code of the core. It knows of a curve
// only f, f' and where f' has a given value.
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
  std::function<std::vector<Wide>(Wide slope)> where_slope_is;  // of x0..x1, any order

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

// Whether the curve is inside of the box.
bool meets(const WideCurve& curve, const WideBox& box);

// The earliest time from which on the curve is inside of the moving box, as ExactGround::cast has it.
// Touching at most `reach` px deep at the beginning counts as coming from where the box touches.
std::optional<Wide> cast(const WideCurve& curve, const WideBox& box, Wide dx, Wide dy, Wide reach);

// The highest point of the curve within the box's width, if it is not above its bottom.
std::optional<Wide> floor_below(const WideCurve& curve, const WideBox& box);

}  // namespace talus::reference
