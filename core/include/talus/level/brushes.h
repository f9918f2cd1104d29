// Brushes of a level: stamps with a name.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <talus/level/map_cells.h>

namespace talus {

inline constexpr int kMaxBrushSide = 256;           // cells
inline constexpr std::size_t kMaxBrushes = 1000;    // of a level
inline constexpr std::size_t kMaxBrushName = 1000;  // bytes

// A rectangle of tiles to paint with.
struct Brush {
  std::string name;                          // for people; may be empty or repeated
  int w = 1;                                 // cells, 1..kMaxBrushSide
  int h = 1;                                 // cells, 1..kMaxBrushSide
  std::vector<MapCell> tiles = {MapCell()};  // w*h, row by row
  bool random = false;  // each cell gets a random tile of the brush, instead of the rectangle
  std::string extra;    // JSON object of keys that this version does not know, or empty
  friend bool operator==(const Brush&, const Brush&) = default;
};

}  // namespace talus
