// Maps for Simple Tiled Implementation. Its plugin for bump.lua knows full tiles, and boxes in an object
// layer. Full tiles go to the former, slopes to the latter, with the box that the solver `bump` has for them.
#include <vector>

#include <talus/level/ground.h>
#include "../collision/tile_outlines.h"
#include "../formats/pictures/png_sheet.h"
#include "../formats/tiled/tiled_properties.h"
#include "../level/bump_boxes.h"
#include "../level/level_text.h"
#include "export_targets.h"
#include "plain_data.h"
#include "tiled_model.h"

namespace talus {
namespace {

constexpr const char* kSlopeLayer = "slopes";
constexpr std::size_t kMaxBoxes = 1'000'000;

// By tile, whether it is full wherever the map shows it. In a layer that is only drawn it must not be, and
// the plugin does not tell layers apart; nor does it turn a tile whose sides are not equal.
std::vector<bool> collidable_tiles(const Level& drawn, const TerrainSource& ground) {
  std::vector<bool> collides;
  collides.reserve(static_cast<std::size_t>(drawn.tile_count()));
  for (int tile = 0; tile < drawn.tile_count(); ++tile)
    collides.push_back(is_full(ground.shapes[static_cast<std::size_t>(tile)]));
  for (int layer = 0; layer < drawn.layers.count(); ++layer) {
    const MapCells& cells = drawn.cells_of(layer);
    const bool is_ground = drawn.layers.list[static_cast<std::size_t>(layer)].is_ground;
    const bool is_square = ground.tile.width == ground.tile.height;
    if (is_ground && (is_square || !cells.has_turned())) continue;
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (!is_ground || has_flip(cells.turn_of(i), TileTurn::diagonal)) collides[cells.tiles()[i]] = false;
  }
  return collides;
}

// By cell, whether one of its tiles is collidable.
std::vector<bool> collidable_cells(const Level& drawn, const std::vector<bool>& tiles) {
  std::vector<bool> cells(drawn.map.cells().size());
  for (int layer = 0; layer < drawn.layers.count(); ++layer) {
    const std::vector<TileNumber>& of_layer = drawn.cells_of(layer).tiles();
    for (std::size_t cell = 0; cell < cells.size(); ++cell)
      if (tiles[of_layer[cell]]) cells[cell] = true;
  }
  return cells;
}

void mark_collidable_tiles(const std::vector<bool>& collides, TiledTileset& tileset) {
  for (TiledTile& tile : *tileset.tiles)
    if (collides[static_cast<std::size_t>(tile.id)]) put_property(tile.properties, {"collidable", true});
}

// What the plugin says of a full tile by the tile's own properties, for the boxes of a cell: the flags of all
// its tiles that are ground, and the speed of a conveyor.
TiledProperties cell_properties(const Level& drawn, std::size_t cell, const TileShape& shape) {
  FlagSet flags = 0;
  for (int layer = 0; layer < drawn.layers.count(); ++layer) {
    if (drawn.layers.list[static_cast<std::size_t>(layer)].is_ground)
      flags |= drawn.tile_flags(drawn.cells_of(layer).tiles()[cell]);
  }
  TiledProperties properties = tiled_flag_properties(drawn, flags);
  double speed = shape.conveyor;
  for (const TileShape& part : shape.parts) speed = speed == 0 ? part.conveyor : speed;
  if (speed != 0) properties.push_back({std::string(kTiledConveyor), speed});
  return properties;
}

// properties: of the cell.
TiledObject slope_object(const BumpBox& box, Cell cell, TileSize tile, TiledProperties properties) {
  TiledObject object;
  object.properties = std::move(properties);
  object.type = box.line ? "slope" : "";
  object.position = {box.box.x + 1.0 * cell.x * tile.width, box.box.y + 1.0 * cell.y * tile.height};
  object.size = {box.box.w, box.box.h};
  put_property(object.properties, {"collidable", true});
  if (!box.line) return object;
  if (box.line->one_way) put_property(object.properties, {"one_way", true});
  put_property(object.properties, {"slope", std::string(box.line->is_ceiling ? "ceiling" : "floor")});
  put_property(object.properties, {"h0", box.line->h0});
  put_property(object.properties, {"h1", box.line->h1});
  return object;
}

// The number of boxes that slope_layer() makes.
std::size_t count_slope_boxes(const TerrainSource& ground, const std::vector<bool>& collides) {
  std::vector<std::size_t> of_tiles;
  of_tiles.reserve(ground.shapes.size());
  for (const TileShape& shape : ground.shapes) of_tiles.push_back(bump_boxes(shape, ground.tile).size());
  std::size_t count = 0;
  for (std::size_t cell = 0; cell < ground.cells.size(); ++cell)
    if (!collides[cell]) count += of_tiles[ground.cells[cell]];
  return count;
}

// In the order of the program's solver: column by column from left to right, each from top to bottom.
// collides: by cell, whether a tile collides there already.
TiledLayer slope_layer(const Level& drawn, const TerrainSource& ground, const std::vector<bool>& collides,
                       const Progress& progress) {
  TiledLayer layer;
  layer.name = kSlopeLayer;
  layer.is_hidden = true;
  for (Cell c; c.x < ground.width && progress.at(c.x, ground.width); ++c.x) {
    for (c.y = 0; c.y < ground.height; ++c.y) {
      const auto at = static_cast<std::size_t>(c.y) * static_cast<std::size_t>(ground.width) +
                      static_cast<std::size_t>(c.x);
      if (collides[at]) continue;
      const TileShape& shape = ground.shapes[ground.cells[at]];
      const std::vector<BumpBox> boxes = bump_boxes(shape, ground.tile);
      if (boxes.empty()) continue;
      const TiledProperties properties = cell_properties(drawn, at, shape);
      for (const BumpBox& box : boxes) layer.objects.push_back(slope_object(box, c, ground.tile, properties));
    }
  }
  return layer;
}

// The ground of objects is in the tiles and slopes: the plugin must not add boxes of them besides.
void leave_ground_to_slopes(TiledMap& map) {
  for (TiledLayer& layer : map.layers) {
    for (TiledObject& object : layer.objects)
      std::erase_if(object.properties,
                    [](const TiledProperty& property) { return property.name == "collidable"; });
  }
}

}  // namespace

FormatResult<Exported> export_sti(const ExportRequest& request) {
  const TerrainSource ground = ground_of(request.level);
  const Level& drawn = request.drawn();
  const std::vector<bool> collides = collidable_tiles(drawn, ground);
  const std::vector<bool> collides_in_cells = collidable_cells(drawn, collides);
  if (count_slope_boxes(ground, collides_in_cells) > kMaxBoxes)
    return tl::unexpected(FormatError{
        "", "the slopes need more than 1000000 boxes, too many for an STI map: make the map smaller"});
  TiledExport made = tiled_export_of({drawn, request.name, request.read_asset});
  TiledMap& map = made.map;
  mark_collidable_tiles(collides, map.tilesets.front());
  leave_ground_to_slopes(map);
  std::vector<std::string> dropped = std::move(made.dropped);
  if (const std::size_t curves = map.layers.back().objects.size(); curves > 0)
    dropped.push_back("collision, which bump.lua cannot have, with " + count_text(curves, "curve"));
  for (std::string& phrase : dropped_by_bump(request.level)) dropped.push_back(std::move(phrase));
  tell_body_pictures(request.level, dropped);
  map.layers.push_back(slope_layer(drawn, ground, collides_in_cells, request.progress.part(0.2, 0.5)));
  if (request.progress.stopped()) return Exported();
  return tiled_files(request, tiled_lua_text(map), std::move(made.pictures), write_map_tiles(drawn),
                     std::move(dropped));
}

}  // namespace talus
