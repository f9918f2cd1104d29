// Cuts areas that are free of the grid into its cells.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include <talus/level/tile_map.h>
#include "../collision/tile_outlines.h"

namespace talus {

// The parts of areas in the cells of a map. Where a side leaves a cell, its parts have a common point on the
// side, so that no gap is between them, and they lie on one line. Where sides cross, that point is welded: up
// to 1/256 px off the side.
class ObjectCells {
 public:
  // A polygon inside of a cell; the fields as in TileShape.
  struct Part {
    std::vector<Vec2> points;
    std::vector<Segment> lines;
  };

  // The map's size counts, not its tiles.
  explicit ObjectCells(const TileMap& map);

  // Adds the inside of an outline, px; what is off the map is left out. Where it crosses itself, a place is
  // inside if a line from there to the outside crosses it an odd number of times. Returns whether it could:
  // it cannot if the outline has more than 1024 points, or if all outlines together cover too much.
  bool add(std::vector<Vec2> outline);

  // By cell, row by row: whether all of it is inside.
  const std::vector<bool>& full() const { return full_; }
  // By index of the cell: the polygons inside of it. Cells that are full have none.
  const std::map<std::size_t, std::vector<Part>>& parts() const { return parts_; }

 private:
  using Points = std::vector<Vec2>;  // from left to right
  struct Chain {
    Points upper, lower;
  };

  bool works(std::size_t steps);
  void add_column(const std::vector<OutlineLine>& lines, const std::vector<double>& cuts, int column);
  void add_chain(const Chain& chain, int column);
  void add_row(const Points& whole_upper, const Points& whole_lower, Cell cell);
  void add_part(const Points& upper, const Points& lower, double from, double to, Cell cell);
  Points with_borders(const Points& line);
  double cut_y(const OutlineLine& line, double x) const;
  const OutlineLine* line_through(Vec2 a, Vec2 b) const;

  int width_, height_;
  TileSize tile_;
  std::vector<bool> full_;
  std::map<std::size_t, std::vector<Part>> parts_;
  std::size_t work_ = 0;
  // Of the outline that is added.
  std::vector<double> crossings_;         // x where it crosses itself, sorted
  std::vector<const OutlineLine*> here_;  // its sides in the column
};

}  // namespace talus
