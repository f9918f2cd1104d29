// The auto-tile set of a level: the tiles for the parts of painted ground.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include <talus/collision/shape.h>

namespace talus {

// A side faces air. A slope up rises from left to right. A slope of two tiles, such as the article's 16x8 px
// slopes, has a left and a right half.
enum class GroundPart : std::uint8_t {
  inside,
  top,
  left,
  right,
  bottom,
  top_left,
  top_right,
  bottom_left,
  bottom_right,
  slope_up,
  slope_down,
  slope_up_left,
  slope_up_right,
  slope_down_left,
  slope_down_right
};
inline constexpr int kGroundPartCount = 15;  // of GroundPart

// The tiles of one kind of ground.
struct AutoTiles {
  // By GroundPart. 0: no tile, as tile 0 is air.
  std::array<TileNumber, kGroundPartCount> tiles{};

  // The number of the part's tile; 0: it has none.
  TileNumber of(GroundPart part) const { return tiles[static_cast<std::size_t>(part)]; }
  // The same, to be changed.
  TileNumber& of(GroundPart part) { return tiles[static_cast<std::size_t>(part)]; }
  // Whether cells with this tile are ground of the set.
  bool has(TileNumber tile) const {
    return tile != 0 && std::find(tiles.begin(), tiles.end(), tile) != tiles.end();
  }
  // Whether no part has a tile.
  bool empty() const { return *this == AutoTiles(); }
  friend bool operator==(const AutoTiles&, const AutoTiles&) = default;
};

// One row for each part.
struct GroundPartInfo {
  std::string_view key;    // in files and names of widgets: "slope_up_left"
  std::string_view label;  // for people: "slope up, left half"
};
// By GroundPart.
inline constexpr std::array<GroundPartInfo, kGroundPartCount> kGroundParts = {{
    {"inside", "inside"},
    {"top", "top"},
    {"left", "left side"},
    {"right", "right side"},
    {"bottom", "bottom"},
    {"top_left", "top left corner"},
    {"top_right", "top right corner"},
    {"bottom_left", "bottom left corner"},
    {"bottom_right", "bottom right corner"},
    {"slope_up", "slope up, one tile"},
    {"slope_down", "slope down, one tile"},
    {"slope_up_left", "slope up, left half"},
    {"slope_up_right", "slope up, right half"},
    {"slope_down_left", "slope down, left half"},
    {"slope_down_right", "slope down, right half"},
}};

}  // namespace talus
