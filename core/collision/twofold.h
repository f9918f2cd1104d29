// Sums and products with twice the precision: a number, and what rounding took from it. For places where a
// small difference of large numbers decides. (T. J. Dekker 1971; D. E. Knuth, The Art of Computer
// Programming, 4.2.2)
#pragma once

#include <cmath>

namespace talus {

// Inlined by force: compilers would call the operators, and a cast would be a thirtieth slower.
template <class Real>
struct Twofold {
  Real high = 0, low = 0;  // the value is their sum

  Twofold() = default;
  Twofold(Real value) : high(value) {}  // NOLINT: a number is one of twice the precision
  Twofold(Real large, Real small) : high(large + small), low(small - (high - large)) {}

  Real rounded() const { return high + low; }
  Twofold operator-() const { return {-high, -low}; }

  [[gnu::always_inline]] friend Twofold operator+(Twofold a, Twofold b) {
    const Real sum = a.high + b.high, part = sum - a.high;
    const Real lost = (a.high - (sum - part)) + (b.high - part);
    return {sum, lost + (a.low + b.low)};
  }
  [[gnu::always_inline]] friend Twofold operator-(Twofold a, Twofold b) { return a + -b; }
  [[gnu::always_inline]] friend Twofold operator*(Twofold a, Twofold b) {
    const Real product = a.high * b.high;
    const Real lost = std::fma(a.high, b.high, -product);
    return {product, lost + (a.high * b.low + a.low * b.high)};
  }
  [[gnu::always_inline]] friend Twofold operator/(Twofold a, Twofold b) {
    const Real quotient = a.high / b.high;
    const Twofold rest = a - b * Twofold(quotient);
    return {quotient, rest.rounded() / b.high};
  }
};

}  // namespace talus
