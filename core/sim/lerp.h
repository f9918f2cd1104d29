// The article's interpolation.
#pragma once

namespace talus {

// From a to b by the share t, in the article's own order of operations: other forms differ in the last bit.
inline double lerp(double a, double b, double t) { return ((1 - t) * a) + (t * b); }

}  // namespace talus
