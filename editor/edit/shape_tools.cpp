// Tools for the shapes of the ground.
#include "shape_tools.h"

#include <cassert>
#include <utility>

#include "single_change.h"

namespace talus {

Edit set_tile_shape(const Level& level, int tile, TileShape shape) {
  assert(tile >= 0 && tile < kTileCount);
  return single_change("Change the shape of tile " + std::to_string(tile),
                       TileShapeChange{tile, level.tile_shapes[tile], std::move(shape)});
}

Edit set_flag_shape(const Level& level, int flag, TileShape shape) {
  assert(flag >= 0 && flag < kFlagCount);
  return single_change("Change the shape of flag " + std::to_string(flag),
                       FlagShapeChange{flag, level.flag_shapes[flag], std::move(shape)});
}

Edit set_curves(const Level& level, std::vector<LevelCurve> curves, std::string label) {
  return single_change(std::move(label), CurvesChange{level.curves, std::move(curves)});
}

Edit put_slope_tiles(const Level& level, const SlopeTiles& tiles) {
  Edit edit{"Lay a slope", {}};
  for (const SlopeTiles::Drawn& drawn : tiles.drawn) {
    const TileImage& before = level.sheet(SheetId::tiles).images[drawn.tile];
    for (int pixel = 0; pixel < kTileSize * kTileSize; ++pixel) {
      if (before[pixel] != drawn.image[pixel])
        edit.changes.emplace_back(
            PixelChange{SheetId::tiles, drawn.tile, pixel, before[pixel], drawn.image[pixel]});
    }
    const TileShape& shape = level.tile_shapes[drawn.tile];
    if (shape != drawn.shape) edit.changes.emplace_back(TileShapeChange{drawn.tile, shape, drawn.shape});
  }
  for (const SlopeTiles::Placed& placed : tiles.placed) {
    const std::uint8_t before = level.map.at(placed.cell);
    if (before != placed.tile) edit.changes.emplace_back(CellChange{placed.cell, before, placed.tile});
  }
  return edit;
}

}  // namespace talus
