// BenchKernel: the yardstick of `talus bench`, about the least that balls of a tile's size can cost on a tile
// map. It moves x, then y, by whole frames, looks up tiles in a flat array, and lifts the centre onto slopes.
// It records nothing and is not exact.
#pragma once

#include <cstdint>
#include <vector>

#include <talus/level/level.h>
#include <talus/sim/state.h>

namespace talus {

class BenchKernel {
 public:
  BenchKernel(const Level& level, const State& start);
  void step();
  Vec2 position(std::size_t ball) const { return {balls_[ball].x, balls_[ball].y}; }  // px, top-left corner
  double checksum() const;  // of the positions, so that the compiler cannot leave out any work

 private:
  struct Ball {
    double x, y, vx, vy;
  };
  TileRole role_at(double x, double y) const;
  bool is_solid_box(double x, double y) const;
  void step(Ball& ball) const;

  // Just inside the far side of a ball's box.
  static double last_px(double side) { return side - 1e-9; }

  int width_, height_;                    // cells
  double tile_w_, tile_h_;                // px
  double cells_in_px_x_, cells_in_px_y_;  // 1 / tile_w_, 1 / tile_h_: to multiply by is faster than to divide
  std::vector<TileRole> roles_;           // row by row
  std::vector<Ball> balls_;
  SharedTuning tuning_;
};

}  // namespace talus
