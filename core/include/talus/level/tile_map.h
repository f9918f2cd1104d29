// A rectangle of cells with tiles, and the size of the cells.
#pragma once

#include <cassert>
#include <cmath>

#include <talus/collision/shape.h>
#include <talus/level/map_cells.h>

namespace talus {

inline constexpr int kTicMapWidth = 240;   // cells, of every TIC-80 map
inline constexpr int kTicMapHeight = 136;  // cells, the same
inline constexpr int kScreenColumns = 30;  // cells, of one TIC-80 screen
inline constexpr int kScreenRows = 17;     // cells, the same

// A map is a value; at first every cell has tile 0.
class TileMap {
 public:
  // width, height: cells; tile: the size of each. is_terrain_size must allow them (asserted).
  explicit TileMap(int width = kTicMapWidth, int height = kTicMapHeight, TileSize tile = {})
      : width_(width), height_(height), tile_(tile), cells_(static_cast<std::size_t>(width) * height) {
    assert(is_terrain_size(width, height, tile));
  }

  int width() const { return width_; }                                  // cells
  int height() const { return height_; }                                // cells
  TileSize tile_size() const { return tile_; }                          // of each cell
  double px_width() const { return x_of(width_); }                      // px, of the whole map
  double px_height() const { return y_of(height_); }                    // px, of the whole map
  double x_of(int column) const { return 1.0 * column * tile_.width; }  // px, of its left side
  double y_of(int row) const { return 1.0 * row * tile_.height; }       // px, of its top
  Vec2 corner_of(Cell c) const { return {x_of(c.x), y_of(c.y)}; }       // px, its top left
  Rect box_of(Cell c) const { return {x_of(c.x), y_of(c.y), 1.0 * tile_.width, 1.0 * tile_.height}; }  // px
  // The column that holds an x, px, on the map or off it. The x must be about within kMaxCoordinate of the
  // origin.
  int column_at(double x) const { return static_cast<int>(std::floor(x / tile_.width)); }
  // The row that holds a y, as above.
  int row_at(double y) const { return static_cast<int>(std::floor(y / tile_.height)); }
  // The cell that holds a point, as above.
  Cell cell_at(Vec2 point) const { return {column_at(point.x), row_at(point.y)}; }
  // Whether the cell lies inside the map.
  bool contains(Cell c) const { return c.x >= 0 && c.y >= 0 && c.x < width_ && c.y < height_; }

  // What a cell holds. It must lie inside the map (asserted).
  MapCell at(Cell c) const { return cells_[index(c)]; }
  // The number of the tile in a cell; as at().
  TileNumber tile_at(Cell c) const { return cells_.tiles()[index(c)]; }
  // Puts something there; as at().
  void set(Cell c, MapCell cell) { cells_.set(index(c), cell); }

  const MapCells& cells() const { return cells_; }  // row by row
  MapCells& cells() { return cells_; }              // keep its size
  friend bool operator==(const TileMap&, const TileMap&) = default;

 private:
  std::size_t index(Cell c) const {
    assert(contains(c));
    return static_cast<std::size_t>(c.y) * width_ + c.x;
  }
  int width_;
  int height_;
  TileSize tile_;
  MapCells cells_;
};

}  // namespace talus
