// Small maps from text, for the tests of the compiled ground.
#pragma once

#include <string>
#include <vector>

#include <talus/collision/terrain.h>

namespace talus {

inline constexpr TileNumber kSolid = 1, kUp = 2, kDown = 3, kHill = 4, kWide = 5, kCeiling = 6, kPlatform = 7,
                            kLow = 8, kTall = 9, kHanging = 10, kTail = 11, kFlat = 12;

inline std::vector<TileShape> test_shapes() {
  using Kind = TileShape::Kind;
  using Side = TileShape::Side;
  std::vector<TileShape> shapes(256);
  shapes[kSolid] = {.kind = Kind::solid};
  shapes[kUp] = {.kind = Kind::slope, .heights = {0, 8}};
  shapes[kDown] = {.kind = Kind::slope, .heights = {8, 0}};
  shapes[kHill] = {.kind = Kind::profile, .heights = {0, 4, 6, 4, 0}};
  shapes[kWide] = {.kind = Kind::slope, .tiles = 3, .heights = {0, 8}};
  shapes[kCeiling] = {.kind = Kind::slope, .side = Side::ceiling, .heights = {0, 8}};
  shapes[kPlatform] = {.kind = Kind::solid, .one_way = true};
  shapes[kLow] = {.kind = Kind::slope, .heights = {4, 4}};
  shapes[kTall] = {.kind = Kind::slope, .tiles = 8, .heights = {0, 64}};
  shapes[kHanging] = {.kind = Kind::profile, .side = Side::ceiling, .tiles = 2, .heights = {20, 3, 7.3}};
  shapes[kTail] = {.kind = Kind::profile, .heights = {8, 0, 0}};
  shapes[kFlat] = {.kind = Kind::slope, .heights = {0, 0}};
  return shapes;
}

struct TestMap {
  int width, height;
  std::vector<TileNumber> cells;
  std::vector<Curve> curves = {};
  TestMap(int w, int h) : width(w), height(h), cells(static_cast<std::size_t>(w) * h) {}
  // Each row of text is a row of cells, and each digit a tile.
  explicit TestMap(const std::vector<std::string>& rows)
      : width(static_cast<int>(rows[0].size())), height(static_cast<int>(rows.size())) {
    for (const std::string& row : rows) {
      for (const char c : row) cells.push_back(static_cast<TileNumber>(c == '.' ? 0 : c - '0'));
    }
  }
  // Refers to the map, which must outlive it.
  TerrainSource source() const {
    TerrainSource source;
    source.width = width, source.height = height;
    source.cells = cells;
    source.shapes = test_shapes();
    source.curves = curves;
    return source;
  }
  Terrain compile() const { return Terrain(source()); }
};

}  // namespace talus
