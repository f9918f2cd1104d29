#include "plain_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include <talus/level/ground.h>
#include "../collision/outline_compiler.h"
#include "../level/bump_boxes.h"
#include "ground_polygons.h"

namespace talus {
namespace {

// The highest ground of a polygon or a group at an x of its own tile; the tile's bottom if there is none.
double highest_at(const TileOutline& outline, double x, TileSize size) {
  double highest = size.height;
  for (const TileColumn& part : outline.in_column(0)) {
    if (part.left > x || part.right < x) continue;
    const auto line =
        std::find_if(part.top.begin(), part.top.end(), [x](const auto& l) { return x <= l.x1; });
    highest = std::min(highest, line->at(x));
  }
  return std::max(highest, 0.0);
}

std::vector<Vec2> outline_points(const TileShape& part, TileSize size) {
  if (part.kind == TileShape::Kind::polygon) return part.points;
  const double width = part.tiles * size.width, height = size.height;
  const bool is_ceiling = part.kind != TileShape::Kind::solid && part.side == TileShape::Side::ceiling;
  const double base = is_ceiling ? 0 : height;
  std::vector<double> heights = part.heights;
  if (part.kind == TileShape::Kind::solid) heights = {height, height};
  std::vector<Vec2> points = {{0, base}};
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double x = width * static_cast<double>(i) / static_cast<double>(heights.size() - 1);
    points.push_back({x, is_ceiling ? heights[i] : base - heights[i]});
  }
  points.push_back({width, base});
  return points;
}

PlainShape plain_cut_shape(int tile, const TileShape& shape, const TileOutline& outline, TileSize size) {
  PlainShape plain{tile, shape.kind, false, shape.one_way, 1, {}, {}, size.height};
  for (int column = 0; column <= size.width; ++column) plain.ys.push_back(highest_at(outline, column, size));
  for (int column = 0; column < size.width; ++column)
    plain.columns.push_back(highest_at(outline, column + 0.5, size));
  const auto add = [&](const TileShape& part) {
    plain.outlines.push_back(
        {part.one_way, part.side == TileShape::Side::ceiling, outline_points(part, size)});
  };
  if (shape.kind == TileShape::Kind::polygon) add(shape);
  std::for_each(shape.parts.begin(), shape.parts.end(), add);
  plain.conveyor = shape.conveyor;
  return plain;
}

PlainShape plain_shape(int tile, const TileShape& shape, const TileOutline& outline, TileSize size) {
  if (has_parts(shape)) return plain_cut_shape(tile, shape, outline, size);
  const bool is_ceiling = outline.line && shape.side == TileShape::Side::ceiling;
  PlainShape plain{tile, shape.kind, is_ceiling, shape.one_way, 1, {}, {}, size.height};
  plain.conveyor = shape.conveyor;
  plain.tiles = static_cast<int>(outline.columns.size());
  std::vector<double> heights = shape.heights;
  if (shape.kind == TileShape::Kind::solid) heights.assign(2, size.height);
  for (const double height : heights)
    plain.ys.push_back(plain.is_ceiling ? weld(height) : size.height - weld(height));
  for (int column = 0; column < plain.tiles * size.width; ++column) {
    const TileColumn& cell = outline.columns[static_cast<std::size_t>(column / size.width)];
    const auto& lines = plain.is_ceiling ? cell.bottom : cell.top;
    const double x = column + 0.5;
    const auto line = std::find_if(lines.begin(), lines.end(), [x](const auto& l) { return x <= l.x1; });
    plain.columns.push_back(line->at(x));
  }
  return plain;
}

// ---- One-way tiles ----

using OneWay = Piece<double>;

bool has_one_way_part(const TileShape& shape) {
  if (shape.kind == TileShape::Kind::group)
    return std::any_of(shape.parts.begin(), shape.parts.end(), has_one_way_part);
  return shape.one_way && shape.kind != TileShape::Kind::none;
}

bool is_before(const OneWay& a, const OneWay& b) {
  return std::tie(a.facing, a.x0, a.y0, a.x1, a.y1) < std::tie(b.facing, b.x0, b.y0, b.x1, b.y1);
}

// Counts what is in several cells, or in two tiles, only once.
std::vector<OneWay> one_way_pieces(const Terrain& ground) {
  std::vector<OneWay> pieces;
  for (Cell c; c.y < ground.height() && ground.has_pieces(); ++c.y) {
    for (c.x = 0; c.x < ground.width(); ++c.x) {
      for (const Piece<double>& piece : ground.pieces_in(c))
        if (piece.one_way && piece.origin >= 0) pieces.push_back(piece);
    }
  }
  std::stable_sort(pieces.begin(), pieces.end(), is_before);
  const auto same = [](const OneWay& a, const OneWay& b) { return !is_before(a, b) && !is_before(b, a); };
  pieces.erase(std::unique(pieces.begin(), pieces.end(), same), pieces.end());
  return pieces;
}

bool is_same_line(const OneWay& a, const OneWay& b) {
  return a.base_x == b.base_x && a.base_y == b.base_y && a.slope == b.slope && a.slope_rest == b.slope_rest;
}

void add_one_way_lines(const Terrain& ground, std::vector<PlainLine>& lines) {
  const std::vector<OneWay> pieces = one_way_pieces(ground);
  std::vector<bool> used(pieces.size());
  // The first piece that begins where another one ends.
  const auto next_of = [&](const OneWay& piece) {
    OneWay key = piece;
    key.x0 = piece.x1, key.y0 = piece.y1;
    auto next = std::lower_bound(pieces.begin(), pieces.end(), key, [](const OneWay& a, const OneWay& b) {
      return std::tie(a.facing, a.x0, a.y0) < std::tie(b.facing, b.x0, b.y0);
    });
    for (; next != pieces.end() && next->facing == key.facing; ++next) {
      const auto index = static_cast<std::size_t>(next - pieces.begin());
      if (next->x0 != key.x0 || next->y0 != key.y0) break;
      if (!used[index]) return index;
    }
    return pieces.size();
  };
  for (std::size_t first = 0; first < pieces.size(); ++first) {
    if (used[first]) continue;
    std::vector<Vec2> points = {{pieces[first].x0, pieces[first].y0}};
    for (std::size_t at = first; at < pieces.size();) {
      used[at] = true;
      const OneWay& piece = pieces[at];
      const Vec2 end{piece.x1, piece.y1};
      const std::size_t next = next_of(piece);
      const bool goes_straight_on =
          next < pieces.size() && (is_same_line(piece, pieces[next]) ||
                                   is_straight(points.back(), end, {pieces[next].x1, pieces[next].y1}));
      if (!goes_straight_on) points.push_back(end);
      at = next;
    }
    if (pieces[first].facing == Facing::down) std::reverse(points.begin(), points.end());
    lines.push_back({false, false, "", std::move(points)});
  }
}

// ---- Curves ----

// Adds points after `from`, up to `to`, so that the lines between them stay near the curve.
template <class Height>
void add_curve_points(Vec2 from, Vec2 to, const Height& height, std::vector<Vec2>& points) {
  double error = 0;
  for (const double part : {0.25, 0.5, 0.75}) {
    const double y = from.y + (to.y - from.y) * part;
    error = std::max(error, std::abs(height(from.x + (to.x - from.x) * part) - y));
  }
  // From the vertical distance to that from the line.
  error *= (to.x - from.x) / std::hypot(to.x - from.x, to.y - from.y);
  const double middle = (from.x + to.x) / 2;
  if (error <= kPlainLineError || !(middle > from.x && middle < to.x)) return points.push_back(to);
  const Vec2 between{middle, height(middle)};
  add_curve_points(from, between, height, points);
  add_curve_points(between, to, height, points);
}

std::vector<Vec2> points_of(Curve curve) {
  const bool faces_down = curve.faces == Curve::Faces::down;
  curve.faces = Curve::Faces::up;  // each piece once, for its upper side
  const CurveOutline outline = cut_curves({&curve, 1});
  std::vector<Vec2> points;
  for (const Piece<double>& piece : outline.pieces) {
    Vec2 from{piece.x0, piece.y0}, to{piece.x1, piece.y1};
    if (piece.facing == Facing::left) std::swap(from, to);
    if (points.empty()) points.push_back(from);
    if (piece.stretch == 0)
      points.push_back(to);
    else
      add_curve_points(
          from, to, [&](double x) { return piece.y_at(x, outline.stretches); }, points);
  }
  if (faces_down) std::reverse(points.begin(), points.end());
  return points;
}

// The number of tiles on the map whose shape is so.
template <class Is>
int used_tiles(const TerrainSource& ground, const Is& is) {
  std::vector<bool> used(ground.shapes.size());
  for (const TileNumber tile : ground.cells) used[tile] = true;
  int count = 0;
  for (std::size_t tile = 0; tile < used.size(); ++tile)
    count += used[tile] && is(ground.shapes[tile]) ? 1 : 0;
  return count;
}

std::string polygon_tiles(int count) {
  return std::to_string(count) + (count == 1 ? " tile that is a polygon" : " tiles that are polygons");
}

// Of a tile's shape, or of a curve.
constexpr auto has_conveyor = [](const auto& ground) { return ground.conveyor != 0; };

}  // namespace

bool PlainShape::has_floor_at(double y) const {
  if (is_ceiling) return !one_way && y > 0;
  return one_way || y < tile_height;
}

std::vector<PlainShape> plain_shapes(const TerrainSource& ground) {
  const TileOutlines outlines(ground.shapes, ground.tile);
  std::vector<PlainShape> shapes;
  for (std::size_t tile = 0; tile < ground.shapes.size(); ++tile) {
    const TileShape& shape = ground.shapes[tile];
    if (shape.kind != TileShape::Kind::none)
      shapes.push_back(plain_shape(static_cast<int>(tile), shape, outlines[tile], ground.tile));
  }
  return shapes;
}

PlainBodies::PlainBodies(const Level& level) : level_(level) {
  std::vector<bool> is_ball(static_cast<std::size_t>(level.tile_count()));
  for (std::size_t tile = 0; tile < is_ball.size(); ++tile)
    is_ball[tile] = is_ball_tile(level, static_cast<TileNumber>(tile));
  for (Cell c; c.y < level.map.height(); ++c.y) {
    for (c.x = 0; c.x < level.map.width(); ++c.x)
      if (is_ball[level.map.tile_at(c)]) tiles_.push_back(c);
  }
  std::stable_sort(tiles_.begin(), tiles_.end(), [](Cell a, Cell b) { return a.x < b.x; });
}

PlainBody PlainBodies::at(std::size_t index) const {
  PlainBody body;
  body.id = static_cast<int>(index) + 1;
  if (index >= tiles_.size()) {
    body.start = level_.spawns[index - tiles_.size()];
    BodyPicture& picture = body.start.picture;
    picture = on_sheet(picture, level_.sheet(picture.sheet).layout());
  } else {
    body.tile = level_.map.tile_at(tiles_[index]);
    const Rect box = level_.map.box_of(tiles_[index]);
    body.start.position = box.position();
    body.start.size = {box.w, box.h};
  }
  return body;
}

std::vector<std::string> dropped_polygons(const Level& level) {
  const int count = used_tiles(ground_of(level), has_parts);
  if (count == 0) return {};
  return {"the exact form of " + polygon_tiles(count) +
          ", of which the highest ground in each column of pixels is kept"};
}

std::vector<std::string> dropped_by_bump(const Level& level) {
  const int count =
      used_tiles(ground_of(level), [](const TileShape& shape) { return !bump_takes_all_of(shape); });
  if (count == 0) return {};
  return {"parts of " + polygon_tiles(count) +
          ", as bump does not know ground between two slopes that no level line separates"};
}

std::vector<std::string> dropped_curves(const Level& level) {
  const std::size_t curves = ground_of(level).curves.size();
  if (curves == 0) return {};
  return {std::to_string(curves) + (curves == 1 ? " curve" : " curves")};
}

void tell_body_pictures(const Level& level, std::vector<std::string>& dropped) {
  const auto has_one = [](const Spawn& spawn) { return !spawn.picture.empty(); };
  const auto count = std::count_if(level.spawns.begin(), level.spawns.end(), has_one);
  if (count > 0)
    dropped.push_back(count == 1 ? "the picture of a body"
                                 : "the pictures of " + std::to_string(count) + " bodies");
}

int conveyor_tiles(const Level& level) { return used_tiles(ground_of(level), has_conveyor); }

void tell_conveyors(const Level& level, bool holds_curves, std::vector<std::string>& dropped) {
  const TerrainSource ground = ground_of(level);
  std::ptrdiff_t count = used_tiles(ground, has_conveyor);
  if (holds_curves) count += std::count_if(ground.curves.begin(), ground.curves.end(), has_conveyor);
  if (count > 0)
    dropped.push_back(count == 1 ? "the speed of a conveyor"
                                 : "the speeds of " + std::to_string(count) + " conveyors");
}

std::string_view kind_word(TileShape::Kind kind) {
  constexpr std::array<std::string_view, 6> kWords = {"none",    "solid",   "slope",
                                                      "profile", "polygon", "group"};
  return kWords[static_cast<std::size_t>(kind)];
}

std::string_view foot_word(Foot foot) { return foot == Foot::centre ? "centre" : "box"; }

std::string_view rule_word(BodyRule rule) {
  switch (rule) {
    case BodyRule::fall:
      return "fall";
    case BodyRule::run:
      return "run";
  }
  return {};
}

std::string_view look_word(BodyLook look) {
  switch (look) {
    case BodyLook::tile:
      return "tile";
    case BodyLook::figure:
      return "figure";
    case BodyLook::crate:
      return "crate";
    case BodyLook::wheel:
      return "wheel";
    case BodyLook::marble:
      return "marble";
  }
  return {};
}

std::vector<PlainLine> plain_lines(const Level& level, const Progress& progress) {
  std::vector<PlainLine> lines;
  TerrainSource ground = ground_of(level);
  const bool has_one_way = std::any_of(ground.cells.begin(), ground.cells.end(), [&](TileNumber tile) {
    return has_one_way_part(ground.shapes[tile]);
  });
  if (has_one_way) {
    ground.progress = progress.part(0, 0.9).function();
    const Terrain terrain(ground);
    if (progress.stopped()) return {};
    add_one_way_lines(terrain, lines);
  }
  for (const LevelCurve& c : level.curves) {
    if (problem_of(c.curve, level.map)) continue;
    lines.push_back(
        {true, c.curve.faces == Curve::Faces::both, c.name, points_of(c.curve), c.curve.conveyor});
  }
  return lines;
}

}  // namespace talus
