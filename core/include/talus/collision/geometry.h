// Points and boxes. The plane has x to the right and y down; lengths are in pixels. Real is double, or
// float where a caller asks for single precision.
#pragma once

#include <type_traits>

namespace talus {

// A point, a motion or a direction. Its numbers may be infinite or NaN; each function says what it does with
// those.
template <class Real>
struct BasicVec2 {
  Real x = 0;  // px, to the right
  Real y = 0;  // px, down
  friend bool operator==(const BasicVec2&, const BasicVec2&) = default;
};
using Vec2 = BasicVec2<double>;  // in double precision

// The sum of two, component by component.
template <class Real>
BasicVec2<Real> operator+(BasicVec2<Real> a, BasicVec2<Real> b) {
  return {a.x + b.x, a.y + b.y};
}
// The way from b to a.
template <class Real>
BasicVec2<Real> operator-(BasicVec2<Real> a, BasicVec2<Real> b) {
  return {a.x - b.x, a.y - b.y};
}
// `a`, s times as long.
template <class Real>
BasicVec2<Real> operator*(BasicVec2<Real> a, std::type_identity_t<Real> s) {
  return {a.x * s, a.y * s};
}
// The dot product: 0 for vectors at a right angle.
template <class Real>
Real dot(BasicVec2<Real> a, BasicVec2<Real> b) {
  return a.x * b.x + a.y * b.y;
}

// An axis-aligned bounding box (AABB): its top-left corner and its size. Each function says which sizes it
// accepts.
template <class Real>
struct BasicRect {
  Real x = 0;                                                        // px, left side
  Real y = 0;                                                        // px, top side
  Real w = 0;                                                        // px, width
  Real h = 0;                                                        // px, height
  BasicVec2<Real> position() const { return {x, y}; }                // px, top-left corner
  Real right() const { return x + w; }                               // px, right side
  Real bottom() const { return y + h; }                              // px, bottom side
  BasicVec2<Real> center() const { return {x + w / 2, y + h / 2}; }  // px
  friend bool operator==(const BasicRect&, const BasicRect&) = default;
};
using Rect = BasicRect<double>;  // in double precision

// A cell of a grid, or a tile of a map: column and row.
struct Cell {
  int x = 0;  // column, from 0 at the left
  int y = 0;  // row, from 0 at the top
  friend bool operator==(const Cell&, const Cell&) = default;
};

}  // namespace talus
