// Finds ends near a point, and rounds.
#include "snap.h"

#include <algorithm>
#include <cmath>

#include "collision/tile_outlines.h"
#include "curve_tools.h"
#include "level/slope_tiles.h"

namespace talus {
namespace {

using To = SnappedPoint::To;

constexpr double kEndReach = 6, kTileReach = 2;  // px of the screen
constexpr double kSlopeEndReach = 0.875;         // of a tile; below it the next slope would miss by a tile
constexpr double kFloorReach = 1.5;  // tiles; a step of one would be a notch where a slope comes down to it

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

// The y of the nearest floor of a slope within kFloorReach of a point at the side of a column; slopes of
// several tiles have one there between their ends.
std::optional<double> floor_near(const Level& level, Vec2 point) {
  const TileMap& map = level.map;
  const TileSize tile = map.tile_size();
  std::optional<double> found;
  double least = kFloorReach * tile.height;
  const int row = map.row_at(point.y), column = map.column_at(point.x);
  for (Cell at{0, row - 1}; at.y <= row + kMaxShapeTiles; ++at.y) {
    for (at.x = column - kMaxShapeTiles; at.x <= column; ++at.x) {
      if (!map.contains(at)) continue;
      const TileShape shape = shape_of_cell(level, map.at(at));
      const double along = point.x - map.x_of(at.x);
      if (!has_heights(shape) || shape.side != TileShape::Side::floor || problem_of(shape, tile)) continue;
      if (along > shape.tiles * tile.width) continue;
      const double y = weld(map.y_of(at.y + 1) - height_of_line(shape, along, tile));
      if (std::abs(y - point.y) > least) continue;
      least = std::abs(y - point.y);
      found = y;
    }
  }
  return found;
}

// Full cells beside the side of a column.
class FullCells {
 public:
  FullCells(const Level& level, double x) : level_(level), column_(level.map.column_at(x)) {}

  // Whether one of the two columns has a floor at the upper side of a row.
  bool have_top(int row) const {
    const auto is_top = [&](Cell cell, Cell above) { return has(cell) && !has_ground(above); };
    return is_top({column_ - 1, row}, {column_ - 1, row - 1}) || is_top({column_, row}, {column_, row - 1});
  }
  // The upper side of the ground that a row is inside of; the row itself if it is not, or if that is more
  // than kMaxCut rows up.
  int top_above(int row) const {
    for (int top = row; top > 0 && row - top <= kMaxCut; --top)
      if (is_open({column_ - 1, top - 1}) || is_open({column_, top - 1})) return top;
    return row;
  }

 private:
  bool has(Cell cell) const {
    return level_.map.contains(cell) && is_full(shape_of_cell(level_, level_.map.at(cell)));
  }
  bool has_ground(Cell cell) const {
    return level_.map.contains(cell) &&
           shape_of_cell(level_, level_.map.at(cell)).kind != TileShape::Kind::none;
  }
  bool is_open(Cell cell) const { return level_.map.contains(cell) && !has(cell); }

  const Level& level_;
  int column_;  // to the right of that side
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

Vec2 snap_slope_end(const Level& level, Vec2 point, double zoom) {
  const TileSize tile = level.map.tile_size();
  const double side = std::min(tile.width, tile.height);
  NearestEnd nearest(level, point, std::max(kEndReach / zoom, kSlopeEndReach * side));
  nearest.try_tiles();
  if (const auto end = nearest.found(); end && std::fmod(end->x, tile.width) == 0) return *end;
  const double x = std::round(point.x / tile.width) * tile.width;
  const int row = static_cast<int>(std::round(point.y / tile.height));
  const FullCells full(level, x);
  const double off = std::abs(level.map.y_of(row) - point.y);
  const auto floor = floor_near(level, {x, point.y});
  if (floor && !(full.have_top(row) && off <= std::abs(*floor - point.y)))
    return onto_map(level.map, {x, *floor});
  const double top = level.map.y_of(full.top_above(row));
  return onto_map(level.map, {x, floor_near(level, {x, top}).value_or(top)});
}

Vec2 onto_map(const TileMap& map, Vec2 point) {
  return {std::clamp(point.x, 0.0, map.px_width()), std::clamp(point.y, 0.0, map.px_height())};
}

}  // namespace talus
