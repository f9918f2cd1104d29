// Compiles a window of the map.
#include "local_ground.h"

#include <algorithm>
#include <cmath>

#include <talus/level/ground.h>
#include "cell_rect.h"

namespace talus {
namespace {

MapCells window_of(const MapCells& cells, int width, const CellRect& window) {
  MapCells part(static_cast<std::size_t>(window.w) * static_cast<std::size_t>(window.h));
  std::size_t to = 0;
  for (int y = window.y; y < window.y + window.h; ++y) {
    const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    for (int x = window.x; x < window.x + window.w; ++x, ++to)
      part.set(to, cells[row + static_cast<std::size_t>(x)]);
  }
  return part;
}

// What the ground of a level's cells depends on, with these cells alone.
Level window_of(const Level& level, const CellRect& window) {
  Level part;
  part.sheet(SheetId::tiles).flags = level.sheet(SheetId::tiles).flags;
  part.roles = level.roles;
  part.tile_shapes = level.tile_shapes;
  part.flag_shapes = level.flag_shapes;
  part.tuning = level.tuning;
  part.layers = level.layers;
  part.objects = level.objects;
  const Vec2 corner = level.map.corner_of({window.x, window.y});
  for (ObjectLayer& layer : part.objects)
    for (MapObject& object : layer.objects) object.position = object.position - corner;
  part.map = TileMap(window.w, window.h, level.map.tile_size());
  part.map.cells() = window_of(level.map.cells(), level.map.width(), window);
  for (TileLayer& layer : part.layers.list) {
    if (layer.cells != nullptr)
      layer.cells = std::make_shared<const MapCells>(window_of(*layer.cells, level.map.width(), window));
  }
  return part;
}

}  // namespace

LocalGround ground_around(const Level& level, const Rect& box, int cells) {
  const TileMap& map = level.map;
  const int margin = cells + kMaxShapeTiles;  // slopes that begin further away may reach here
  const auto cell = [margin](double px, int side, int by, int count) {
    return static_cast<int>(
        std::clamp(std::floor(px / side) + by * margin, 0.0, static_cast<double>(count - 1)));
  };
  const auto [tile_width, tile_height] = map.tile_size();
  const Cell first{cell(box.x, tile_width, -1, map.width()), cell(box.y, tile_height, -1, map.height())};
  const Cell last{cell(box.right(), tile_width, 1, map.width()),
                  cell(box.bottom(), tile_height, 1, map.height())};
  return {terrain_of(window_of(level, {first.x, first.y, last.x - first.x + 1, last.y - first.y + 1})),
          map.corner_of(first)};
}

}  // namespace talus
