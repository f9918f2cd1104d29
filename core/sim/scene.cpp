#include "scene.h"

#include <array>

namespace talus {
namespace {

// What each of the 256 tiles is to the physics, so that a map is compiled with one look-up a cell.
std::array<TileRole, kTileCount> tile_roles(const Level& level) {
  std::array<TileRole, kTileCount> roles;
  for (int tile = 0; tile < kTileCount; ++tile) {
    roles[tile] = role_of(level.tile_flags(static_cast<std::uint8_t>(tile)), level.roles);
  }
  return roles;
}

SceneItem item_of_tile(TileRole role, Cell cell, const ArticleTuning& tuning) {
  SceneItem item{.role = role, .box = {}, .cell = cell, .velocity = {}, .spawn = -1};
  item.box = {static_cast<double>(cell.x) * kTileSize, static_cast<double>(cell.y) * kTileSize, kTileSize,
              kTileSize};
  if (role == TileRole::up_slope || role == TileRole::down_slope) {
    item.box.w = tuning.slope_width;
    item.box.h = tuning.slope_height;
  }
  return item;
}

}  // namespace

Scene compile_scene(const Level& level) {
  const std::array<TileRole, kTileCount> roles = tile_roles(level);
  const TileMap& map = level.map;

  // A counting sort by column: the map is read row by row, as it lies in memory, and comes out in map order.
  std::vector<std::size_t> next(static_cast<std::size_t>(map.width()) + 1, 0);
  for (Cell cell{0, 0}; cell.y < map.height(); ++cell.y) {
    for (cell.x = 0; cell.x < map.width(); ++cell.x) {
      if (roles[map.at(cell)] != TileRole::none) ++next[cell.x + 1];
    }
  }
  for (std::size_t column = 1; column < next.size(); ++column) next[column] += next[column - 1];

  Scene scene;
  scene.tuning = level.tuning;
  scene.items.resize(next.back());
  for (Cell cell{0, 0}; cell.y < map.height(); ++cell.y) {
    for (cell.x = 0; cell.x < map.width(); ++cell.x) {
      const TileRole role = roles[map.at(cell)];
      if (role == TileRole::none) continue;
      scene.items[next[cell.x]++] = item_of_tile(role, cell, level.tuning.article);
    }
  }

  for (std::size_t i = 0; i < level.spawns.size(); ++i) {
    const Spawn& spawn = level.spawns[i];
    scene.items.push_back({.role = TileRole::ball,
                           .box = {spawn.position.x, spawn.position.y, kTileSize, kTileSize},
                           .cell = {},
                           .velocity = spawn.velocity,
                           .spawn = static_cast<int>(i)});
  }
  return scene;
}

}  // namespace talus
