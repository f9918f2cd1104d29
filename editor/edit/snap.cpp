// Finds ends near a point, and rounds.
#include "snap.h"

#include <algorithm>
#include <cmath>

#include "curve_tools.h"

namespace talus {
namespace {

using To = SnappedPoint::To;

constexpr double kEndReach = 6, kTileReach = 2;  // px of the screen

class NearestEnd {
 public:
  NearestEnd(const Level& level, Vec2 point, double reach) : level_(level), point_(point), least_(reach) {}

  void try_curves(int but) {
    for (std::size_t i = 0; i < level_.curves.size(); ++i) {
      const Curve& curve = level_.curves[i].curve;
      if (static_cast<int>(i) == but || problem_of(curve, level_.map)) continue;
      const auto [first, last] = ends_of_curve(curve);
      try_end(first);
      try_end(last);
    }
  }
  // Lines reach up to eight tiles to the right of their cell, and above or below it.
  void try_tiles() {
    const TileMap& map = level_.map;
    const Vec2 far{map.x_of(kMaxShapeTiles) + least_, map.y_of(kMaxShapeTiles) + least_};
    for (Cell at{0, map.row_at(point_.y - far.y)}; at.y <= map.row_at(point_.y + far.y); ++at.y) {
      for (at.x = map.column_at(point_.x - far.x); at.x <= map.column_at(point_.x + far.x); ++at.x) {
        if (map.contains(at)) try_shape(at, shape_of_cell(level_, map.at(at)));
      }
    }
  }
  std::optional<Vec2> found() const { return found_; }

 private:
  void try_shape(Cell cell, const TileShape& shape) {
    if (problem_of(shape, level_.map.tile_size())) return;
    for (const TileShape& part : shape.parts) try_shape(cell, part);
    for (const Vec2 point : shape.points) try_end(level_.map.corner_of(cell) + point);
    if (!has_heights(shape)) return;
    const bool is_floor = shape.side == TileShape::Side::floor;
    const double base = level_.map.y_of(is_floor ? cell.y + 1 : cell.y);
    const auto at = [&](double height) { return is_floor ? base - height : base + height; };
    try_end({level_.map.x_of(cell.x), at(shape.heights.front())});
    try_end({level_.map.x_of(cell.x + shape.tiles), at(shape.heights.back())});
  }
  void try_end(Vec2 end) {
    const double distance = std::hypot(end.x - point_.x, end.y - point_.y);
    if (distance > least_) return;
    least_ = distance;
    found_ = end;
  }

  const Level& level_;
  Vec2 point_;
  double least_;  // px
  std::optional<Vec2> found_;
};

// A coordinate at the border of a tile, if there is one near. side: px, of a tile.
std::optional<double> at_border(double px, int side, double reach) {
  const double border = std::round(px / side) * side;
  return std::abs(px - border) < reach ? std::optional(border) : std::nullopt;
}

}  // namespace

SnappedPoint snap(const Level& level, Vec2 point, const SnapRules& rules) {
  if (rules.off) return {weld(point), To::nothing};
  if (rules.halves) return {{std::round(point.x * 2) / 2, std::round(point.y * 2) / 2}, To::half};
  NearestEnd nearest(level, point, kEndReach / rules.zoom);
  nearest.try_curves(rules.without_curve);
  nearest.try_tiles();
  if (const auto end = nearest.found()) return {*end, To::end};
  const auto [tile_width, tile_height] = level.map.tile_size();
  const auto x = at_border(point.x, tile_width, kTileReach / rules.zoom);
  const auto y = at_border(point.y, tile_height, kTileReach / rules.zoom);
  return {{x.value_or(std::round(point.x)), y.value_or(std::round(point.y))}, x || y ? To::tile : To::pixel};
}

Vec2 onto_map(const TileMap& map, Vec2 point) {
  return {std::clamp(point.x, 0.0, map.px_width()), std::clamp(point.y, 0.0, map.px_height())};
}

}  // namespace talus
