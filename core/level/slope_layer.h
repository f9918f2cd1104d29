// SlopeLayer: the cells that tiles along a slope change, and the ground above and below them.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "slope_tiles.h"

namespace talus {

// Collects what to place. A cell keeps the first tile that it is given.
class SlopeLayer {
 public:
  explicit SlopeLayer(const Level& level) : level_(level), map_(level.map) {}

  void place(Cell cell, TileNumber tile) { floor_.try_emplace({cell.x, cell.y}, tile); }
  // A cell with a part of the floor in it. The tile SlopeTilesOptions::below goes under it.
  void own(Cell cell) { owners_.push_back(cell); }

  // The row of the lowest cell with a part of the floor in it.
  int lowest_row() const;
  bool is_empty() const { return floor_.empty(); }  // whether no part of the floor is left

  // Cuts off the old ground above the slope. Where that is higher than kMaxCut rows, or reaches up to the
  // map's upper edge, the slope is inside of the ground, and the column stays as it was.
  void cut();
  // Puts a tile under each cell of the floor, and further down if the ground is filled, but not below `last`
  // in a column without a full tile.
  void fill(TileNumber below, bool fills, int last);
  // The old slopes of several cells of which a part is replaced: what is left of them as slopes of one cell
  // each. Call it when all is placed.
  struct Rest {
    Cell cell;        // in which it lies
    TileShape shape;  // of this column alone
  };
  std::vector<Rest> rests() const;

  // Everything that is placed; an error if some of it is not on the map.
  tl::expected<std::vector<SlopeTiles::Placed>, std::string> placed() const;

 private:
  using Tiles = std::map<std::pair<int, int>, TileNumber>;  // by column and row

  void leave_out(int column);
  int end_of_fill(Cell cell, int last) const;
  bool has_new_floor_in(int column) const;
  bool replaces(Cell cell, const TileShape& slope) const;

  const Level& level_;
  const TileMap& map_;
  Tiles floor_;  // with what is cut off above it
  Tiles below_;
  std::vector<Cell> owners_;
};

}  // namespace talus
