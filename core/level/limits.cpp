// Counts what a level holds.
#include <talus/level/limits.h>

#include <algorithm>
#include <set>

namespace talus {
namespace {

// Pixels of all pictures of large tiles, of objects and of layers, each once.
std::size_t part_pixels_of(const Level& level) {
  std::set<std::shared_ptr<const SheetPicture>> pictures;
  for (const auto& [tile, large] : level.large_tiles) pictures.insert(large.part.picture);
  for (const ObjectLayer& layer : level.objects) {
    if (layer.image) pictures.insert(layer.image->part.picture);
    for (const MapObject& object : layer.objects) pictures.insert(object.picture.picture);
  }
  std::size_t pixels = 0;
  for (const auto& picture : pictures) pixels += picture == nullptr ? 0 : picture->rgba.size() / 4;
  return pixels;
}

struct Amounts {
  std::size_t shape_numbers = 0, heights = 0, curve_cells = 0, layer_cells = 0, turned_cells = 0,
              brush_cells = 0, name_bytes = 0, unknown_bytes = 0, objects = 0, object_points = 0,
              object_bytes = 0, frames = 0, note_bytes = 0;
};

// The texts that every entry of a list has.
template <class Entry>
void count_texts(const Entry& entry, Amounts& amounts) {
  amounts.name_bytes += entry.name.size();
  amounts.unknown_bytes += entry.extra.size();
}

void count_objects(const std::vector<ObjectLayer>& layers, Amounts& amounts) {
  for (const ObjectLayer& layer : layers) {
    count_texts(layer, amounts);
    if (layer.image) amounts.name_bytes += layer.image->path.size();
    amounts.objects += layer.objects.size();
    for (const MapObject& object : layer.objects) {
      amounts.object_points += object.points.size();
      amounts.object_bytes += object.name.size() + object.type.size() + object.properties.size();
    }
  }
}

// The heights and the points of a shape and of its parts.
std::size_t numbers_of(const TileShape& shape) {
  std::size_t numbers = shape.heights.size() + shape.points.size();
  for (const TileShape& part : shape.parts) numbers += numbers_of(part);
  return numbers;
}

Amounts amounts_of(const Level& level) {
  Amounts amounts;
  amounts.unknown_bytes = level.extra.size();
  for (const std::string& name : level.flag_names) amounts.name_bytes += name.size();
  for (const FlagField& field : level.flag_fields) {
    count_texts(field, amounts);
    for (const std::string& value : field.values) amounts.name_bytes += value.size();
  }
  for (const TileShape& shape : level.tile_shapes) amounts.shape_numbers += numbers_of(shape);
  for (const auto& [tile, animation] : level.animations) amounts.frames += animation.size();
  for (const auto& [tile, note] : level.tile_notes)
    amounts.note_bytes += note.type.size() + note.properties.size();
  for (const Spawn& spawn : level.spawns) count_texts(spawn, amounts);
  for (const LevelCurve& curve : level.curves) {
    count_texts(curve, amounts);
    if (const auto* line = std::get_if<Polyline>(&curve.curve.form)) amounts.heights += line->ys.size();
    if (!problem_of(curve.curve))
      amounts.curve_cells += static_cast<std::size_t>(cells_passed(curve.curve, level.map.tile_size()));
  }
  amounts.turned_cells = level.map.cells().turns().size();
  for (const TileLayer& layer : level.layers.list) {
    count_texts(layer, amounts);
    if (layer.cells != nullptr) amounts.turned_cells += layer.cells->turns().size();
    // The chosen layer has its cells elsewhere, and as many as any other.
    if (layer.cells != nullptr) amounts.layer_cells = layer.cells->size() * level.layers.list.size();
  }
  count_objects(level.objects, amounts);
  for (const Brush& brush : level.brushes) {
    count_texts(brush, amounts);
    amounts.brush_cells += brush.tiles.size();
  }
  for (const ExportPreset& preset : level.exports) {
    count_texts(preset, amounts);
    amounts.name_bytes += preset.exporter.size() + preset.path.size() + preset.parts.size();
  }
  for (const Tileset& set : level.tilesets) {
    count_texts(set, amounts);
    if (set.link) amounts.name_bytes += set.link->path.size();
  }
  return amounts;
}

std::size_t picture_bytes(const Level& level) {
  const auto& picture = level.sheet(SheetId::tiles).picture;
  return picture == nullptr ? 0 : picture->rgba.size();
}

}  // namespace

std::optional<std::string> problem_of_amounts(const Level& level) {
  const Amounts amounts = amounts_of(level);
  struct Row {
    std::size_t has, most;
    const char* what;
  };
  for (const Row& row :
       {Row{level.spawns.size(), kMaxSpawns, "bodies"},
        {level.curves.size(), kMaxCurves, "curves"},
        {amounts.shape_numbers, kMaxShapeNumbers, "heights and points of the shapes of tiles"},
        {amounts.heights, kMaxLevelHeights, "heights of polylines"},
        {amounts.curve_cells, kMaxCurveCells, "cells that curves pass"},
        {level.layers.list.size(), kMaxLayers, "layers"},
        {amounts.layer_cells, kMaxLayerCells, "cells of all layers"},
        {level.objects.size(), kMaxObjectLayers, "layers of objects"},
        {amounts.objects, kMaxMapObjects, "objects"},
        {amounts.object_points, kMaxObjectPoints, "points of objects"},
        {amounts.object_bytes, kMaxObjectBytes, "bytes of names and properties of objects"},
        {part_pixels_of(level), kMaxPartPixels, "px of pictures of tiles, objects and layers"},
        {level.brushes.size(), kMaxBrushes, "brushes"},
        {amounts.brush_cells, kMaxBrushCells, "cells of brushes"},
        {level.exports.size(), kMaxExports, "export presets"},
        {level.tilesets.size(), kMaxTilesets, "tilesets"},
        {amounts.frames, kMaxAnimationFrames, "frames of animations"},
        {amounts.note_bytes, kMaxNoteBytes, "bytes of classes and properties of tiles"},
        {amounts.name_bytes, kMaxNameBytes, "bytes of names"},
        {amounts.unknown_bytes, kMaxUnknownBytes, "bytes of unknown members"}}) {
    if (row.has > row.most)
      return "has " + std::to_string(row.has) + " " + row.what + ", but a level holds at most " +
             std::to_string(row.most);
  }
  return std::nullopt;
}

std::size_t size_of(const std::vector<ObjectLayer>& objects) {
  Amounts amounts;
  count_objects(objects, amounts);
  return objects.size() * sizeof(ObjectLayer) + amounts.objects * sizeof(MapObject) +
         amounts.object_points * sizeof(Vec2) + amounts.object_bytes + amounts.name_bytes;
}

std::size_t size_of(const Level& level) {
  constexpr std::size_t kEntry = 128;  // bytes, about what an entry takes in memory or as text
  const Amounts amounts = amounts_of(level);
  return (level.cart ? level.cart->bytes.size() : 0) + (level.tiled ? level.tiled->bytes.size() : 0) +
         (level.ldtk ? kEntry * level.ldtk->tiles.size() : 0) +
         std::max(level.map.cells().size(), amounts.layer_cells) * sizeof(TileNumber) +
         amounts.turned_cells * sizeof(TileTurn) + amounts.brush_cells * sizeof(MapCell) +
         level.sheet(SheetId::tiles).images.size() * sizeof(TileImage) + picture_bytes(level) +
         (amounts.shape_numbers + amounts.heights) * sizeof(double) + amounts.name_bytes +
         amounts.unknown_bytes + size_of(level.objects) +
         kEntry * (level.spawns.size() + level.curves.size() + level.brushes.size() + level.exports.size() +
                   level.tilesets.size() + amounts.frames);
}

}  // namespace talus
