#include "bench_balls.h"

#include <utility>
#include <vector>

#include "random.h"

namespace talus {
namespace {

// Cells in which a ball overlaps nothing: tiles without a role, and no second half of a slope.
std::vector<Cell> free_cells(const Level& level) {
  const auto is_slope = [&](Cell cell) {
    const TileRole role = level.role_at(cell);
    return role == TileRole::up_slope || role == TileRole::down_slope;
  };
  std::vector<Cell> cells;
  for (Cell cell{0, 0}; cell.y < level.map.height(); ++cell.y) {
    for (cell.x = 0; cell.x < level.map.width(); ++cell.x) {
      const bool behind_slope = cell.x > 0 && is_slope({cell.x - 1, cell.y});
      if (level.role_at(cell) == TileRole::none && !behind_slope) cells.push_back(cell);
    }
  }
  return cells;
}

}  // namespace

bool spawn_balls(Level& level, int count, std::uint64_t seed) {
  std::vector<Cell> cells = free_cells(level);
  if (cells.size() < static_cast<std::size_t>(count)) return false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    std::swap(cells[i], cells[i + next_random(seed) % (cells.size() - i)]);
    Spawn spawn;
    const Rect cell = level.map.box_of(cells[i]);
    spawn.position = cell.position();
    spawn.size = {cell.w, cell.h};
    level.spawns.push_back(spawn);
  }
  return true;
}

}  // namespace talus
