// LdtkShapes: shapes as values of an IntGrid of LDtk.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <talus/collision/terrain.h>
#include <talus/level/progress.h>
#include <talus/level/tileset.h>

namespace talus {

// The value n stands for entry n - 1 of values(): 1 is a full tile, 2 a full one-way tile. Then come the
// other shapes in the order of the tiles: one value for the cell of the tile, and one for each further cell
// that the shape reaches into, to the right, and up, or down from a ceiling.
class LdtkShapes {
 public:
  explicit LdtkShapes(const TerrainSource& ground);

  struct Value {
    // Describes it: "slope_0_to_8_over_2_tiles", with heights as in TileShape. A further cell is
    // "slope_0_to_8_over_2_tiles_part_2"; "..._part_1_row_2" is the cell above that of the tile.
    std::string name;
    const char* color;
  };
  const std::vector<Value>& values() const { return values_; }

  struct Grid {
    std::vector<std::uint16_t> cells;  // row by row; 0: empty
    std::size_t overlaps = 0;  // cells that a shape reaches into, but that have the value of another one
  };
  // A cell has the value of its own tile's shape. Without one it has that of the first shape, in the order of
  // rows, that reaches into it. Incomplete if the progress was stopped.
  Grid grid_of(const TerrainSource& ground, const Progress& progress) const;

 private:
  struct Part {
    int column, row;  // cells, relative to the cell of the tile
    std::uint16_t value;
  };
  struct Shape {
    TileShape shape;
    std::uint16_t value;
    std::vector<Part> parts;  // further cells
  };

  void define(const TileShape& shape, const std::string& name);
  const Shape& of_tile(TileNumber tile) const { return shapes_[static_cast<std::size_t>(index_[tile])]; }

  TileSize tile_;
  std::vector<Value> values_;
  std::vector<Shape> shapes_;
  std::vector<int> index_;  // by tile: index of its shape; -1: no shape
};

// Only letters, digits and '_', and no digit first, as LDtk needs names. thing: the word that goes before a
// digit, and in the place of an empty name.
std::string ldtk_identifier(const std::string& name, const char* thing = "Level");

}  // namespace talus
