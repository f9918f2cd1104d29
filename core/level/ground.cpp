#include <talus/level/ground.h>

#include <cassert>
#include <cmath>

#include "bump_boxes.h"
#include "ground_cells.h"
#include "object_ground.h"

namespace talus {
namespace {

// The sum over all cells of the ground of the count of what they have. Maps are large: if nothing counts, the
// map is not read.
template <class Count>
std::size_t sum_over_ground(const GroundCells& ground, const Level& level, const Count& count) {
  std::vector<std::size_t> counts(static_cast<std::size_t>(level.tile_count()) + ground.stacks.size());
  bool any = false;
  for (std::size_t number = 0; number < counts.size(); ++number) {
    counts[number] = count(static_cast<TileNumber>(number));
    any = any || counts[number] != 0;
  }
  std::size_t sum = 0;
  if (any)
    for (const TileNumber number : ground.cells) sum += counts[number];
  return sum;
}

std::size_t ground_boxes(const Level& level, MapCell cell) {
  const TileShape shape = shape_of_cell(level, cell);
  if (shape.kind == TileShape::Kind::none) return 0;
  const TileSize size = level.map.tile_size();
  if (level.tuning.solver != SolverKind::bump || problem_of(shape, size)) return 1;
  return bump_boxes(shape, size).size();
}

// Counts for the solvers article, which makes one or two boxes of each tile that it knows, and bump.
std::size_t ground_boxes(const GroundCells& ground, const Level& level) {
  return sum_over_ground(ground, level, [&](TileNumber number) {
    std::size_t boxes = 0;
    for (const MapCell cell : tiles_of(number, ground.stacks, level.tile_count()))
      boxes += ground_boxes(level, cell);
    return boxes;
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
  assert(level.layers.count() == 1 && !level.map.cells().has_turned());
  return ground_of(level, ground_cells(level));
}

TerrainSource ground_of(const Level& level, const GroundCells& ground) {
  TerrainSource source;
  source.width = level.map.width();
  source.height = level.map.height();
  source.tile = level.map.tile_size();
  source.cells = ground.cells;
  source.shapes = usable_shapes(level);
  for (std::size_t i = 0; i < ground.stacks.size(); ++i) {
    TileShape shape = shape_of_number(level, ground.stacks, static_cast<TileNumber>(source.shapes.size()));
    source.shapes.push_back(problem_of(shape, source.tile) ? TileShape() : std::move(shape));
  }
  for (const LevelCurve& c : level.curves) {
    if (!problem_of(c.curve, level.map)) source.curves.push_back(c.curve);
  }
  return source;
}

Terrain terrain_of(const Level& level) {
  if (has_object_ground(level)) return terrain_of(with_object_tiles(level));
  const GroundCells ground = ground_cells(level);
  if (ground.overflow == 0) return Terrain(ground_of(level, ground));
  return Terrain(ground_of(without_tiles(level)));
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
  if (has_object_ground(level)) return ground_lines(with_object_tiles(level));
  return ground_lines(level, ground_cells(level));
}

std::size_t ground_lines(const Level& level, const GroundCells& ground) {
  return sum_over_ground(ground, level, [&](TileNumber number) {
    return ground_lines(shape_of_number(level, ground.stacks, number), level.map.tile_size());
  });
}

std::optional<std::string> ground_problem(const Level& level) {
  if (!has_object_ground(level)) return ground_problem(level, ground_cells(level));
  std::optional<std::string> problem;
  const Level tiles = with_object_tiles(level, false, &problem);
  return problem ? problem : ground_problem(tiles);
}

std::optional<std::string> ground_problem(const Level& level, const GroundCells& ground) {
  if (ground.overflow > 0)
    return "has more than " + std::to_string(ground.overflow - 1) +
           " different stacks of tiles, and turned tiles, in its layers of ground: use fewer layers of "
           "ground, "
           "or fewer tiles";
  const bool is_exact = level.tuning.solver == SolverKind::exact;
  const std::size_t has = is_exact ? ground_lines(level, ground) : ground_boxes(ground, level);
  const std::size_t most = is_exact ? kMaxGroundLines : kMaxGroundBoxes;
  if (has <= most) return std::nullopt;
  return "has ground of " + std::to_string(has) + (is_exact ? " lines" : " boxes") + ", but the solver " +
         std::string(solver_name(level.tuning.solver)) + " can take only " + std::to_string(most) +
         (is_exact ? ": use fewer or simpler slopes, profiles and polygons" : ": choose the solver exact");
}

}  // namespace talus
