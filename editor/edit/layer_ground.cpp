// Goes through the cells of all layers.
#include "layer_ground.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace talus {
namespace {

using TileMarks = std::vector<bool>;  // by number

bool shows_one_of(const Level& level, int layer, const TileMarks& tiles) {
  const auto& cells = level.cells_of(layer).tiles();
  return std::any_of(cells.begin(), cells.end(), [&](TileNumber tile) { return tiles[tile]; });
}

template <class Test>
TileMarks tiles_that(const Level& level, const Test& test) {
  TileMarks tiles;
  for (int tile = 0; tile < level.tile_count(); ++tile) tiles.push_back(test(static_cast<TileNumber>(tile)));
  return tiles;
}

bool has_ground_shape(const Level& level, TileNumber tile) {
  return shape_of_tile(level, tile).kind != TileShape::Kind::none;
}

}  // namespace

bool lacks_ground(const Level& level) {
  const auto is_ground = [](const ObjectLayer& layer) { return layer.is_ground; };
  if (!level.curves.empty() || std::any_of(level.objects.begin(), level.objects.end(), is_ground))
    return false;
  const TileMarks drawn = tiles_that(level, [](TileNumber tile) { return tile != 0; });
  const TileMarks solid = tiles_that(level, [&](TileNumber tile) { return has_ground_shape(level, tile); });
  bool shows_tiles = false;
  for (int layer = 0; layer < level.layers.count(); ++layer) {
    if (level.layers.list[static_cast<std::size_t>(layer)].is_ground && shows_one_of(level, layer, solid))
      return false;
    shows_tiles = shows_tiles || shows_one_of(level, layer, drawn);
  }
  return shows_tiles;
}

std::optional<std::string> ways_to_ground(const Level& level) {
  const bool is_map = level.ldtk || (level.tiled && !level.tiled->extension.starts_with("ts"));
  if (!is_map || !lacks_ground(level)) return std::nullopt;
  return std::string("give tiles a flag or a shape, or ") +
         (level.tiled ? "call a layer walls in Tiled" : "map a value to a shape in File > LDtk mapping");
}

Edit make_tiles_ground(const Level& level) {
  const int chosen = level.layers.chosen;
  TileMarks shown(static_cast<std::size_t>(level.tile_count()));
  for (const TileNumber tile : level.map.cells().tiles()) shown[tile] = tile != 0;
  const TileMarks bodies = tiles_that(level, [&](TileNumber tile) { return is_ball_tile(level, tile); });
  const TileMarks made = tiles_that(
      level, [&](TileNumber tile) { return shown[tile] && !bodies[tile] && !has_ground_shape(level, tile); });
  Edit edit{"Make the layer's tiles ground", {}};
  for (int tile = 0; tile < level.tile_count(); ++tile) {
    const auto at = static_cast<std::size_t>(tile);
    if (made[at])
      edit.changes.emplace_back(
          TileShapeChange{tile, level.tile_shapes[at], {.kind = TileShape::Kind::solid}});
  }
  if (edit.empty()) return edit;
  TileLayers after = level.layers;
  for (int layer = 0; layer < after.count(); ++layer) {
    bool& is_ground = after.list[static_cast<std::size_t>(layer)].is_ground;
    if (layer == chosen)
      is_ground = true;
    else if (shows_one_of(level, layer, made) && !shows_one_of(level, layer, bodies))
      is_ground = false;
  }
  if (after != level.layers) edit.changes.emplace_back(LayersChange{level.layers, std::move(after)});
  edit.layer = chosen;
  return edit;
}

}  // namespace talus
