#include "fix_preview.h"

#include <algorithm>

#include <talus/level/ground.h>
#include "tile_drawing.h"

namespace talus {

FixPreview preview_of(const Level& level, const Edit& fix) {
  FixPreview preview{.level = level, .cells = {}};
  apply_edit(preview.level, fix);
  const TileMap& map = preview.level.map;
  const auto layers_before = ground_layers(level), layers = ground_layers(preview.level);
  if (map.width() != level.map.width() || map.height() != level.map.height() ||
      layers.size() != layers_before.size())
    return preview;
  const std::vector<TileShape> shapes_before = usable_shapes(level), shapes = usable_shapes(preview.level);
  std::vector<bool> is_changed(shapes.size());
  for (std::size_t tile = 0; tile < shapes.size(); ++tile)
    is_changed[tile] = tile >= shapes_before.size() || shapes[tile] != shapes_before[tile];
  const auto changes = [&](std::size_t index) {
    for (std::size_t layer = 0; layer < layers.size(); ++layer) {
      const MapCell now = (*layers[layer])[index];
      if (now != (*layers_before[layer])[index] || is_changed[now.tile]) return true;
    }
    return false;
  };
  for (Cell at{0, 0}; at.y < map.height(); ++at.y) {
    for (at.x = 0; at.x < map.width() && preview.cells.size() < kMaxPreviewCells; ++at.x) {
      const auto index = static_cast<std::size_t>(at.y) * map.width() + at.x;
      if (changes(index)) preview.cells.push_back(at);
    }
  }
  return preview;
}

}  // namespace talus
