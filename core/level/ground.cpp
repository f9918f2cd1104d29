#include "ground.h"

#include <algorithm>
#include <array>

namespace talus {

TerrainSource ground_of(const Level& level) {
  TerrainSource source;
  source.width = level.map.width();
  source.height = level.map.height();
  source.cells = level.map.cells();
  for (int tile = 0; tile < kTileCount; ++tile) {
    TileShape shape = shape_of_tile(level, static_cast<std::uint8_t>(tile));
    if (!problem_of(shape)) source.shapes[tile] = std::move(shape);
  }
  for (const LevelCurve& c : level.curves) {
    if (!problem_of(c.curve, level.map)) source.curves.push_back(c.curve);
  }
  return source;
}

std::optional<std::string> boxes_problem(const Level& level) {
  const std::span<const std::uint8_t> cells = level.map.cells();
  if (level.tuning.solver == SolverKind::exact || cells.size() <= kMaxBoxedTiles) return std::nullopt;
  std::array<bool, kTileCount> is_ground{};
  for (int tile = 0; tile < kTileCount; ++tile)
    is_ground[static_cast<std::size_t>(tile)] =
        shape_of_tile(level, static_cast<std::uint8_t>(tile)).kind != TileShape::Kind::none;
  const auto tiles = static_cast<std::size_t>(
      std::count_if(cells.begin(), cells.end(), [&](std::uint8_t tile) { return is_ground[tile]; }));
  if (tiles <= kMaxBoxedTiles) return std::nullopt;
  return "has " + std::to_string(tiles) + " tiles of ground, and the solver " +
         std::string(solver_name(level.tuning.solver)) + " can take " + std::to_string(kMaxBoxedTiles) +
         ": choose the solver exact";
}

}  // namespace talus
