// Which part of a level goes where in a map of Tiled.
#include "tiled_model.h"

#include <algorithm>

#include "../formats/tiled/tiled_objects.h"

namespace talus {
namespace {

TiledTileset tileset_of(const ExportRequest& request) {
  const Level& level = request.level;
  TiledTileset tileset;
  tileset.name = "tiles";
  tileset.image = request.sheet_name();
  tileset.tile_size = level.map.tile_size();
  const SheetLayout sheet = level.sheet(SheetId::tiles).layout();
  tileset.image_width = sheet.columns * tileset.tile_size.width;
  tileset.image_height = sheet.rows() * tileset.tile_size.height;
  tileset.columns = sheet.columns;
  tileset.tile_count = sheet.count;
  for (int id = 0; id < sheet.count; ++id) {
    const auto number = static_cast<TileNumber>(id);
    const TileShape shape = shape_of_tile(level, number);
    TiledTile tile;
    tile.id = id;
    tile.properties = tiled_flag_properties(level, level.tile_flags(number));
    const TiledProperties words = tiled_properties(shape);
    tile.properties.insert(tile.properties.end(), words.begin(), words.end());
    tile.objects = tiled_objects(shape, tileset.tile_size);
    if (const auto found = level.animations.find(number); found != level.animations.end()) {
      for (const AnimationFrame& frame : found->second)
        tile.animation.push_back({frame.tile, frame.duration});
    }
    if (!tile.properties.empty() || !tile.animation.empty()) tileset.tiles->push_back(std::move(tile));
  }
  return tileset;
}

TiledLayer tile_layer(const Level& level, int index) {
  TiledLayer layer;
  layer.has_tiles = true;
  layer.looks = level.layers.list[static_cast<std::size_t>(index)];
  layer.looks.cells = nullptr;
  const bool is_plain = level.layers.is_plain();
  layer.name = is_plain || layer.looks.name.empty() ? kTiledTileLayer : layer.looks.name;
  const bool is_empty = level.layers.count() > 1 || is_tile_0_blank(level);
  for (const TileNumber tile : level.cells_of(index))
    layer.cells.push_back(tile == 0 && is_empty ? 0 : tile + 1U);
  return layer;
}

}  // namespace

TiledMap tiled_map_of(const ExportRequest& request) {
  const Level& level = request.level;
  TiledMap map;
  map.width = level.map.width();
  map.height = level.map.height();
  map.tile_size = level.map.tile_size();
  map.background = tiled_color(level.palette[0]);
  map.tilesets.push_back(tileset_of(request));
  for (int layer = 0; layer < level.layers.count(); ++layer) map.layers.push_back(tile_layer(level, layer));
  TiledLayer spawns, curves;
  spawns.name = kTiledSpawnLayer;
  for (const Spawn& spawn : level.spawns) spawns.objects.push_back(tiled_object(spawn));
  curves.name = kTiledCurveLayer;
  for (const LevelCurve& curve : level.curves) {
    if (auto object = tiled_object(curve)) curves.objects.push_back(*std::move(object));
  }
  map.layers.push_back(std::move(spawns));
  map.layers.push_back(std::move(curves));
  return map;
}

TiledProperties tiled_flag_properties(const Level& level, std::uint8_t flags) {
  if (flags == 0) return {};
  TiledProperties properties = {{"flags", std::int64_t{flags}}};
  const auto names = tiled_flag_names(level);
  for (int flag = 0; flag < kFlagCount; ++flag) {
    if (has_flag(flags, flag)) properties.push_back({names[static_cast<std::size_t>(flag)], true});
  }
  return properties;
}

TiledProperties tiled_properties(const TileLayer& looks) {
  if (looks.is_ground) return {};
  return {{"ground", false}};
}

bool is_tile_0_blank(const Level& level) {
  const TileImage& image = level.sheet(SheetId::tiles).images[0];
  const bool is_drawn =
      std::any_of(image.begin(), image.end(), [](std::uint8_t color) { return color != 0; });
  return !is_drawn && level.tile_flags(0) == 0 && shape_of_tile(level, 0).kind == TileShape::Kind::none;
}

Exported tiled_files(const ExportRequest& request, std::string text, std::string picture,
                     std::vector<std::string> dropped) {
  const std::string name = request.sheet_name();
  if (request.name == "-") dropped.push_back("the picture " + name + ", which goes beside a file");
  return {{{"", std::move(text)}, {name, std::move(picture)}}, std::move(dropped)};
}

}  // namespace talus
