#include "bench_kernel.h"

namespace talus {
namespace {
constexpr double kLastPixel = kTileSize - 1e-9;  // just inside the far side of a ball's box
}

BenchKernel::BenchKernel(const Level& level, const State& start)
    : width_(level.map.width()), height_(level.map.height()), tuning_(level.tuning.shared) {
  roles_.reserve(level.map.cells().size());
  for (const std::uint8_t tile : level.map.cells()) {
    roles_.push_back(role_of(level.tile_flags(tile), level.roles));
  }
  for (const Body& body : start.bodies) {
    balls_.push_back({body.box.x, body.box.y, body.velocity.x, body.velocity.y});
  }
}

TileRole BenchKernel::role_at(double x, double y) const {
  const bool is_inside = x >= 0 && y >= 0 && x < width_ * kTileSize && y < height_ * kTileSize;
  if (!is_inside) return TileRole::none;
  const auto column = static_cast<int>(x / kTileSize);
  const auto row = static_cast<int>(y / kTileSize);
  return roles_[static_cast<std::size_t>(row) * width_ + column];
}

bool BenchKernel::is_solid_box(double x, double y) const {
  return role_at(x, y) == TileRole::solid || role_at(x + kLastPixel, y) == TileRole::solid ||
         role_at(x, y + kLastPixel) == TileRole::solid ||
         role_at(x + kLastPixel, y + kLastPixel) == TileRole::solid;
}

void BenchKernel::step(Ball& ball) const {
  ball.vy += (tuning_.fall_speed - ball.vy) * tuning_.fall_blend;
  ball.vx -= ball.vx * tuning_.drift_blend;
  if (is_solid_box(ball.x + ball.vx, ball.y)) {
    ball.vx *= -tuning_.wall_bounce;
  } else {
    ball.x += ball.vx;
  }
  if (is_solid_box(ball.x, ball.y + ball.vy)) {
    ball.vy *= -tuning_.floor_bounce;
    ball.vx *= tuning_.floor_grip;
  } else {
    ball.y += ball.vy;
  }
  const double centre = ball.x + kTileSize / 2.0;
  const double foot = ball.y + kLastPixel;
  const TileRole role = role_at(centre, foot);
  if (role != TileRole::up_slope && role != TileRole::down_slope) return;
  const double along = centre - kTileSize * static_cast<int>(centre / kTileSize);
  const double top = kTileSize * static_cast<int>(foot / kTileSize);
  const double rise = (role == TileRole::up_slope ? kTileSize - along : along) / 2;
  if (foot > top + rise) {
    ball.y = top + rise - kTileSize;
    ball.vy *= -tuning_.slope_bounce;
  }
}

void BenchKernel::step() {
  for (Ball& ball : balls_) step(ball);
}

double BenchKernel::checksum() const {
  double sum = 0;
  for (const Ball& ball : balls_) sum += ball.x + ball.y;
  return sum;
}

}  // namespace talus
