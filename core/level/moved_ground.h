// Finds out whether another program moved the ground of a level within its map, as Tiled and LDtk do where
// they make a map larger or smaller at its left or top.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <talus/level/level.h>

namespace talus {

inline constexpr std::size_t kMaxGroundMarks = 80;

// A cell by which ground is found again.
struct GroundMark {
  Cell place;    // in the map
  MapCell cell;  // what it holds
  friend bool operator==(const GroundMark&, const GroundMark&) = default;
};

// Where the ground of a level is.
struct GroundPlace {
  // Of a map of Tiled, the column and row of the file at which the level begins; nothing for others.
  std::optional<Cell> origin = {};
  int width = 0;                       // cells, of the map
  int height = 0;                      // cells, the same
  int layer = 0;                       // the layer of the marks
  std::vector<GroundMark> marks = {};  // at most kMaxGroundMarks; none if no cell has a tile
};
GroundPlace ground_place(const Level& level);

// By how many cells the ground went right and down until it was as in `now`. {0, 0} if that is not clear.
// Takes time by the number of cells.
Cell ground_shift(const GroundPlace& before, const Level& now);

// How many columns and rows a map has more at its left and top, whose ground was shifted `by` so many cells:
// none where another program moved the cells of a map that kept its size.
Cell growth_at_corner(const GroundPlace& before, const TileMap& now, Cell by);

// The same level on a map of this size, with all that has a place shifted by whole cells. Cells go that have
// no place there; bodies, curves and objects stay, also beside the map. is_terrain_size must allow the size
// (asserted).
Level with_moved_ground(const Level& level, Cell by, int width, int height);

// "2 columns further left": where a map begins whose ground went right and down. by: not {0, 0}.
std::string words_for_shift(Cell by);

}  // namespace talus
