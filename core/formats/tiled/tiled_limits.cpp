// Compares a level with what its map had when it was opened.
#include "tiled_limits.h"

#include <algorithm>
#include <utility>

#include "level/merge.h"

namespace talus {
namespace {

bool has_tiles_off_map(const std::vector<TiledBlock>& blocks, const TiledFrame& frame) {
  const auto has_one = [&](const TiledBlock& block) {
    for (std::size_t i = 0; i < block.cells.size(); ++i) {
      const auto x = static_cast<int>(i % static_cast<std::size_t>(block.width));
      const auto y = static_cast<int>(i / static_cast<std::size_t>(block.width));
      if (block.cells[i] != 0 && was_off_map({block.x + x - frame.x, block.y + y - frame.y}, frame))
        return true;
    }
    return false;
  };
  return std::any_of(blocks.begin(), blocks.end(), has_one);
}

// Of a level with other layers or another size.
void add_limits_of_map(const Level& level, std::vector<BeyondTiled>& found) {
  const auto document = tiled_document(level.tiled->bytes);
  if (!document) return;  // saving says so
  if (auto layers = layers_beyond_tiled(level, **document))
    found.push_back({TiledLimit::layers, *std::move(layers)});
  if (auto size = size_beyond_tiled(level, **document); size && *size)
    found.push_back({TiledLimit::size, **std::move(size)});
}

}  // namespace

FormatError not_in_tiled(std::string why, std::string remedy) {
  return FormatError{"", std::move(why), std::move(remedy)};
}

bool is_one_of_many(const TiledOrigin& origin, const TiledDocument& document) {
  const int in_file = document.layer_count();
  return in_file > 0 && static_cast<int>(origin.layers.size()) != in_file;
}

bool is_resized(const Level& level) {
  const TiledFrame& frame = level.tiled->frame;
  return level.map.width() != frame.width || level.map.height() != frame.height;
}

bool was_off_map(Cell cell, const TiledFrame& frame) {
  return cell.x < 0 || cell.x >= frame.width || cell.y < 0 || cell.y >= frame.height;
}

// A map of objects alone gets its first layer of tiles; a tileset has none.
std::optional<FormatError> layers_beyond_tiled(const Level& level, const TiledDocument& document) {
  const bool is_tileset = !document.is_map() && document.layer_count() == 0;
  if (!is_tileset && !is_one_of_many(*level.tiled, document)) return std::nullopt;
  if (level.layers.count() == level.tiled->opened->layers.count()) return std::nullopt;
  return not_in_tiled("has other layers of tiles than the map");
}

FormatResult<std::optional<FormatError>> size_beyond_tiled(const Level& level,
                                                           const TiledDocument& document) {
  if (document.is_infinite() || document.layer_count() == 0 || !is_resized(level)) return std::nullopt;
  const TiledOrigin& origin = *level.tiled;
  if (is_one_of_many(origin, document)) {
    return not_in_tiled("has another size than the map, whose other layers would have to be cut with it");
  }
  for (int layer = 0; layer < level.layers.count(); ++layer) {
    const int opened = matching_layer(level, layer, *origin.opened);
    if (opened < 0) continue;
    const auto blocks = document.blocks(origin.layers[static_cast<std::size_t>(opened)]);
    if (!blocks) return tl::unexpected(blocks.error());
    if (has_tiles_off_map(*blocks, origin.frame)) {
      return not_in_tiled("has another size than the map, which has tiles off it that would be lost",
                          "take back the new size, or save the level as .talus.json");
    }
  }
  return std::nullopt;
}

std::optional<FormatError> tile_beyond_tiled(TileNumber tile, const TiledFrame& frame) {
  if (tile == 0 || (tile < frame.tiles.size() && frame.tiles[tile] != 0)) return std::nullopt;
  return not_in_tiled("shows tile " + std::to_string(tile) + ", which no tileset of the map has");
}

std::optional<FormatError> cells_beyond_tiled(const MapCells& cells, const TiledFrame& frame) {
  for (const TileNumber tile : cells.tiles())
    if (auto beyond = tile_beyond_tiled(tile, frame)) return beyond;
  return std::nullopt;
}

std::optional<FormatError> tiles_beyond_tiled(const Level& level) {
  const TiledOrigin& origin = *level.tiled;
  const Sheet &now = level.sheet(SheetId::tiles), &then = origin.opened->sheet(SheetId::tiles);
  if (now.layout() != then.layout()) return not_in_tiled("has tiles that no tileset of the map has");
  if (level.map.tile_size() != origin.opened->map.tile_size())
    return not_in_tiled("has tiles of another size than the map");
  const std::vector<std::uint32_t>& tiles = origin.frame.tiles;
  if (std::find(tiles.begin() + 1, tiles.end(), 0U) == tiles.end()) return std::nullopt;
  for (int layer = 0; layer < level.layers.count(); ++layer)
    if (auto beyond = cells_beyond_tiled(level.cells_of(layer), origin.frame)) return beyond;
  return std::nullopt;
}

std::vector<BeyondTiled> beyond_tiled(const Level& level) {
  std::vector<BeyondTiled> found;
  if (!level.tiled) return found;
  if (auto tiles = tiles_beyond_tiled(level)) found.push_back({TiledLimit::tiles, *std::move(tiles)});
  if (level.layers.count() != level.tiled->opened->layers.count() || is_resized(level))
    add_limits_of_map(level, found);
  return found;
}

}  // namespace talus
