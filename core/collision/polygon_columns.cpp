// A vertical line through a polygon meets an even number of its sides, and the ground is between the first
// and the second, the third and the fourth, and so on. Between two neighbouring points in x, the same sides
// are met everywhere.
#include "polygon_columns.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "twofold.h"

namespace talus {
namespace {

Vec2 point_of(const TileShape& polygon, std::size_t i) {
  return polygon.lines.empty() ? weld(polygon.points[i]) : polygon.points[i];
}

struct Extent {
  double left, right;
};
Extent extent_of(const TileShape& polygon) {
  const auto [least, most] = std::minmax_element(polygon.points.begin(), polygon.points.end(),
                                                 [](Vec2 a, Vec2 b) { return a.x < b.x; });
  return {weld(least->x), weld(most->x)};
}

// All sides but the vertical ones, from left to right.
std::vector<OutlineLine> sides_of(const TileShape& polygon) {
  std::vector<OutlineLine> sides;
  for (std::size_t i = 0; i < polygon.points.size(); ++i) {
    const Vec2 a = point_of(polygon, i), b = point_of(polygon, (i + 1) % polygon.points.size());
    if (a.x == b.x) continue;
    const Vec2 &from = a.x < b.x ? a : b, &to = a.x < b.x ? b : a;
    OutlineLine side = line_between(from, to);
    if (!polygon.lines.empty()) {
      side = line_between(polygon.lines[i].from, polygon.lines[i].to);
      side.x0 = from.x, side.y0 = from.y, side.x1 = to.x, side.y1 = to.y;
    }
    sides.push_back(side);
  }
  return sides;
}

// The places where the parts may change: at points, and at the borders of columns.
std::vector<double> cuts_of(const TileShape& polygon, ColumnSpan columns, TileSize tile) {
  std::vector<double> cuts;
  for (std::size_t i = 0; i < polygon.points.size(); ++i) cuts.push_back(point_of(polygon, i).x);
  for (int column = columns.first; column < columns.last; ++column)
    cuts.push_back(static_cast<double>(column + 1) * tile.width);
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

// Whether a line is above another at an x that both have. Exact where points are welded: the coordinates are
// whole numbers of 1/512 px, and small.
bool is_above(const OutlineLine& a, const OutlineLine& b, double x) {
  const auto scaled = [x](const OutlineLine& line, const OutlineLine& other) {
    const double height = line.y0 * (line.x1 - line.x0) + (line.y1 - line.y0) * (x - line.x0);
    return Twofold<double>(height) * Twofold<double>(other.x1 - other.x0);
  };
  const Twofold<double> ours = scaled(a, b), theirs = scaled(b, a);
  return ours.high != theirs.high ? ours.high < theirs.high : ours.low < theirs.low;
}

using Pair = std::pair<const OutlineLine*, const OutlineLine*>;  // top and bottom

// The ground between two cuts, from the top.
std::vector<Pair> pairs_between(const std::vector<OutlineLine>& sides, double x0, double x1) {
  std::vector<const OutlineLine*> met;
  for (const OutlineLine& side : sides) {
    if (side.x0 <= x0 && side.x1 >= x1) met.push_back(&side);
  }
  const double middle = (x0 + x1) / 2;
  std::sort(met.begin(), met.end(),
            [middle](const OutlineLine* a, const OutlineLine* b) { return is_above(*a, *b, middle); });
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i + 1 < met.size(); i += 2) pairs.emplace_back(met[i], met[i + 1]);
  return pairs;
}

TileColumn part_between(const Pair& pair, double x0, double x1) {
  const auto& [top, bottom] = pair;
  TileColumn part;
  part.top = {*top};
  part.bottom = {*bottom};
  part.left = x0, part.right = x1;
  part.highest = std::min(top->at(x0), top->at(x1));
  part.lowest = std::max(bottom->at(x0), bottom->at(x1));
  return part;
}

}  // namespace

ColumnSpan columns_of(const TileShape& polygon, TileSize tile) {
  const auto [left, right] = extent_of(polygon);
  return {static_cast<int>(std::floor(left / tile.width)),
          static_cast<int>(std::ceil(right / tile.width)) - 1};
}

void cut_polygon(const TileShape& polygon, int number, TileSize tile, std::vector<TileColumn>& out) {
  struct Open {
    Pair pair;
    double left;
  };
  const std::vector<OutlineLine> sides = sides_of(polygon);
  const std::vector<double> cuts = cuts_of(polygon, columns_of(polygon, tile), tile);
  std::vector<Open> open;
  const auto close = [&](const Open& part, double right) {
    TileColumn& made = out.emplace_back(part_between(part.pair, part.left, right));
    made.one_way = polygon.one_way;
    made.is_floor = polygon.side == TileShape::Side::floor;
    made.polygon = number;
  };
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const bool is_border = std::fmod(cuts[i], tile.width) == 0;
    std::vector<Open> next;
    for (const Pair& pair : pairs_between(sides, cuts[i], cuts[i + 1])) {
      const auto same = std::find_if(open.begin(), open.end(), [&](const Open& o) { return o.pair == pair; });
      const bool goes_on = same != open.end() && !is_border;
      next.push_back({pair, goes_on ? same->left : cuts[i]});
      if (goes_on) open.erase(same);
    }
    for (const Open& part : open) close(part, cuts[i]);
    open = std::move(next);
  }
  for (const Open& part : open) close(part, cuts.back());
}

}  // namespace talus
