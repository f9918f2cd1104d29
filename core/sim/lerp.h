// The article's interpolation.
#pragma once

#include <type_traits>

namespace talus {

// Goes from a to b by the share t, in the article's order of operations: other forms differ in the last bit.
template <class Real>
Real lerp(Real a, std::type_identity_t<Real> b, std::type_identity_t<Real> t) {
  return ((1 - t) * a) + (t * b);
}

}  // namespace talus
