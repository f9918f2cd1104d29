#include <talus/level/tile_turns.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <iterator>
#include <utility>

#include <talus/collision/shape_forms.h>

namespace talus {
namespace {

using Kind = TileShape::Kind;
using Side = TileShape::Side;

// The points of one polygon are few, so that a long profile is cut into several.
constexpr std::size_t kMaxHeights = kMaxPolygonPoints - 2;

Vec2 point_after_turn(Vec2 point, TileTurn turn, TileSize tile) {
  const TileSize size = turned(tile, turn);
  Vec2 p = weld(point);
  if (has_flip(turn, TileTurn::diagonal)) std::swap(p.x, p.y);
  if (has_flip(turn, TileTurn::left_right)) p.x = size.width - p.x;
  if (has_flip(turn, TileTurn::up_down)) p.y = size.height - p.y;
  return {p.x, p.y + top_of_turned(tile, turn)};
}

Side side_after_turn(Side side, TileTurn turn) {
  const bool is_diagonal = has_flip(turn, TileTurn::diagonal), is_first = side == Side::floor;
  if (is_diagonal) return is_first != has_flip(turn, TileTurn::left_right) ? Side::left : Side::right;
  return is_first != has_flip(turn, TileTurn::up_down) ? Side::floor : Side::ceiling;
}

// The outline between some of a line's points, which are above the base all but at the ends.
TileShape outline_below(const TileShape& shape, const std::vector<Vec2>& line, std::size_t first,
                        std::size_t last, double base) {
  TileShape part{.kind = Kind::polygon, .side = shape.side, .one_way = shape.one_way};
  if (line[first].y != base) part.points.push_back({line[first].x, base});
  for (std::size_t i = first; i <= last; ++i) part.points.push_back(line[i]);
  if (line[last].y != base) part.points.push_back({line[last].x, base});
  return part;
}

// A slope, a profile or a full tile as polygons. Where its line has no height, one ends.
std::vector<TileShape> as_polygons(const TileShape& shape, TileSize tile) {
  const bool is_solid = shape.kind == Kind::solid;
  const bool is_floor = is_solid || shape.side == Side::floor;
  const double base = is_floor ? tile.height : 0, width = (is_solid ? 1 : shape.tiles) * tile.width;
  std::vector<double> heights = shape.heights;
  if (is_solid) heights.assign(2, tile.height);
  assert(heights.size() >= 2);
  std::vector<Vec2> line;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double height = weld(heights[i]);
    line.push_back({weld(width * static_cast<double>(i) / static_cast<double>(heights.size() - 1)),
                    is_floor ? base - height : base + height});
  }
  std::vector<TileShape> parts;
  for (std::size_t first = 0; first + 1 < line.size();) {
    std::size_t last = first + 1;
    while (last + 1 < line.size() && line[last].y != base && last - first + 1 < kMaxHeights) ++last;
    const bool is_flat = last == first + 1 && line[first].y == base && line[last].y == base;
    if (!is_flat) parts.push_back(outline_below(shape, line, first, last, base));
    first = last;
  }
  if (is_solid)
    for (TileShape& part : parts) part.side = Side::floor;
  return parts;
}

TileShape joined(std::vector<TileShape> parts) {
  if (parts.empty()) return {};
  if (parts.size() == 1) return std::move(parts.front());
  TileShape group{.kind = Kind::group};
  group.parts = std::move(parts);
  return group;
}

// Whether a slope, a profile or a full tile is one again after a turn.
bool stays_line(const TileShape& shape, TileTurn turn, TileSize tile) {
  const bool is_diagonal = has_flip(turn, TileTurn::diagonal);
  if (shape.kind == Kind::solid)
    return shape.one_way ? !is_diagonal && !has_flip(turn, TileTurn::up_down)
                         : !is_diagonal || tile.width == tile.height;
  return has_heights(shape) && !is_diagonal && (shape.tiles == 1 || !has_flip(turn, TileTurn::left_right));
}

TileShape turned_polygon(TileShape polygon, TileTurn turn, TileSize tile) {
  for (Vec2& point : polygon.points) point = point_after_turn(point, turn, tile);
  if (polygon.one_way) polygon.side = side_after_turn(polygon.side, turn);
  return polygon;
}

}  // namespace

Cell pixel_before_turn(Cell pixel, TileTurn turn, TileSize tile) {
  const TileSize size = turned(tile, turn);
  if (has_flip(turn, TileTurn::up_down)) pixel.y = size.height - 1 - pixel.y;
  if (has_flip(turn, TileTurn::left_right)) pixel.x = size.width - 1 - pixel.x;
  if (has_flip(turn, TileTurn::diagonal)) std::swap(pixel.x, pixel.y);
  return pixel;
}

namespace {

// All but its conveyor.
TileShape turned_form(const TileShape& shape, TileTurn turn, TileSize tile) {
  if (shape.kind == Kind::group) {
    std::vector<TileShape> parts;
    for (const TileShape& part : shape.parts) {
      TileShape its = turned_form(part, turn, tile);
      if (its.kind == Kind::group)
        std::move(its.parts.begin(), its.parts.end(), std::back_inserter(parts));
      else if (its.kind != Kind::none)
        parts.push_back(std::move(its));
    }
    return joined(std::move(parts));
  }
  if (shape.kind == Kind::polygon) return turned_polygon(shape, turn, tile);
  if (stays_line(shape, turn, tile)) {
    TileShape line = shape;
    if (has_flip(turn, TileTurn::left_right)) line = mirrored(line, tile, ShapeMirror::left_right);
    if (has_flip(turn, TileTurn::up_down)) line = mirrored(line, tile, ShapeMirror::up_down);
    return line;
  }
  std::vector<TileShape> parts = as_polygons(shape, tile);
  for (TileShape& part : parts) part = turned_polygon(std::move(part), turn, tile);
  return joined(std::move(parts));
}

}  // namespace

bool is_mirror(TileTurn turn) {
  return has_flip(turn, TileTurn::diagonal) !=
         (has_flip(turn, TileTurn::left_right) != has_flip(turn, TileTurn::up_down));
}

TileShape turned(const TileShape& shape, TileTurn turn, TileSize tile) {
  if (turn == TileTurn::none || shape.kind == Kind::none) return shape;
  TileShape result = turned_form(shape, turn, tile);
  if (result.kind != Kind::none) result.conveyor = is_mirror(turn) ? 0 - shape.conveyor : shape.conveyor;
  return result;
}

std::string text_of(TileTurn turn) {
  // By the bits of the turn.
  static constexpr std::array<const char*, kTileTurns> kTexts = {
      "",         "turned right, mirrored", "mirrored up and down", "turned left",
      "mirrored", "turned right",           "turned by half",       "turned left, mirrored"};
  return kTexts[static_cast<std::size_t>(turn)];
}

}  // namespace talus
