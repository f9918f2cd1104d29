#include "bench_kernel.h"

namespace talus {
BenchKernel::BenchKernel(const Level& level, const State& start)
    : width_(level.map.width()),
      height_(level.map.height()),
      tile_w_(level.map.tile_size().width),
      tile_h_(level.map.tile_size().height),
      cells_in_px_x_(1 / tile_w_),
      cells_in_px_y_(1 / tile_h_),
      tuning_(level.tuning.shared) {
  roles_.reserve(level.map.cells().size());
  for (const TileNumber tile : level.map.cells().tiles()) {
    roles_.push_back(role_of(level.tile_flags(tile), level.roles));
  }
  for (const Body& body : start.bodies) {
    balls_.push_back({body.box.x, body.box.y, body.velocity.x, body.velocity.y});
  }
}

TileRole BenchKernel::role_at(double x, double y) const {
  const bool is_inside = x >= 0 && y >= 0 && x < width_ * tile_w_ && y < height_ * tile_h_;
  if (!is_inside) return TileRole::none;
  const auto column = static_cast<int>(x * cells_in_px_x_);
  const auto row = static_cast<int>(y * cells_in_px_y_);
  return roles_[static_cast<std::size_t>(row) * width_ + column];
}

bool BenchKernel::is_solid_box(double x, double y) const {
  const double right = x + last_px(tile_w_), bottom = y + last_px(tile_h_);
  return role_at(x, y) == TileRole::solid || role_at(right, y) == TileRole::solid ||
         role_at(x, bottom) == TileRole::solid || role_at(right, bottom) == TileRole::solid;
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
  const double centre = ball.x + tile_w_ / 2;
  const double foot = ball.y + last_px(tile_h_);
  const TileRole role = role_at(centre, foot);
  if (role != TileRole::up_slope && role != TileRole::down_slope) return;
  const double along = centre - tile_w_ * static_cast<int>(centre * cells_in_px_x_);
  const double top = tile_h_ * static_cast<int>(foot * cells_in_px_y_);
  const double along_or_rest = role == TileRole::up_slope ? tile_w_ - along : along;
  const double rise = along_or_rest * cells_in_px_x_ * tile_h_ / 2;
  if (foot > top + rise) {
    ball.y = top + rise - tile_h_;
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
