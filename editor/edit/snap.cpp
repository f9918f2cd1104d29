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
    const auto cell = [](double px) { return static_cast<int>(std::floor(px / kTileSize)); };
    const double far = kMaxShapeTiles * kTileSize + least_;
    for (Cell at{0, cell(point_.y - far)}; at.y <= cell(point_.y + far); ++at.y) {
      for (at.x = cell(point_.x - far); at.x <= cell(point_.x + least_); ++at.x) {
        if (level_.map.contains(at)) try_shape(at, shape_of_tile(level_, level_.map.at(at)));
      }
    }
  }
  std::optional<Vec2> found() const { return found_; }

 private:
  void try_shape(Cell cell, const TileShape& shape) {
    if (shape.kind < TileShape::Kind::slope || problem_of(shape)) return;
    const double x = cell.x * kTileSize, y = cell.y * kTileSize;
    const auto at = [&](double height) {
      return shape.side == TileShape::Side::floor ? y + kTileSize - height : y + height;
    };
    try_end({x, at(shape.heights.front())});
    try_end({x + shape.tiles * kTileSize, at(shape.heights.back())});
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

// A coordinate at the border of a tile, if there is one near.
std::optional<double> at_border(double px, double reach) {
  const double border = std::round(px / kTileSize) * kTileSize;
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
  const auto x = at_border(point.x, kTileReach / rules.zoom), y = at_border(point.y, kTileReach / rules.zoom);
  return {{x.value_or(std::round(point.x)), y.value_or(std::round(point.y))}, x || y ? To::tile : To::pixel};
}

Vec2 onto_map(const TileMap& map, Vec2 point) {
  return {std::clamp<double>(point.x, 0, map.width() * kTileSize),
          std::clamp<double>(point.y, 0, map.height() * kTileSize)};
}

}  // namespace talus
