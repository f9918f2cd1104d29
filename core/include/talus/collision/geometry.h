// Points and boxes. The plane has x to the right and y down; lengths are in pixels. Real is double, or
// float where a caller asks for single precision.
#pragma once

#include <type_traits>

namespace talus {

template <class Real>
struct BasicVec2 {
  Real x = 0;
  Real y = 0;
  friend bool operator==(const BasicVec2&, const BasicVec2&) = default;
};
using Vec2 = BasicVec2<double>;

template <class Real>
BasicVec2<Real> operator+(BasicVec2<Real> a, BasicVec2<Real> b) {
  return {a.x + b.x, a.y + b.y};
}
template <class Real>
BasicVec2<Real> operator-(BasicVec2<Real> a, BasicVec2<Real> b) {
  return {a.x - b.x, a.y - b.y};
}
template <class Real>
BasicVec2<Real> operator*(BasicVec2<Real> a, std::type_identity_t<Real> s) {
  return {a.x * s, a.y * s};
}
template <class Real>
Real dot(BasicVec2<Real> a, BasicVec2<Real> b) {
  return a.x * b.x + a.y * b.y;
}

// An axis-aligned bounding box (AABB): its top-left corner and its size.
template <class Real>
struct BasicRect {
  Real x = 0;
  Real y = 0;
  Real w = 0;
  Real h = 0;
  BasicVec2<Real> position() const { return {x, y}; }
  Real right() const { return x + w; }
  Real bottom() const { return y + h; }
  BasicVec2<Real> center() const { return {x + w / 2, y + h / 2}; }
  friend bool operator==(const BasicRect&, const BasicRect&) = default;
};
using Rect = BasicRect<double>;

// A cell of a grid, or a tile of a map: column and row.
struct Cell {
  int x = 0;
  int y = 0;
  friend bool operator==(const Cell&, const Cell&) = default;
};

}  // namespace talus
