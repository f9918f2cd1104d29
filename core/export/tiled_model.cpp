// Which part of a level goes where in a map of Tiled.
#include "tiled_model.h"

#include <algorithm>
#include <iterator>

#include <talus/level/placed_picture.h>
#include "../formats/tiled/tiled_flags.h"
#include "../formats/tiled/tiled_objects.h"
#include "../formats/tiled/tiled_properties.h"
#include "../level/tile_color.h"
#include "export_layers.h"

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
  tileset.tile_count = sheet.columns * sheet.rows();  // all that the picture has, as Tiled and STI count
  for (int id = 0; id < sheet.count; ++id) {
    const auto number = static_cast<TileNumber>(id);
    const TileShape shape = shape_of_tile(level, number);
    TiledTile tile;
    tile.id = id;
    tile.properties = tiled_flag_properties(level, level.tile_flags(number));
    const TiledProperties words = tiled_properties(shape);
    tile.properties.insert(tile.properties.end(), words.begin(), words.end());
    tile.objects = tiled_objects(shape, tileset.tile_size);
    add_note(note_of(level.tile_notes, number), tile);
    if (const TileAnimation* const animation = find_animation(level.animations, number)) {
      for (const AnimationFrame& frame : *animation) tile.animation.push_back({frame.tile, frame.duration});
    }
    const bool is_noted = !tile.type.empty() || tile.probability != 1;
    if (!tile.properties.empty() || !tile.animation.empty() || is_noted)
      tileset.tiles->push_back(std::move(tile));
  }
  return tileset;
}

TiledLayer tile_layer(const Level& level, int index) {
  TiledLayer layer;
  layer.has_tiles = true;
  layer.looks = level.layers.list[static_cast<std::size_t>(index)];
  layer.looks.cells = nullptr;
  layer.name = layer.looks.name.empty() ? kTiledTileLayer : layer.looks.name;
  const bool is_empty = level.layers.count() > 1 || is_tile_0_blank(level);
  const MapCells& cells = level.cells_of(index);
  layer.cells.reserve(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto [tile, turn] = cells[i];
    const std::uint32_t bits = static_cast<std::uint32_t>(turn) << kTiledTurnShift;
    layer.cells.push_back(tile == 0 && is_empty ? 0 : (tile + 1U) | bits);
  }
  return layer;
}

}  // namespace

TiledExport tiled_export_of(const ExportRequest& request) {
  const Level& level = request.level;
  TiledExport made;
  TiledMap& map = made.map;
  map.width = level.map.width();
  map.height = level.map.height();
  map.tile_size = level.map.tile_size();
  map.background = tiled_background(level);
  map.order = level.layers.order;
  map.tilesets.push_back(tileset_of(request));
  const TiledTileset& tiles = map.tilesets.front();
  ExportedLayers others =
      export_layers(level, request, tiles.first_gid + static_cast<std::uint32_t>(tiles.tile_count));
  if (others.tileset) map.tilesets.push_back(*std::move(others.tileset));
  map.groups = level.layers.groups;
  for (const LayerInOrder layer : layers_in_order(level)) {
    map.layers.push_back(layer.has_tiles ? tile_layer(level, layer.index)
                                         : std::move(others.layers[static_cast<std::size_t>(layer.index)]));
  }
  if (!level.objects.empty()) map.properties.push_back({std::string(kTiledObjectsProperty), true});
  made.objects = std::move(others.level);
  made.pictures = std::move(others.pictures);
  made.dropped = std::move(others.dropped);
  if (!level.large_tiles.empty())
    made.dropped.emplace_back("the parts of tiles that are outside of their cells");
  TiledLayer spawns, curves;
  spawns.name = kTiledSpawnLayer;
  for (const Spawn& spawn : level.spawns) spawns.objects.push_back(tiled_object(spawn));
  curves.name = kTiledCurveLayer;
  for (const LevelCurve& curve : level.curves) {
    if (auto object = tiled_object(curve)) curves.objects.push_back(*std::move(object));
  }
  map.layers.push_back(std::move(spawns));
  map.layers.push_back(std::move(curves));
  return made;
}

TiledProperties tiled_flag_properties(const Level& level, FlagSet flags) {
  if (flags == 0) return {};
  TiledProperties properties = {{"flags", tiled_number_of(flags)}};
  const auto names = tiled_flag_names(level);
  for (int flag = 0; flag < kMaxFlags; ++flag) {
    if (has_flag(flags, flag)) properties.push_back({names[static_cast<std::size_t>(flag)], true});
  }
  return properties;
}

void add_note(const TileNote& note, TiledTile& tile) {
  tile.type = note.type;
  tile.probability = note.probability;
  for (TiledProperty& property : properties_of_json(note.properties)) {
    const bool is_taken = std::any_of(tile.properties.begin(), tile.properties.end(),
                                      [&](const TiledProperty& own) { return own.name == property.name; });
    if (!is_taken) tile.properties.push_back(std::move(property));
  }
}

TiledProperties tiled_properties(const TileLayer& looks) {
  if (looks.is_ground) return {};
  return {{"ground", false}};
}

bool is_tile_0_blank(const Level& level) {
  return is_blank(level, 0) && level.tile_flags(0) == 0 &&
         shape_of_tile(level, 0).kind == TileShape::Kind::none;
}

Exported tiled_files(const ExportRequest& request, std::string text, std::vector<ExportedFile> pictures,
                     std::string tiles, std::vector<std::string> dropped) {
  const std::string name = request.sheet_name();
  if (request.name == "-") dropped.push_back("the picture " + name + ", which goes beside a file");
  Exported exported = exported_file(std::move(text), std::move(dropped));
  std::move(pictures.begin(), pictures.end(), std::back_inserter(exported.files));
  exported.files.push_back({name, std::move(tiles)});
  return exported;
}

}  // namespace talus
