// Random ground for the property tests, and the same ground for the reference.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include <talus/collision/terrain.h>
#include "reference/exact_ground.h"
#include "reference/wide_curve.h"

namespace talus {

// The seed determines everything, so that a failure can be repeated from one number.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  double in(double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(engine_); }
  int up_to(int last) { return std::uniform_int_distribution<int>(0, last)(engine_); }
  bool one_in(int n) { return up_to(n - 1) == 0; }
  // A multiple of 1/parts.
  double step(double lo, double hi, double parts) { return std::round(in(lo, hi) * parts) / parts; }
  template <class T>
  void shuffle(std::vector<T>& values) {
    std::shuffle(values.begin(), values.end(), engine_);
  }

 private:
  std::mt19937_64 engine_;
};

// 8x8, 16x16, 24x24 or 18x12 px.
inline TileSize any_tile_size(Dice& dice) {
  constexpr TileSize kSizes[] = {{8, 8}, {16, 16}, {24, 24}, {18, 12}};
  return kSizes[dice.up_to(3)];
}

// A map and curves. Shapes stay inside the borders, and no two begin or end in the same cell, so that the map
// can be mirrored.
struct RandomGround {
  int width = 0, height = 0;  // cells
  TileSize tile;
  std::vector<TileNumber> cells;
  std::vector<TileShape> shapes = std::vector<TileShape>(256);
  std::vector<Curve> curves;

  double right() const { return 1.0 * width * tile.width; }     // px
  double bottom() const { return 1.0 * height * tile.height; }  // px
  Terrain compile() const;
  RandomGround mirrored() const;                    // about the vertical through the middle of the map
  RandomGround moved(int columns, int rows) const;  // to the right and down, in a larger map
  reference::ExactGround exact() const;             // tiles, segments and polylines
  std::vector<reference::WideCurve> wide() const;   // the other curves, one for each side that stops
};

struct GroundKinds {
  bool shapes = true, one_way = false, segments = false, curves = false, polygons = false;
};
RandomGround random_ground(Dice& dice, int width, int height, GroundKinds kinds);

}  // namespace talus
