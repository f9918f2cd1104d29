// FloorLine: the floor that goes on, without an edge, from the place where a body stands to both of its
// sides. It ends where it goes into other ground.
#pragma once

#include <optional>
#include <vector>

#include "raw_ground.h"

namespace talus {

class FloorLine {
 public:
  // From (x, y) to both sides, as far as x0 and x1. steepest: the largest |dy/dx| of a floor. slack: ends of
  // floors that are so near to one another count as one.
  FloorLine(const RawGround& ground, Fine x, Fine y, Fine x0, Fine x1, double steepest, Fine slack);

  // Whether there is no floor at the place.
  bool is_empty() const { return stretches_.empty(); }
  // Whether no point of the part's top, between two x, is above the line. Beyond its ends there is no line.
  bool covers(const RawPart& part, Fine x0, Fine x1) const;
  // Whether it goes from one x to another.
  bool reaches(Fine x0, Fine x1) const {
    return !is_empty() && end(-1) <= std::min(x0, x1) && end(1) >= std::max(x0, x1);
  }
  // The x of its left (direction < 0) or right end; there must be a floor.
  Fine end(int direction) const { return direction < 0 ? stretches_.front().x0 : stretches_.back().x1; }
  // Its y at an x, which it must reach.
  Fine at(Fine x) const;
  // The y of its left (direction < 0) or right end; if there is no floor, `y`.
  Fine at_end(int direction, Fine y) const { return is_empty() ? y : at(end(direction)); }

 private:
  struct Stretch {
    Fine x0, x1;
    RawLine top;  // goes on beyond the two x
  };
  void follow(const RawGround& ground, Fine x, Fine y, Fine until, double steepest);
  Fine end_of_way(const RawGround& ground, const RawLine& top, Fine from, Fine to) const;
  std::optional<Fine> stop_at(const RawPart& part, const RawLine& top, Fine from, Fine to) const;

  std::vector<Stretch> stretches_;  // from left to right; empty: there is no floor at the place
  Fine slack_;
};

}  // namespace talus
