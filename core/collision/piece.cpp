// Sine and cosine from additions and multiplications alone, so that every machine gets the same bits.
#include <talus/collision/piece.h>

namespace talus {
namespace {

// Taylor series of sin(z)/z and cos(z) in z*z; for |z| <= pi/4 the first term left out is below 2^-60.
template <class Real>
Real sine_series(Real z) {
  const Real q = z * z;
  Real sum = 0;
  for (const double k : {16 * 17., 14 * 15., 12 * 13., 10 * 11., 8 * 9., 6 * 7., 4 * 5., 2 * 3.}) {
    sum = (1 - sum) * q * static_cast<Real>(1 / k);
  }
  return z * (1 - sum);
}

template <class Real>
Real cosine_series(Real z) {
  const Real q = z * z;
  Real sum = 0;
  for (const double k : {15 * 16., 13 * 14., 11 * 12., 9 * 10., 7 * 8., 5 * 6., 3 * 4., 1 * 2.}) {
    sum = (1 - sum) * q * static_cast<Real>(1 / k);
  }
  return 1 - sum;
}

}  // namespace

template <class Real>
Real sine_of_turns(Real turns) {
  const Real size = std::abs(turns);
  const Real z = CurveStretch<Real>::kTwoPi * (size <= Real(0.125) ? size : Real(0.25) - size);
  return std::copysign(size <= Real(0.125) ? sine_series(z) : cosine_series(z), turns);
}

template <class Real>
Real cosine_of_turns(Real turns) {
  return sine_of_turns(Real(0.25) - std::abs(turns));
}

template double sine_of_turns(double);
template double cosine_of_turns(double);
template float sine_of_turns(float);
template float cosine_of_turns(float);

}  // namespace talus
