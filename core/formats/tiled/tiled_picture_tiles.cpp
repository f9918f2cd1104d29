// Finds the part of a picture for each tile, as picture_of_tiles() draws it.
#include "tiled_picture_tiles.h"

#include <optional>

namespace talus {
namespace {

TileSource source_in_tileset(const TiledMap& map, const TiledPictures& pictures, const TiledSource& source,
                             PictureTiles& found) {
  TileSource part;
  part.problem = "it is empty; choose another one on the sheet";
  if (source.tileset < 0) return part;
  const auto of = static_cast<std::size_t>(source.tileset);
  const TiledTileset& tileset = map.tilesets[of];
  part.problem = "its picture is missing";
  if (pictures[of] == nullptr) return part;
  const auto own = pictures[of]->of_tiles.find(source.id);
  const bool is_known = tileset.is_collection ? own != pictures[of]->of_tiles.end() && own->second != nullptr
                                              : pictures[of]->file != nullptr && !pictures[of]->is_missing();
  if (!is_known) return part;
  part.problem = "its picture is in the text of the map, not in a file of its own";
  const std::string& path =
      tileset.is_collection ? pictures[of]->paths_of_tiles.at(source.id) : pictures[of]->file->path;
  if (path.empty()) return part;
  part.problem = "it is a turned copy of another tile, which can be painted";
  if (source.turn != 0) return part;
  const TiledPlace place = place_of_tile(map, pictures, source);
  part.problem = "it has another size than the cells of the map";
  if (!place.is_in_cell) return part;
  part.problem = nullptr;
  part.corner = {static_cast<int>(place.x), static_cast<int>(place.y)};
  if (tileset.is_collection) {
    const TiledTile* const tile = find_tile(tileset, source.id);
    part.part = {tile == nullptr ? 0 : tile->image_x, tile == nullptr ? 0 : tile->image_y, place.size.width,
                 place.size.height};
    part.file = found.file_at(path, std::nullopt);
    return part;
  }
  const int columns = grid_of(tileset).columns, row = source.id / columns, column = source.id % columns;
  part.part = {tileset.margin + column * (place.size.width + tileset.spacing),
               tileset.margin + row * (place.size.height + tileset.spacing), place.size.width,
               place.size.height};
  part.file = found.file_at(path, tileset.transparent);
  return part;
}

}  // namespace

PictureTiles picture_tiles_of(const TiledTiles& tiles, const TiledMap& map, const TiledPictures& pictures) {
  PictureTiles found;
  found.tiles.reserve(tiles.sources.size());
  for (const TiledSource& source : tiles.sources)
    found.tiles.push_back(source_in_tileset(map, pictures, source, found));
  return found;
}

}  // namespace talus
