// What of the ground's outline catches bodies, to compare an outline before and after a fix.
#pragma once

#include <array>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "lint_tiles.h"

namespace talus {

// The walls, lips, notches, ceilings and pits of some areas of a level. The lint lists none of them by
// itself, as most are intended; but no fix may make one.
class GroundFaults {
 public:
  // areas: each from its first to its last cell, which are both on the map.
  GroundFaults(const Level& level, const LintTiles& tiles, std::span<const std::array<Cell, 2>> areas);

  // Whether there is a wall, a notch, a ceiling or a part of a pit where `before` has none, or a lip, a wall
  // of up to a quarter of a tile, where it has none or a higher wall. before: of the same areas.
  bool has_more_than(const GroundFaults& before) const;

 private:
  struct Interval {
    double from, to;
  };
  static std::vector<Interval> joined(std::vector<Interval> walls);
  bool is_worse(const Interval& wall, std::span<const Interval> before) const;
  void note_notch(const Piece<double>& floor);
  void look_at(const Level& level, const LintTiles& tiles, const std::array<Cell, 2>& area);

  double lip_;                                                     // px, height of the highest lip
  std::map<std::pair<int, double>, std::vector<Interval>> walls_;  // y, by the side that they face, and x
  // The feet of walls from which a floor rises: a body is stopped there by less than the whole wall.
  std::set<std::pair<double, double>> notches_;  // x and y
  std::map<int, std::set<double>> ceilings_;     // y, by the column of pixels
  std::vector<double> pits_;  // how much deeper each column of pixels is than the ground on both sides
};

}  // namespace talus
