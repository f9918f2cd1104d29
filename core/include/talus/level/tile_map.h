// A rectangle of tile numbers.
#pragma once

#include <cassert>
#include <cstdint>
#include <vector>

#include <talus/collision/shape.h>

namespace talus {

inline constexpr int kTicMapWidth = 240;   // cells, of every TIC-80 map
inline constexpr int kTicMapHeight = 136;  // cells, the same
inline constexpr int kScreenColumns = 30;  // cells, of one TIC-80 screen
inline constexpr int kScreenRows = 17;     // cells, the same

// A map is a value; at first every cell has tile 0.
class TileMap {
 public:
  // width, height: cells; is_terrain_size must allow them (asserted).
  explicit TileMap(int width = kTicMapWidth, int height = kTicMapHeight)
      : width_(width), height_(height), cells_(static_cast<std::size_t>(width) * height) {
    assert(is_terrain_size(width, height));
  }

  int width() const { return width_; }    // cells
  int height() const { return height_; }  // cells
  // Whether the cell lies inside the map.
  bool contains(Cell c) const { return c.x >= 0 && c.y >= 0 && c.x < width_ && c.y < height_; }

  // The number of the tile in a cell, which must lie inside the map (asserted).
  std::uint8_t at(Cell c) const { return cells_[index(c)]; }
  // Puts a tile there; as at().
  void set(Cell c, std::uint8_t tile) { cells_[index(c)] = tile; }

  const std::vector<std::uint8_t>& cells() const { return cells_; }  // row by row
  std::vector<std::uint8_t>& cells() { return cells_; }              // keep its size
  friend bool operator==(const TileMap&, const TileMap&) = default;

 private:
  std::size_t index(Cell c) const {
    assert(contains(c));
    return static_cast<std::size_t>(c.y) * width_ + c.x;
  }
  int width_;
  int height_;
  std::vector<std::uint8_t> cells_;
};

}  // namespace talus
