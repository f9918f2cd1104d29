// Which tile of a level each tile of a Tiled map becomes, and what it looks like.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "../import/linked_files.h"
#include "tiled_map.h"

namespace talus {

// The picture of a tileset.
struct TiledPicture {
  std::shared_ptr<const LinkedPicture> file;  // null for a collection
  // Of a collection, the picture of each tile by its id; null where it cannot be read.
  std::map<int, std::shared_ptr<const RgbaPicture>> of_tiles = {};
  std::map<int, std::string> paths_of_tiles = {};  // of these, as they were opened
  // Whether it cannot be read: numbered boxes stand for its tiles.
  bool is_missing() const { return file != nullptr && file->is_missing; }
};
// By tileset; tilesets of one file share it. Null: not known.
using TiledPictures = std::vector<std::shared_ptr<const TiledPicture>>;

// A tile of a tileset as cells of the map show it.
struct TiledSource {
  int tileset = -1;        // -1: a blank tile
  int id = 0;              // in the tileset
  std::uint32_t turn = 0;  // the bits kTiledFlipX and so on, if it is a tile of its own when it is turned
  friend auto operator<=>(const TiledSource&, const TiledSource&) = default;
};

struct TiledTiles {
  int columns = kCartColumns;                                               // of the level's sheet
  std::vector<TiledSource> sources = std::vector<TiledSource>(kCartTiles);  // by tile of the level
  std::vector<MapCells> cells;                                              // by layer, row by row
  bool is_0_empty = true;     // whether tile 0 stands for empty cells, too
  bool keeps_numbers = true;  // whether each tile has the number of its tileset, or its place on the sheet
};

// Numbers the tiles of some layers of the map. Without `used_tiles` the level gets all tiles of the tilesets
// that the map shows. A single one with the layout of the base keeps its numbers, and one of up to 16x16
// tiles lies on a cart's sheet, each tile at its place. Else the sheet is as wide as the widest tileset, and
// the tilesets lie below one another. Cells turn tiles of the size of a cell; others that the map turns
// become tiles of their own, behind the others. Tile 0 is the empty one: if it is drawn and some cells are
// empty, it swaps its number with a blank one, which is added behind the others if there is none. With
// `used_tiles` it gets only the tiles that the map shows. With a frame all tiles keep the numbers that they
// have there, and those that it lacks come behind them. progress: receives how many of the cells are
// numbered.
FormatResult<TiledTiles> number_tiles(const TiledMap& map, const std::vector<const TiledLayer*>& layers,
                                      const TiledPictures& pictures, const ImportChoices& choices,
                                      const SheetLayout& base, std::optional<Rgb> color_0, ImportDrops& drops,
                                      const Progress& progress);

// Columns and tiles of a tileset, computed from its picture if the file does not say. A collection may have
// no tiles.
SheetLayout grid_of(const TiledTileset& tileset);

// The place of each tileset of the map on the sheet, where most of its tiles lie. Empty if the tiles have new
// numbers, or if the tilesets lie among one another.
std::vector<Tileset> tilesets_of(const TiledTiles& tiles, const TiledMap& map);

// How the tiles and cells are numbered now.
TiledFrame frame_of(const TiledTiles& tiles, const TiledMap& map);

// Where a tile is drawn in a cell that shows it: its bottom left corner is that of the cell, moved by the
// offset of its tileset.
struct TiledPlace {
  TileSize size;            // px, of the tile in its picture, before it is turned
  Vec2 scale{1, 1};         // px of the map for each of them
  double x = 0, y = 0;      // px, of the top left corner of the turned tile in the cell
  bool is_in_cell = false;  // whether it reaches not beyond the cell, in its own size
};
TiledPlace place_of_tile(const TiledMap& map, const TiledPictures& pictures, const TiledSource& source);

// The tile of a number in cells, with the bits that turn it; of no tileset if none has it.
TiledSource source_of_gid(const TiledMap& map, std::uint32_t gid);

// Where the position of an object that shows the tile of a number is in its box, see TiledTileset.
Vec2 anchor_of_gid(const TiledMap& map, std::uint32_t gid);

// The size that a tile has in its picture, px.
TileSize size_in_picture(const TiledMap& map, const TiledPictures& pictures, const TiledSource& source);

// The sheet with the level's tiles, each as an image of that size: of tiles of another size some pixels are
// repeated or left out. Of tiles that reach beyond their cells it is the part in the cell. Unknown pixels are
// transparent, except those of missing pictures.
SheetPicture picture_of_tiles(const TiledTiles& tiles, const TiledMap& map, const TiledPictures& pictures,
                              TileSize image);

const TiledTile* find_tile(const TiledTileset& tileset, int id);  // null if the file says nothing about it

}  // namespace talus
