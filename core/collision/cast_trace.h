// What a cast looked at before it decided: for those who want to see why.
#pragma once

#include <vector>

#include <talus/collision/cast.h>

namespace talus {

// A side of the outline that faced the motion, in a cell that the cast looked at.
struct CastCandidate {
  Cell cell;
  Facing facing = Facing::up;
  Vec2 from, to;                                       // px, its ends; of a curve those of its stretch
  double t = std::numeric_limits<double>::infinity();  // when the box meets it; infinite: never
  bool is_first = false;                               // the cast's contact
};

struct CastTrace {
  std::vector<Cell> cells;                // looked at, in order
  std::vector<CastCandidate> candidates;  // in the order in which they were tested
  Contact<double> contact;                // the same as cast_box() gives
};

// As cast_box(), for whatever the terrain has; slower. Of a long way, or in a crowd of lines, only what comes
// first is told of; the contact is right all the same.
CastTrace trace_cast(const Terrain& terrain, const Cast<double>& cast);

}  // namespace talus
