// Cuts areas that are free of the grid into its cells.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include <talus/level/tile_map.h>

namespace talus {

// The parts of areas in the cells of a map. All points are welded. Where a side leaves a cell, its parts have
// a common point, at most 1/256 px off the side, so no gap is between them.
class ObjectCells {
 public:
  // The map's size counts, not its tiles.
  explicit ObjectCells(const TileMap& map);

  // Adds the inside of an outline, px; what is off the map is left out. Where it crosses itself, a place is
  // inside if a line from there to the outside crosses it an odd number of times. Returns whether it could:
  // it cannot if the outline has more than 1024 points, or if all outlines together cover too much.
  bool add(std::vector<Vec2> outline);

  // By cell, row by row: whether all of it is inside.
  const std::vector<bool>& full() const { return full_; }
  // By index of the cell: the polygons inside of it, px from its corner. Cells that are full have none.
  const std::map<std::size_t, std::vector<std::vector<Vec2>>>& parts() const { return parts_; }

 private:
  struct Line {
    Vec2 from, to;  // from.x < to.x
  };
  using Points = std::vector<Vec2>;  // from left to right
  struct Chain {
    Points upper, lower;
  };

  bool works(std::size_t steps);
  void add_column(const std::vector<Line>& lines, const std::vector<double>& cuts, int column);
  void add_chain(const Chain& chain, int column);
  void add_row(const Points& whole_upper, const Points& whole_lower, Cell cell);
  void add_part(const Points& upper, const Points& lower, double from, double to, Cell cell);
  Points with_borders(const Points& line);

  int width_, height_;
  TileSize tile_;
  std::vector<bool> full_;
  std::map<std::size_t, std::vector<std::vector<Vec2>>> parts_;
  std::size_t work_ = 0;
};

}  // namespace talus
