// Which tiles the ground of a level has in each cell, whatever the number of layers.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <talus/collision/terrain.h>
#include <talus/level/level.h>

namespace talus {

// The tiles of several layers in one cell, from the back to the front, or one that is turned. Tiles that are
// neither ground nor bodies are left out. A turn that changes nothing of the ground is TileTurn::none.
using TileStack = std::vector<MapCell>;

// The cells of a level's ground. With one layer of ground, of which nothing is turned, they are that layer's.
// Else a cell with one tile that is not turned has that tile, and any other has a stack. A stack has the
// number tile_count() + its index. Refers to the level, which must stay alive.
struct GroundCells {
  std::span<const TileNumber>
      cells;                      // row by row: numbers of tiles and of stacks; empty if `overflow` is not 0
  std::vector<TileStack> stacks;  // sorted, each there once; empty if `cells` are a layer
  std::size_t overflow = 0;       // how many stacks there would be, if they are too many for TileNumber
  std::vector<TileNumber> own;    // what `cells` refers to, if that is not a layer
};
GroundCells ground_cells(const Level& level);

// The number of what a cell has in GroundCells of the same level or of one with other cells; nothing if these
// stacks lack it.
std::optional<TileNumber> ground_number(const Level& level, std::span<const TileStack> stacks, Cell cell);

// The tiles that a number of GroundCells stands for, each once: itself, or those of the stack.
TileStack tiles_of(TileNumber number, std::span<const TileStack> stacks, int tile_count);

// The shape of a number of GroundCells, invalid or not; a stack of several tiles is a group of
// their shapes.
TileShape shape_of_number(const Level& level, std::span<const TileStack> stacks, TileNumber number);

// The level without ground and bodies of tiles; curves and spawns stay.
Level without_tiles(const Level& level);

// As in <talus/level/ground.h>, with the ground_cells() of the level. The first must have no overflow.
TerrainSource ground_of(const Level& level, const GroundCells& ground);
std::size_t ground_lines(const Level& level, const GroundCells& ground);
std::optional<std::string> ground_problem(const Level& level, const GroundCells& ground);

}  // namespace talus
