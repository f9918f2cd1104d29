#include <talus/level/ground.h>

#include <cmath>

#include "bump_boxes.h"

namespace talus {
namespace {

// The sum over all cells of the count of their tile. Maps are large: if no tile counts anything, the map is
// not read.
template <class Count>
std::size_t sum_over_map(const Level& level, const Count& count) {
  std::vector<std::size_t> counts(static_cast<std::size_t>(level.tile_count()));
  bool any = false;
  for (std::size_t tile = 0; tile < counts.size(); ++tile) {
    counts[tile] = count(static_cast<TileNumber>(tile));
    any = any || counts[tile] != 0;
  }
  std::size_t sum = 0;
  if (any)
    for (const TileNumber tile : level.map.cells()) sum += counts[tile];
  return sum;
}

// Counts for the solvers article, which makes one or two boxes of each tile that it knows, and bump.
std::size_t ground_boxes(const Level& level) {
  return sum_over_map(level, [&](TileNumber tile) -> std::size_t {
    const TileShape shape = shape_of_tile(level, tile);
    if (shape.kind == TileShape::Kind::none) return 0;
    const TileSize size = level.map.tile_size();
    if (level.tuning.solver != SolverKind::bump || problem_of(shape, size)) return 1;
    return bump_boxes(shape, size).size();
  });
}

// A side is cut where it leaves a cell.
std::size_t lines_of_polygon(const TileShape& shape, TileSize tile) {
  double cells = 0;
  for (std::size_t i = 0; i < shape.points.size(); ++i) {
    const Vec2 side = shape.points[(i + 1) % shape.points.size()] - shape.points[i];
    cells += 1 + std::abs(side.x) / tile.width + std::abs(side.y) / tile.height;
  }
  return static_cast<std::size_t>(std::ceil(cells));
}

}  // namespace

std::vector<TileShape> usable_shapes(const Level& level) {
  std::vector<TileShape> shapes(static_cast<std::size_t>(level.tile_count()));
  for (std::size_t tile = 0; tile < shapes.size(); ++tile) {
    TileShape shape = shape_of_tile(level, static_cast<TileNumber>(tile));
    if (!problem_of(shape, level.map.tile_size())) shapes[tile] = std::move(shape);
  }
  return shapes;
}

TerrainSource ground_of(const Level& level) {
  TerrainSource source;
  source.width = level.map.width();
  source.height = level.map.height();
  source.tile = level.map.tile_size();
  source.cells = level.map.cells();
  source.shapes = usable_shapes(level);
  for (const LevelCurve& c : level.curves) {
    if (!problem_of(c.curve, level.map)) source.curves.push_back(c.curve);
  }
  return source;
}

std::size_t ground_lines(const TileShape& shape, TileSize tile) {
  if (shape.kind == TileShape::Kind::none || problem_of(shape, tile)) return 0;
  if (shape.kind == TileShape::Kind::solid) return shape.one_way ? 1 : 0;
  if (shape.kind == TileShape::Kind::polygon) return lines_of_polygon(shape, tile);
  if (shape.kind == TileShape::Kind::group) {
    std::size_t lines = 0;
    for (const TileShape& part : shape.parts)
      lines += part.kind == TileShape::Kind::solid ? 4 : ground_lines(part, tile);
    return lines;
  }
  const std::vector<double>& heights = shape.heights;
  double cells = (heights.front() + heights.back()) / tile.height;  // of the walls at its sides
  for (std::size_t i = 1; i < heights.size(); ++i)
    cells += 1 + std::abs(heights[i] - heights[i - 1]) / tile.height;
  return static_cast<std::size_t>(std::ceil(cells));
}

std::size_t ground_lines(const Level& level) {
  return sum_over_map(level, [&](TileNumber tile) {
    return ground_lines(shape_of_tile(level, tile), level.map.tile_size());
  });
}

std::optional<std::string> ground_problem(const Level& level) {
  const bool is_exact = level.tuning.solver == SolverKind::exact;
  const std::size_t has = is_exact ? ground_lines(level) : ground_boxes(level);
  const std::size_t most = is_exact ? kMaxGroundLines : kMaxGroundBoxes;
  if (has <= most) return std::nullopt;
  return "has ground of " + std::to_string(has) + (is_exact ? " lines" : " boxes") + ", but the solver " +
         std::string(solver_name(level.tuning.solver)) + " can take only " + std::to_string(most) +
         (is_exact ? ": use fewer or simpler slopes, profiles and polygons" : ": choose the solver exact");
}

}  // namespace talus
