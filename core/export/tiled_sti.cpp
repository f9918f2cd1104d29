// Maps for Simple Tiled Implementation. Its plugin for bump.lua knows full tiles, and boxes in an object
// layer. Full tiles go to the former, slopes to the latter, with the box that the solver `bump` has for them.
#include <talus/level/ground.h>
#include "../formats/pictures/png_sheet.h"
#include "../level/bump_boxes.h"
#include "export_targets.h"
#include "plain_data.h"
#include "tiled_model.h"

namespace talus {
namespace {

constexpr const char* kSlopeLayer = "slopes";
constexpr std::size_t kMostBoxes = 1'000'000;

bool is_full_tile(const TileShape& shape) { return shape.kind == TileShape::Kind::solid && !shape.one_way; }

// Instead of the bool of a flag with that name.
template <class Value>
void put(TiledProperties& properties, std::string_view name, Value value) {
  std::erase_if(properties, [&](const TiledProperty& property) { return property.name == name; });
  properties.push_back({std::string(name), value});
}

// Tiles say their flags and whether they are full. STI has no use for what Tiled knows about shapes.
void describe_tiles(const Level& level, const TerrainSource& ground, TiledTileset& tileset) {
  for (TiledTile& tile : *tileset.tiles) {
    tile.properties = tiled_flag_properties(level, level.tile_flags(static_cast<TileNumber>(tile.id)));
    if (is_full_tile(ground.shapes[static_cast<std::size_t>(tile.id)]))
      put(tile.properties, "collidable", true);
  }
}

TiledObject slope_object(const BumpBox& box, Cell cell, TileSize tile) {
  TiledObject object;
  object.type = box.line ? "slope" : "";
  object.position = {box.box.x + 1.0 * cell.x * tile.width, box.box.y + 1.0 * cell.y * tile.height};
  object.size = {box.box.w, box.box.h};
  put(object.properties, "collidable", true);
  if (!box.line) return object;
  if (box.line->one_way) put(object.properties, "one_way", true);
  put(object.properties, "slope", std::string(box.line->is_ceiling ? "ceiling" : "floor"));
  put(object.properties, "h0", box.line->h0);
  put(object.properties, "h1", box.line->h1);
  return object;
}

// In the order of the program's solver: column by column from left to right, each from top to bottom.
TiledLayer slope_layer(const TerrainSource& ground, const Progress& progress) {
  TiledLayer layer;
  layer.name = kSlopeLayer;
  layer.is_hidden = true;
  for (Cell c; c.x < ground.width && layer.objects.size() <= kMostBoxes && progress.at(c.x, ground.width);
       ++c.x) {
    for (c.y = 0; c.y < ground.height; ++c.y) {
      const auto at = static_cast<std::size_t>(c.y) * static_cast<std::size_t>(ground.width) +
                      static_cast<std::size_t>(c.x);
      const TileShape& shape = ground.shapes[ground.cells[at]];
      if (is_full_tile(shape)) continue;
      for (const BumpBox& box : bump_boxes(shape, ground.tile))
        layer.objects.push_back(slope_object(box, c, ground.tile));
    }
  }
  return layer;
}

}  // namespace

FormatResult<Exported> export_sti(const ExportRequest& request) {
  const TerrainSource ground = ground_of(request.level);
  TiledMap map = tiled_map_of(request);
  describe_tiles(request.level, ground, map.tilesets.front());
  std::vector<std::string> dropped;
  if (const std::size_t curves = map.layers.back().objects.size(); curves > 0)
    dropped.push_back("collision, which bump.lua cannot have, with " + std::to_string(curves) + " curve" +
                      (curves == 1 ? "" : "s"));
  for (std::string& phrase : dropped_by_bump(request.level)) dropped.push_back(std::move(phrase));
  map.layers.push_back(slope_layer(ground, request.progress.part(0.2, 0.5)));
  if (request.progress.stopped()) return Exported();
  if (map.layers.back().objects.size() > kMostBoxes)
    return tl::unexpected(FormatError{
        "", "the slopes need more than 1000000 boxes, too many for an STI map: make the map smaller"});
  return tiled_files(request, tiled_lua_text(map), write_map_tiles(request.level), std::move(dropped));
}

}  // namespace talus
