// Shapes as values of an IntGrid of LDtk.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <talus/collision/terrain.h>
#include <talus/level/progress.h>
#include <talus/level/tileset.h>

namespace talus {

// The value n is the entry n - 1 of values(): 1 a full tile, 2 a full one-way tile, and then, in the order of
// the tiles, those of each other shape: one for the cell of its tile, and one for each further cell that it
// reaches into, to the right, and up, or down from a ceiling.
class LdtkShapes {
 public:
  explicit LdtkShapes(const TerrainSource& ground);

  struct Value {
    // What it is: "slope_0_to_8_over_2_tiles", heights as TileShape has them, and for a further cell
    // "slope_0_to_8_over_2_tiles_part_2"; "..._part_1_row_2" is the cell above that of its tile.
    std::string name;
    const char* color;
  };
  const std::vector<Value>& values() const { return values_; }

  struct Grid {
    std::vector<std::uint16_t> cells;  // row by row; 0: empty
    std::size_t overlaps = 0;          // cells that a shape reaches into and that have another one's value
  };
  // A cell has the value of its own tile's shape; without one that of the first, in the order of rows, that
  // reaches into it. Cut short when the progress is stopped.
  Grid grid_of(const TerrainSource& ground, const Progress& progress) const;

 private:
  struct Part {
    int column, row;  // cells from that of the tile
    std::uint16_t value;
  };
  struct Shape {
    TileShape shape;
    std::uint16_t value;
    std::vector<Part> parts;  // further cells
  };

  void define(const TileShape& shape, const std::string& name);
  const Shape& of_tile(std::uint8_t tile) const { return shapes_[static_cast<std::size_t>(index_[tile])]; }

  std::vector<Value> values_;
  std::vector<Shape> shapes_;
  std::array<int, kTileCount> index_;  // by tile: of its shape; -1: none
};

// Letters, digits and '_' alone, and no digit first, as LDtk wants names.
std::string ldtk_identifier(const std::string& name);

}  // namespace talus
