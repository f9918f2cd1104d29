// Makes ground of every shape. The reference gets what the header of the shapes promises: everything rounded
// to 1/256 px.
#include "random_ground.h"

#include <algorithm>

#include "random_polygons.h"

namespace talus {
namespace {

using reference::Exact;
using reference::Part;
using ShapeKind = TileShape::Kind;

constexpr int kShapeKinds = 12;

TileSize random_tile_size(Dice& dice) {
  constexpr std::array kSides = {1, 3, 12, 16, 18, 24, 32, 256};
  return {kSides[dice.up_to(7)], kSides[dice.up_to(7)]};
}

TileShape random_shape(Dice& dice, TileSize tile, GroundKinds kinds) {
  TileShape shape;
  shape.kind = dice.one_in(3) ? ShapeKind::profile : ShapeKind::slope;
  shape.side = dice.one_in(3) ? TileShape::Side::ceiling : TileShape::Side::floor;
  shape.tiles = dice.one_in(2) ? 1 : 1 + dice.up_to(3);
  shape.one_way = kinds.one_way && dice.one_in(3);
  if (shape.one_way && dice.one_in(3)) return {.kind = ShapeKind::solid, .side = shape.side, .one_way = true};
  const int count = shape.kind == ShapeKind::slope ? 2 : 3 + dice.up_to(4);
  const double side = tile.height, most = dice.one_in(4) ? 3 * side : side;
  const double parts = dice.one_in(3) ? 4096 : 1;  // finer than the rounding of heights
  for (int i = 0; i < count; ++i) {
    shape.heights.push_back(dice.one_in(3) ? dice.up_to(1) * side : dice.step(0, most, parts));
    // A thin line on the bottom border of the map would be in none of its cells.
    if (shape.one_way) shape.heights.back() = std::max(shape.heights.back(), 1.0);
  }
  return shape;
}

struct Area {
  double x0, y0, x1, y1;
};

Curve::Faces random_faces(Dice& dice) {
  return std::array{Curve::Faces::up, Curve::Faces::down, Curve::Faces::both,
                    Curve::Faces::both}[dice.up_to(3)];
}

Curve random_line(Dice& dice, Area area) {
  const double parts = dice.one_in(2) ? 1 : 1024;
  // x is no finer than 1/256 px: a half rounds away from zero, which is the opposite direction in the
  // mirrored map.
  const auto x = [&] { return dice.step(area.x0, area.x1, std::min(parts, 256.0)); };
  const auto y = [&] { return dice.step(area.y0, area.y1, parts); };
  if (dice.one_in(3)) {
    const int count = 1 << (1 + dice.up_to(2));
    Polyline line{.x0 = dice.step(area.x0, area.x1 - 12, 16), .x1 = 0, .ys = {}};
    line.x1 = line.x0 + count * std::max(0.25, std::floor((area.x1 - line.x0) / count * dice.in(0, 4)) / 4);
    const double middle = dice.step(area.y0 + 6, area.y1 - 6, parts);
    for (int i = 0; i <= count; ++i) line.ys.push_back(middle + dice.step(-6, 6, parts));
    return {line, random_faces(dice)};
  }
  Vec2 a{x(), y()}, b{x(), y()};
  if (dice.one_in(4)) b.x = a.x;
  if (dice.one_in(4)) b.y = a.y;
  if (a == b) b.y += 1;
  if (a.x > b.x || (a.x == b.x && a.y > b.y)) std::swap(a, b);
  return {Segment{a, b}, random_faces(dice)};
}

// Points are on the grid of 1/256 px, but for some arcs and sines; slopes and waves are on a grid of powers
// of two.
Curve random_curve(Dice& dice, Area area) {
  const double x0 = dice.step(area.x0, area.x1 - 8, 64);
  const double x1 = x0 + dice.step(4, std::min(40.0, area.x1 - x0), 64);
  const double y = dice.step(area.y0, area.y1, 64), middle = (x0 + x1) / 2, half = (x1 - x0) / 2;
  const double off = dice.one_in(2) ? 0 : dice.in(-0.01, 0.01);
  Curve curve;
  curve.faces = random_faces(dice);
  switch (dice.up_to(3)) {
    case 0: {
      const double radius = std::abs(off) + (dice.one_in(3) ? half : dice.step(half, 3 * half, 64));
      curve.form =
          Arc{{middle + off, y - off}, radius, x0 + off / 3, dice.one_in(3) ? middle : x1, dice.one_in(2)};
      break;
    }
    case 1:
      curve.form = Parabola{{x0, y}, {x1, y + dice.step(-16, 16, 16)}, y + dice.step(-32, 32, 16)};
      break;
    case 2:
      curve.form =
          Cubic{{x0, y}, {x1, y + dice.step(-16, 16, 16)}, dice.step(-3, 3, 16), dice.step(-3, 3, 16)};
      break;
    default: {
      Sine sine{.x0 = x0, .x1 = x1 + off, .middle = y - off};
      sine.amplitude = dice.step(1, 8, 16) * (dice.one_in(2) ? 1 : -1);
      sine.wavelength = dice.step(8, 64, 1);
      sine.origin = middle + dice.step(-32, 32, 64);
      curve.form = sine;
    }
  }
  return curve;
}

// ---- Mirrored and moved ----

Curve mirrored_curve(const Curve& curve, double width) {
  Curve m = curve;
  const auto flip = [width](double& x0, double& x1) {
    std::swap(x0, x1);
    x0 = width - x0, x1 = width - x1;
  };
  struct Flip {
    decltype(flip)& ends;
    double width;
    Curve::Faces& faces;
    void operator()(Segment& s) const {
      if (s.from.x == s.to.x) {  // vertical: its left side becomes its right side
        s.from.x = s.to.x = width - s.from.x;
        if (faces != Curve::Faces::both)
          faces = faces == Curve::Faces::up ? Curve::Faces::down : Curve::Faces::up;
        return;
      }
      ends(s.from.x, s.to.x);
      std::swap(s.from.y, s.to.y);
    }
    void operator()(Arc& a) const {
      ends(a.x0, a.x1);
      a.center.x = width - a.center.x;
    }
    void operator()(Parabola& p) const {
      ends(p.from.x, p.to.x);
      std::swap(p.from.y, p.to.y);
    }
    void operator()(Cubic& c) const {
      ends(c.from.x, c.to.x);
      std::swap(c.from.y, c.to.y);
      std::swap(c.from_slope, c.to_slope);
      c.from_slope = -c.from_slope, c.to_slope = -c.to_slope;
    }
    void operator()(Sine& s) const {
      ends(s.x0, s.x1);
      s.origin = width - s.origin;
      s.amplitude = -s.amplitude;
    }
    void operator()(Polyline& p) const {
      ends(p.x0, p.x1);
      std::reverse(p.ys.begin(), p.ys.end());
    }
  };
  std::visit(Flip{flip, width, m.faces}, m.form);
  return m;
}

Curve moved_curve(const Curve& curve, Vec2 by) {
  struct Move {
    Vec2 by;
    void operator()(Segment& s) const { s.from = s.from + by, s.to = s.to + by; }
    void operator()(Arc& a) const { a.center = a.center + by, a.x0 += by.x, a.x1 += by.x; }
    void operator()(Parabola& p) const { p.from = p.from + by, p.to = p.to + by, p.control_y += by.y; }
    void operator()(Cubic& c) const { c.from = c.from + by, c.to = c.to + by; }
    void operator()(Sine& s) const { s.x0 += by.x, s.x1 += by.x, s.origin += by.x, s.middle += by.y; }
    void operator()(Polyline& p) const {
      p.x0 += by.x, p.x1 += by.x;
      for (double& y : p.ys) y += by.y;
    }
  };
  Curve m = curve;
  std::visit(Move{by}, m.form);
  return m;
}

// ---- For the reference ----

Exact rounded(double value) { return reference::rounded_to_256th(value); }

void add_shape(const TileShape& shape, TileSize tile, int column, int row, std::vector<Part>& parts) {
  for (const TileShape& part : shape.parts) add_shape(part, tile, column, row, parts);
  if (shape.kind == ShapeKind::group) return;
  if (shape.kind == ShapeKind::polygon) return add_polygon(shape, tile, column, row, parts);
  const bool floor = shape.side == TileShape::Side::floor;
  const Exact left = column * tile.width, top = row * tile.height, bottom = top + tile.height;
  const bool solid = shape.kind == ShapeKind::solid;
  const double side = tile.height;
  const std::vector<double> heights = solid ? std::vector<double>{side, side} : shape.heights;
  const Exact width = tile.width * (solid ? 1 : shape.tiles), count = static_cast<int>(heights.size()) - 1;
  for (int i = 0; i < count; ++i) {
    const auto point = [&](int n) {
      const Exact height = rounded(heights[n]);
      return reference::ExactPoint{reference::rounded_to_256th(left + width * n / count),
                                   floor ? Exact(bottom - height) : Exact(top + height)};
    };
    Part part{point(i), point(i + 1), {}, Part::Stops::everywhere};
    if (shape.one_way) {
      part.stops = floor ? Part::Stops::from_above : Part::Stops::from_below;
    } else {
      part.level = floor ? bottom : top;
      if (part.a.y == *part.level && part.b.y == *part.level) continue;
    }
    parts.push_back(part);
  }
}

template <class Stops>
Stops stops_of(Curve::Faces faces) {
  if (faces == Curve::Faces::both) return Stops::everywhere;
  return faces == Curve::Faces::up ? Stops::from_above : Stops::from_below;
}

void add_line(Vec2 a, Vec2 b, Curve::Faces faces, std::vector<Part>& parts) {
  parts.push_back(
      {{rounded(a.x), rounded(a.y)}, {rounded(b.x), rounded(b.y)}, {}, stops_of<Part::Stops>(faces)});
}

using reference::Wide;

struct WideForm {
  reference::WideCurve operator()(const Arc& a) const {
    return with_welded_ends(reference::wide_arc(a.center.x, a.center.y, a.radius, a.x0, a.x1, a.upper));
  }
  reference::WideCurve operator()(const Parabola& p) const {  // from its Bernstein form
    const Wide w = Wide(p.to.x) - p.from.x, c = p.control_y;
    return reference::wide_polynomial(
        p.from.x, p.to.x, {p.from.y, 2 * (c - p.from.y) / w, (p.from.y - 2 * c + p.to.y) / (w * w), 0});
  }
  reference::WideCurve operator()(const Cubic& c) const {
    const Wide w = Wide(c.to.x) - c.from.x, rise = (Wide(c.to.y) - c.from.y) / w, a = c.from_slope,
               b = c.to_slope;
    return reference::wide_polynomial(
        c.from.x, c.to.x, {c.from.y, a, (3 * rise - 2 * a - b) / w, (a + b - 2 * rise) / (w * w)});
  }
  reference::WideCurve operator()(const Sine& s) const {
    return with_welded_ends(reference::wide_sine(s.x0, s.x1, s.middle, s.amplitude, s.wavelength, s.origin));
  }
  reference::WideCurve operator()(const Segment&) const { return {}; }
  reference::WideCurve operator()(const Polyline&) const { return {}; }
};

bool is_straight(const Curve& curve) {
  return std::holds_alternative<Segment>(curve.form) || std::holds_alternative<Polyline>(curve.form);
}

bool leaves_the_map(const TileShape& shape, int column, int row, const RandomGround& ground) {
  const ShapeReach reach = reach_of(shape, ground.tile);
  if (column + reach.left < 0 || column + reach.right >= ground.width) return true;
  if (row + reach.top < 0 || row + reach.bottom >= ground.height) return true;
  if (shape.heights.empty()) return false;
  const double most = *std::max_element(shape.heights.begin(), shape.heights.end());
  return most > (shape.side == TileShape::Side::floor ? row + 1 : ground.height - row) * ground.tile.height;
}

}  // namespace

Terrain RandomGround::compile() const {
  TerrainSource source;
  source.width = width, source.height = height;
  source.tile = tile;
  source.cells = cells;
  source.shapes = shapes;
  source.curves = curves;
  return Terrain(source);
}

RandomGround RandomGround::mirrored() const {
  RandomGround m = *this;
  for (TileShape& shape : m.shapes) shape = mirrored_in_tile(shape, tile);
  std::fill(m.cells.begin(), m.cells.end(), TileNumber{0});
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const TileNumber number = cells[static_cast<std::size_t>(y) * width + x];
      const std::size_t end = static_cast<std::size_t>(y) * width + width - x;
      if (number != 0) m.cells[end - shapes[number].tiles] = number;
    }
  }
  for (Curve& curve : m.curves) curve = mirrored_curve(curve, right());
  return m;
}

RandomGround RandomGround::moved(int columns, int rows) const {
  RandomGround m = *this;
  m.width += columns, m.height += rows;
  m.cells.assign(static_cast<std::size_t>(m.width) * m.height, 0);
  for (int y = 0; y < height; ++y) {
    const auto from = cells.begin() + static_cast<std::ptrdiff_t>(y) * width;
    std::copy(from, from + width,
              m.cells.begin() + static_cast<std::ptrdiff_t>(y + rows) * m.width + columns);
  }
  const Vec2 by{1.0 * columns * tile.width, 1.0 * rows * tile.height};
  for (Curve& curve : m.curves) curve = moved_curve(curve, by);
  return m;
}

reference::ExactGround RandomGround::exact() const {
  reference::ExactGround ground;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const TileShape& shape = shapes[cells[static_cast<std::size_t>(y) * width + x]];
      if (shape.kind != ShapeKind::none) add_shape(shape, tile, x, y, ground.parts);
    }
  }
  for (const Curve& curve : curves) {
    if (const auto* s = std::get_if<Segment>(&curve.form))
      add_line(s->from, s->to, curve.faces, ground.parts);
    if (const auto* p = std::get_if<Polyline>(&curve.form)) {
      const double step = (p->x1 - p->x0) / static_cast<double>(p->ys.size() - 1);
      for (std::size_t i = 0; i + 1 < p->ys.size(); ++i) {
        const double n = static_cast<double>(i);
        add_line({p->x0 + n * step, p->ys[i]}, {p->x0 + (n + 1) * step, p->ys[i + 1]}, curve.faces,
                 ground.parts);
      }
    }
  }
  return ground;
}

std::vector<reference::WideCurve> RandomGround::wide() const {
  std::vector<reference::WideCurve> all;
  for (const Curve& curve : curves) {
    if (is_straight(curve)) continue;
    all.push_back(std::visit(WideForm(), curve.form));
    all.back().stops = stops_of<reference::WideCurve::Stops>(curve.faces);
  }
  return all;
}

RandomGround random_ground(Dice& dice, int width, int height, GroundKinds kinds) {
  RandomGround ground;
  ground.width = width, ground.height = height;
  if (dice.one_in(2)) ground.tile = random_tile_size(dice);
  ground.cells.resize(static_cast<std::size_t>(width) * height);
  ground.shapes[1] = {.kind = ShapeKind::solid};
  for (int i = 2; i < kShapeKinds; ++i) ground.shapes[i] = random_shape(dice, ground.tile, kinds);
  for (int i = 2; kinds.polygons && i < kShapeKinds; ++i) {
    if (i % 3 == 0) ground.shapes[i] = random_polygon(dice, ground.tile, kinds.one_way);
    if (i % 3 == 1) ground.shapes[i] = random_group(dice, ground.tile, kinds.one_way);
  }
  std::vector<bool> used(ground.cells.size());
  const int density = 2 + dice.up_to(6);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (!dice.one_in(density)) continue;
      const int tile = kinds.shapes && dice.one_in(2) ? 2 + dice.up_to(kShapeKinds - 3) : 1;
      const int last = x + ground.shapes[tile].tiles - 1;
      const std::size_t row = static_cast<std::size_t>(y) * width;
      if (last >= width || used[row + x] || used[row + last] ||
          leaves_the_map(ground.shapes[tile], x, y, ground))
        continue;
      used[row + x] = used[row + last] = true;
      ground.cells[row + x] = static_cast<TileNumber>(tile);
    }
  }
  const Area area{4, 4, ground.right() - 4, ground.bottom() - 4};
  // Between tiny tiles there is no room for lines and curves, which would leave the map.
  const bool has_room = std::min(ground.right(), ground.bottom()) >= 32;
  for (int i = kinds.segments && has_room ? 1 + dice.up_to(3) : 0; i > 0; --i) {
    const Curve line = random_line(dice, area);
    if (!problem_of(line)) ground.curves.push_back(line);
  }
  for (int i = kinds.curves && has_room ? 1 + dice.up_to(3) : 0; i > 0; --i) {
    const Curve curve = random_curve(dice, area);
    const reference::WideCurve wide = std::visit(WideForm(), curve.form);
    const auto [least, greatest] = wide.range(wide.x0, wide.x1);
    if (least >= 0 && greatest <= ground.bottom()) ground.curves.push_back(curve);
  }
  return ground;
}

}  // namespace talus
