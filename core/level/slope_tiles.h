// "Tiles along a slope", the wish at the end of the article: finds the tiles that follow a line between two
// points.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include <talus/level/level.h>

namespace talus {

// What to put into the level, in this order.
struct SlopeTiles {
  struct Drawn {  // a blank tile that gets an image and a shape
    TileNumber tile = 0;
    TileImage image{};
    TileShape shape;
    friend bool operator==(const Drawn&, const Drawn&) = default;
  };
  struct Placed {  // a cell of the map and the tile to put there
    Cell cell;
    TileNumber tile = 0;
    friend bool operator==(const Placed&, const Placed&) = default;
  };
  std::vector<Drawn> drawn;
  std::vector<Placed> placed;  // by column, each from top to bottom
};

// Old ground that is higher above a slope than so many rows is not cut off: it may be a whole mountain.
inline constexpr int kMaxCut = 8;

struct SlopeTilesOptions {
  // The tiles to choose from: floors and solid tiles, as shape_of_tile says. A slope of several cells brings
  // the tiles beside and above it on the sheet. Empty: blank tiles are drawn.
  std::span<const TileNumber> set = {};
  // The tile under each column of the slope; nothing: no tile is put there, unless the ground is filled.
  std::optional<TileNumber> below = {};
  // Whether the ground follows the slope. It is filled below it: each column down to the next full tile, or,
  // if it has none, down to the row of the slope's lower end. Without `below`, a full tile is drawn for it.
  // It is cut off above it, up to kMaxCut rows; what is deeper inside of old ground is left out. Of old
  // slopes of several cells, what is left is kept.
  bool fills = false;
  // px, by how much the tiles of a set may leave the line; nothing: a tile's height.
  std::optional<double> most_off = {};
  // 0..15, the colours of drawn tiles: of the topmost pixels of each column, downwards, and of those below.
  // Colour 0 would be a hole: the ground's is taken.
  std::vector<std::uint8_t> edge_colors = {5};
  std::uint8_t ground_color = 15;
};

// The heights of drawn tiles are rounded to this, as a terrain's are.
inline constexpr double kSlopeTileGrain = 1.0 / 256;  // px

// Returns the tiles whose floor is the line between two points on the map, in px, in any order. Their x is
// rounded to whole px, their y to kSlopeTileGrain. Left and right of the points, as far as the outermost
// tiles reach, the floor is that of the map where it ends at the point, and level otherwise. Drawn tiles are
// those of the sheet that have the same shape and the same opaque pixels, if there are such.
//
// At every column of pixels, drawn tiles are within half of kSlopeTileGrain of the line. With a set, each
// tile begins at the height at which the one before it ends, and the tile that stays nearest to the line is
// taken. The error is one sentence: the line is vertical or too steep, leaves the map, the blank tiles run
// out, or the tiles of the set would leave the line by more than a tile.
tl::expected<SlopeTiles, std::string> slope_tiles(const Level& level, Vec2 a, Vec2 b,
                                                  const SlopeTilesOptions& options = {});

}  // namespace talus
