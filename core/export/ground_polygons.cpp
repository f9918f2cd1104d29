// Each column of cells is cut into slabs in which no two lines cross. In a slab the ground is a list of
// trapezoids. At the sides of a slab, ground without ground beside it gets a wall. The walls end at exactly
// the heights of the trapezoids, so that the rings are closed whatever was rounded.
#include "ground_polygons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <utility>

#include "../collision/tile_outlines.h"

namespace talus {
namespace {

constexpr double kMergeShare = 0.7;  // share of the time for merging; linking takes the rest
constexpr double kTouching = 1e-9;   // px; closer things touch, and so do lines that cross there

// Rounds to 1/256 px; just above a half up, so that two computations of one point agree.
double snapped(double at) { return std::floor(at * 256 + 0.5 + 1e-6) / 256; }

// The line that an edge was cut from, which shows what belongs together.
struct LineKey {
  double base_x = 0, base_y = 0, slope = 0, slope_rest = 0;
  friend bool operator==(const LineKey&, const LineKey&) = default;
};

struct Edge {
  Vec2 from, to;
  LineKey line;  // unset for a wall
  bool is_wall = false;
  bool used = false;  // whether it is in a ring
};

// Sorted by the column of cells in which an edge begins, and there by its first point. The right side of a
// column belongs to the next one. So all edges are sorted though the whole is never moved in memory.
using EdgeColumns = std::vector<std::vector<Edge>>;

bool lies_before(Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

// The column of cells that an x is in; side: px, of each. Ends of lines are whole parts of kWeldParts, so
// that no quotient of them rounds up to the next column.
std::size_t column_of(double x, int side) { return static_cast<std::size_t>(x / side); }

// Ground between two lines, in one column of cells; px from their corners.
struct Body {
  std::span<const OutlineLine> top, bottom;
  Vec2 top_corner, bottom_corner;
  std::span<const double> joints;  // x inside of the column, relative to the corners
  double highest, lowest;          // px on the map
  double left, right;              // px on the map: the sides of the column, or closer
  bool covers(double x) const { return left < x && x < right; }
};

// A side of a slab.
struct Side {
  double x;
  bool crossed;  // lines cross here, so its points are rounded
  Vec2 point(const OutlineLine& line) const {
    const double y = line.at(x), near = snapped(y);
    const bool rounded = crossed || std::abs(y - near) < 1e-6;
    return {crossed ? snapped(x) : x, rounded ? near : y};
  }
};

// On the map.
OutlineLine line_at(std::span<const OutlineLine> lines, Vec2 corner, double x) {
  const auto ends_after = [x, corner](const OutlineLine& line) { return x < line.x1 + corner.x; };
  const auto found = std::find_if(lines.begin(), lines.end(), ends_after);
  return (found == lines.end() ? lines.back() : *found).moved(corner);
}

class Merger {
 public:
  Merger(const TerrainSource& ground, std::size_t most_sides)
      : ground_(ground), most_sides_(most_sides), outlines_(ground.shapes, ground.tile) {
    flat_.push_back({0, 0, 1.0 * ground.tile.width, 0, 0, 0, 0, 0});
    for (const TileNumber tile : ground.cells) {
      const TileOutline& shape = outlines_[tile];
      if (!shape.line) continue;
      widest_ = std::max(widest_, shape.first_column + shape.width());
      to_the_left_ = std::max(to_the_left_, -shape.first_column);
    }
  }

  FormatResult<EdgeColumns> merge() {
    const int columns = ground_.width + widest_;
    EdgeColumns merged;
    for (column_ = 0; column_ < columns; ++column_) {
      if (ground_.progress && !ground_.progress(kMergeShare * column_ / columns)) return EdgeColumns();
      merge_column(column_);
      if (sides_ > most_sides_)
        return tl::unexpected(FormatError{"", "has ground with more than " + std::to_string(most_sides_) +
                                                  " sides in its outline, the most that can be exported: "
                                                  "join separate tiles, or make the map smaller"});
      std::stable_sort(edges_.begin(), edges_.end(),
                       [](const Edge& a, const Edge& b) { return lies_before(a.from, b.from); });
      merged.emplace_back(edges_.begin(), edges_.end());
      edges_.swap(next_edges_);
      next_edges_.clear();
    }
    merged.push_back(std::move(edges_));
    return merged;
  }

 private:
  // Where ground begins (+1) or ends (-1) along a side, in the slab on its left; reversed for the slab on its
  // right.
  struct Turn {
    double y;
    int change;
  };
  struct Trapezoid {
    OutlineLine top, bottom;
    double highest, lowest;  // in the middle of the slab
  };

  const TileOutline& outline(int x, int y) const {
    return outlines_[ground_.cells[static_cast<std::size_t>(y) * ground_.width + x]];
  }

  void merge_column(int column) {
    std::vector<Body> bodies = bodies_of(column);
    std::stable_sort(bodies.begin(), bodies.end(),
                     [](const Body& a, const Body& b) { return a.highest < b.highest; });
    const double x0 = outlines_.x_of(column);
    std::vector<Turn> left = std::exchange(right_side_, {});
    for (std::size_t begin = 0; begin < bodies.size();) {
      double lowest = bodies[begin].lowest;
      std::size_t end = begin + 1;
      for (; end < bodies.size() && bodies[end].highest <= lowest; ++end)
        lowest = std::max(lowest, bodies[end].lowest);
      merge_group({bodies.data() + begin, end - begin}, x0, left);
      begin = end;
    }
    put_walls({x0, false}, left);
  }

  // The runs of full tiles in a column, and the lines of slopes and profiles.
  std::vector<Body> bodies_of(int column) const {
    std::vector<Body> bodies;
    const auto corner = [this](int x, int y) { return Vec2{outlines_.x_of(x), outlines_.y_of(y)}; };
    const double left = outlines_.x_of(column), right = outlines_.x_of(column + 1);
    for (int y = 0, run = 0; y <= ground_.height && column < ground_.width; ++y) {
      if (y < ground_.height && outline(column, y).full) continue;
      const Vec2 top = corner(column, run), bottom = corner(column, y);
      if (run < y) bodies.push_back({flat_, flat_, top, bottom, {}, top.y, bottom.y, left, right});
      run = y + 1;
    }
    for (int y = 0; y < ground_.height; ++y) {
      const int first = std::max(0, column - widest_ + 1);
      const int last = std::min(column + to_the_left_, ground_.width - 1);
      for (int x = first; x <= last; ++x) {
        const TileOutline& shape = outline(x, y);
        if (!shape.line) continue;
        const Vec2 at = corner(x, y);
        for (const TileColumn& part : shape.in_column(column - x)) {
          if (part.one_way || part.highest == part.lowest) continue;  // a line with nothing under it
          bodies.push_back({part.top, part.bottom, at, at, part.joints, at.y + part.highest,
                            at.y + part.lowest, at.x + part.left, at.x + part.right});
        }
      }
    }
    return bodies;
  }

  void merge_group(std::span<const Body> bodies, double x0, std::vector<Turn>& left) {
    const std::vector<Side> sides = sides_of(bodies, x0);
    std::vector<Turn> before, after;
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
      merge_slab(bodies, sides[i], sides[i + 1], before, after);
      if (i == 0)
        left.insert(left.end(), before.begin(), before.end());
      else
        put_walls(sides[i], before);
      before = std::exchange(after, {});
    }
    right_side_.insert(right_side_.end(), before.begin(), before.end());
  }

  // Its top and its bottom line.
  static std::array<OutlineLine, 2> lines_at(const Body& body, double x) {
    return {line_at(body.top, body.top_corner, x), line_at(body.bottom, body.bottom_corner, x)};
  }

  // The places where a line begins, or two lines cross; and the sides of the column.
  std::vector<Side> sides_of(std::span<const Body> bodies, double x0) const {
    std::vector<double> ends = {x0, x0 + ground_.tile.width};
    for (const Body& body : bodies) {
      for (const double joint : body.joints) ends.push_back(body.top_corner.x + joint);
      ends.insert(ends.end(), {body.left, body.right});
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    std::vector<Side> sides;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      sides.push_back({ends[i], false});
      std::vector<double> crossings = crossings_between(bodies, ends[i], ends[i + 1]);
      std::sort(crossings.begin(), crossings.end());
      for (const double x : crossings)
        if (x - sides.back().x > kTouching) sides.push_back({x, true});
    }
    sides.push_back({ends.back(), false});
    return sides;
  }

  // Where lines of two bodies cross. The bodies come from the top down; all lines are straight from x0 to x1.
  static std::vector<double> crossings_between(std::span<const Body> bodies, double x0, double x1) {
    struct Line {
      double y0, y1;
      std::size_t body;
      double lowest;  // of the body
    };
    std::vector<Line> lines;
    std::vector<double> crossings;
    for (std::size_t body = 0; body < bodies.size(); ++body) {
      std::erase_if(lines, [&](const Line& above) { return above.lowest <= bodies[body].highest; });
      if (!bodies[body].covers((x0 + x1) / 2)) continue;
      for (const OutlineLine& line : lines_at(bodies[body], (x0 + x1) / 2)) {
        const Line here{line.at(x0), line.at(x1), body, bodies[body].lowest};
        for (const Line& other : lines) {
          const double before = here.y0 - other.y0, after = here.y1 - other.y1;
          if (other.body == body || !(before * after < 0)) continue;
          const double x = x0 + (x1 - x0) * (before / (before - after));
          if (x - x0 > kTouching && x1 - x > kTouching) crossings.push_back(x);
        }
        lines.push_back(here);
      }
    }
    return crossings;
  }

  // Adds the floors and ceilings of the ground between two sides, and what it has at these sides.
  void merge_slab(std::span<const Body> bodies, const Side& from, const Side& to, std::vector<Turn>& left,
                  std::vector<Turn>& right) {
    const double middle = (from.x + to.x) / 2;
    std::vector<Trapezoid> parts;
    for (const Body& body : bodies) {
      if (!body.covers(middle)) continue;
      const auto [top, bottom] = lines_at(body, middle);
      const Trapezoid part{top, bottom, top.at(middle), bottom.at(middle)};
      if (part.lowest - part.highest > kTouching) parts.push_back(part);
    }
    std::stable_sort(parts.begin(), parts.end(),
                     [](const Trapezoid& a, const Trapezoid& b) { return a.highest < b.highest; });
    for (std::size_t i = 0; i < parts.size();) {
      Trapezoid part = parts[i++];
      for (; i < parts.size() && parts[i].highest <= part.lowest + kTouching; ++i)
        if (parts[i].lowest > part.lowest) part.lowest = parts[i].lowest, part.bottom = parts[i].bottom;
      const Vec2 top0 = from.point(part.top), top1 = to.point(part.top);
      const Vec2 bottom0 = from.point(part.bottom), bottom1 = to.point(part.bottom);
      put_edge({top0, top1, key_of(part.top)});
      put_edge({bottom1, bottom0, key_of(part.bottom)});
      left.insert(left.end(), {{top0.y, -1}, {bottom0.y, 1}});
      right.insert(right.end(), {{top1.y, 1}, {bottom1.y, -1}});
    }
  }

  // Ground only on the left of a side has a wall there that goes down; ground only on the right has one that
  // goes up.
  void put_walls(const Side& side, std::vector<Turn>& turns) {
    std::sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) { return a.y < b.y; });
    const double x = side.crossed ? snapped(side.x) : side.x;
    int depth = 0;
    double from = 0;
    for (std::size_t i = 0; i < turns.size();) {
      const double y = turns[i].y;
      int change = 0;
      for (; i < turns.size() && turns[i].y == y; ++i) change += turns[i].change;
      for (int n = 0; n < depth; ++n) put_edge({{x, from}, {x, y}, {}, true});
      for (int n = 0; n < -depth; ++n) put_edge({{x, y}, {x, from}, {}, true});
      depth += change;
      from = y;
    }
  }

  static LineKey key_of(const OutlineLine& line) {
    return {line.base_x, line.base_y, line.slope, line.slope_rest};
  }
  void put_edge(const Edge& edge) {
    if (edge.from == edge.to || ++sides_ > most_sides_) return;
    const bool is_here = column_of(edge.from.x, ground_.tile.width) == static_cast<std::size_t>(column_);
    (is_here ? edges_ : next_edges_).push_back(edge);
  }

  const TerrainSource& ground_;
  std::size_t most_sides_;
  TileOutlines outlines_;
  int widest_ = 1;                 // columns that a shape reaches over, from its own one to the right
  int to_the_left_ = 0;            // columns that a shape reaches over on its left
  std::vector<OutlineLine> flat_;  // only the top of a full tile
  std::vector<Turn> right_side_;
  std::size_t sides_ = 0;                 // sides so far; those over the limit are not kept
  int column_ = 0;                        // the column that is merged
  std::vector<Edge> edges_, next_edges_;  // edges that begin in it, and at its right side
};

// Links edges to rings. At each point as many edges begin as end.
class RingLinker {
 public:
  // side: px, of a column.
  RingLinker(EdgeColumns columns, int side) : columns_(std::move(columns)), side_(side) {}

  std::vector<GroundPolygon> link(const std::function<bool(double)>& progress) {
    std::vector<GroundPolygon> polygons;
    for (std::size_t column = 0; column < columns_.size(); ++column) {
      const double done = static_cast<double>(column) / static_cast<double>(columns_.size());
      if (progress && !progress(kMergeShare + (1 - kMergeShare) * done)) return {};
      for (Edge& first : columns_[column]) {
        if (first.used) continue;
        GroundPolygon polygon = polygon_of(ring_from(first));
        const double area = doubled_area(polygon.points);
        polygon.is_hole = area < 0;
        if (area != 0) polygons.push_back(std::move(polygon));
      }
    }
    return polygons;
  }

 private:
  const std::vector<const Edge*>& ring_from(Edge& first) {
    ring_.clear();
    Edge* at = &first;
    do {
      at->used = true;
      ring_.push_back(at);
      at = next_of(*at, first);
    } while (at != &first);
    return ring_;
  }

  // If several edges begin here, takes the rightmost turn, so that ground which touches in a corner stays
  // apart.
  Edge* next_of(const Edge& edge, Edge& first) {
    std::vector<Edge>& edges = columns_[column_of(edge.to.x, side_)];
    auto next = std::lower_bound(edges.begin(), edges.end(), edge.to,
                                 [](const Edge& e, Vec2 point) { return lies_before(e.from, point); });
    const auto begins_here = [&](auto at) { return at != edges.end() && at->from == edge.to; };
    if (begins_here(next) && !begins_here(next + 1)) return next->used ? &first : &*next;
    Edge* best = &first;
    double most = -10;  // less than any angle
    for (; begins_here(next); ++next) {
      if (next->used && &*next != &first) continue;
      const Vec2 in = edge.to - edge.from, out = next->to - next->from;
      const double angle = std::atan2(in.x * out.y - in.y * out.x, dot(in, out));
      if (angle > most) most = angle, best = &*next;
    }
    return best;
  }

  static GroundPolygon polygon_of(const std::vector<const Edge*>& ring) {
    GroundPolygon polygon;
    const Edge* before = ring.back();
    for (const Edge* edge : ring) {
      const bool same_line = !edge->is_wall && !before->is_wall && edge->line == before->line;
      if (!same_line && !is_straight(before->from, edge->from, edge->to))
        polygon.points.push_back(edge->from);
      before = edge;
    }
    return polygon;
  }

  static double doubled_area(const std::vector<Vec2>& points) {
    double area = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2 a = points[i] - points[0], b = points[(i + 1) % points.size()] - points[0];
      area += a.x * b.y - a.y * b.x;
    }
    return area;
  }

  EdgeColumns columns_;
  int side_;                       // px, of a column
  std::vector<const Edge*> ring_;  // the ring that is being linked
};

}  // namespace

bool is_straight(Vec2 a, Vec2 b, Vec2 c) {
  const Vec2 in = b - a, out = c - b;
  return in.x * out.y == in.y * out.x && dot(in, out) > 0;
}

FormatResult<std::vector<GroundPolygon>> ground_polygons(const TerrainSource& ground,
                                                         std::size_t most_sides) {
  FormatResult<EdgeColumns> sides = Merger(ground, most_sides).merge();
  if (!sides) return tl::unexpected(sides.error());
  return RingLinker(*std::move(sides), ground.tile.width).link(ground.progress);
}

}  // namespace talus
