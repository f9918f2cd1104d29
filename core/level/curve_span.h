// Where a curve begins and ends.
#pragma once

#include <talus/collision/shape.h>

namespace talus {

struct CurveSpan {
  Vec2 from, to;  // px
};
// A polyline without heights counts as one at height 0, as does a number that is not finite.
CurveSpan span_of(const Curve& curve);

}  // namespace talus
