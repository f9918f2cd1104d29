// Which tiles of a level stand for the cells of a level of LDtk.
//
// A cell of a layer of LDtk shows parts of any number of tiles, which need not lie on the grid. Cells that
// look the same and have the same value and tags are one tile of the level, whose picture is composed of
// them.
#pragma once

#include <compare>
#include <memory>
#include <string>
#include <vector>

#include "../import/import_drops.h"
#include "../import/linked_files.h"
#include "ldtk_project.h"

namespace talus {

// By tileset; null: its picture is not known.
using LdtkPictures = std::vector<std::shared_ptr<const LinkedPicture>>;

// Limits for the level that is read.
inline constexpr std::size_t kMaxLdtkParts = std::size_t{1} << 22;  // parts of tiles in all cells together
inline constexpr std::size_t kMaxLdtkCellParts = std::size_t{1} << 16;  // of one cell
inline constexpr std::size_t kMaxLdtkPixels =
    std::size_t{1} << 28;  // of different parts, and of the parts of different cells

// A tile as some cells show it.
struct LdtkSource {
  int tileset = -1;       // -1: a rectangle of one colour
  int x = 0, y = 0;       // px, of its corner in the tileset's picture
  int id = 0;             // in the tileset
  int side = 1;           // px
  int flips = 0;          // bit 0: left and right are swapped, bit 1: up and down
  int opacity = 255;      // 0..255
  std::uint32_t rgb = 0;  // of the rectangle
  friend auto operator<=>(const LdtkSource&, const LdtkSource&) = default;
};

// A tile's part in a cell.
struct LdtkPart {
  std::uint32_t source = 0;  // its index
  int x = 0, y = 0;          // px, of the tile's corner in the cell; may be outside of it
  bool is_hidden = false;    // whether nothing of it is seen: only its tags count
  friend auto operator<=>(const LdtkPart&, const LdtkPart&) = default;
};

// A value of an IntGrid in a cell.
struct LdtkCellValue {
  static constexpr int kUnknownLayer = -1;  // a layer without a definition
  static constexpr int kNoCell = -2;        // `value` numbers a tile that stands for no cell of LDtk
  int layer = kUnknownLayer;                // index in LdtkProject::layers
  int value = 0;                            // 0: none
  friend auto operator<=>(const LdtkCellValue&, const LdtkCellValue&) = default;
};

// What a tile of the level stands for.
struct LdtkCell {
  std::vector<LdtkPart> parts;  // from the lowest
  LdtkCellValue value;
  friend auto operator<=>(const LdtkCell&, const LdtkCell&) = default;
};

// Whether a tile lies where a tile of the level's size does, so that its tags count.
inline bool is_in_place(const LdtkPart& part, const LdtkSource& source, TileSize tile) {
  return part.x == 0 && part.y == 0 && source.side == tile.width;
}

// The key in TileLayer::extra with what a layer is known by in its project, and in ObjectLayer::extra of the
// picture behind the level, with kLdtkBackground.
inline constexpr const char* kLdtkLayerKey = "ldtk";
inline constexpr const char* kLdtkBackground = "background";

struct LdtkTiles {
  TileMap map;  // as large as each layer, and empty
  // From the back, with their cells: those with tiles or values, and at least one. None is ground yet.
  std::vector<TileLayer> layers;
  int ground = 0;               // index of the layer that is the ground's, or else of the last one
  std::vector<LdtkCell> cells;  // by tile of the level; 0 is the empty one
  std::vector<LdtkSource> sources;
};

// The layer whose grid the level has: the IntGrid of the choice; else one whose name says that it is ground,
// such as "Collisions", or the one with the most values; without an IntGrid, the layer with the most tiles.
// -1: no layer has a grid. choices: `layer` and `layer_number` choose among the IntGrids, from the top.
FormatResult<int> ldtk_ground_layer(const LdtkLevel& level, const ImportChoices& choices);

// Whether the layer becomes a layer of tiles: it has tiles or values, or is the ground.
bool is_taken(const LdtkLayer& layer, bool is_ground);

// ground: from ldtk_ground_layer(). known: what the first tiles stand for, from ldtk_keys_of(); those that
// are no such texts stand for no cell.
FormatResult<LdtkTiles> ldtk_tiles_of(const LdtkProject& project, const LdtkLevel& level, int ground,
                                      const std::vector<std::string>& known, const LdtkPictures& pictures,
                                      ImportDrops& drops, const Progress& progress);

// The picture of a tile, of the size of the map's: for each pixel red, green, blue, opacity.
std::vector<std::uint8_t> picture_of_ldtk_cell(const LdtkTiles& tiles, const LdtkCell& cell,
                                               const LdtkPictures& pictures);

// The colour of a pixel of a tile that lies at (x, y) of its place in the map, flips included. x, y:
// 0..side-1.
struct LdtkColor {
  int r = 0, g = 0, b = 0;
  int a = 0;  // opacity, 0..255
};
LdtkColor color_in_ldtk_source(const LdtkSource& source, const LdtkPictures& pictures, int x, int y);

}  // namespace talus
