// Points and boxes. The plane has x to the right and y down; lengths are in pixels.
#pragma once

namespace talus {

struct Vec2 {
  double x = 0;
  double y = 0;
  friend bool operator==(const Vec2&, const Vec2&) = default;
};

inline Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
inline Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
inline Vec2 operator*(Vec2 a, double s) { return {a.x * s, a.y * s}; }

// An axis-aligned bounding box (AABB): its top-left corner and its size.
struct Rect {
  double x = 0;
  double y = 0;
  double w = 0;
  double h = 0;
  Vec2 position() const { return {x, y}; }
  double right() const { return x + w; }
  double bottom() const { return y + h; }
  friend bool operator==(const Rect&, const Rect&) = default;
};

// A cell of a grid, or a tile of a map: column and row.
struct Cell {
  int x = 0;
  int y = 0;
  friend bool operator==(const Cell&, const Cell&) = default;
};

}  // namespace talus
