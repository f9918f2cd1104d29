// Where a curve begins and ends.
#pragma once

#include <talus/collision/shape.h>

namespace talus {

struct CurveSpan {
  Vec2 from, to;  // px
};
// Of a polyline without heights, at height 0; of numbers that are none, the same.
CurveSpan span_of(const Curve& curve);

}  // namespace talus
