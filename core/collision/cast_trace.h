// CastTrace: what a cast tested before it decided. The overlays draw it.
#pragma once

#include <vector>

#include <talus/collision/cast.h>

namespace talus {

// A side of the outline that faced the motion, in a cell that the cast tested.
struct CastCandidate {
  Cell cell;
  Facing facing = Facing::up;
  Vec2 from, to;                                       // px, its ends; for a curve, the ends of the stretch
  double t = std::numeric_limits<double>::infinity();  // when the box meets it; infinite: never
  bool is_first = false;                               // whether it is the contact of the cast
};

struct CastTrace {
  std::vector<Cell> cells;                // the tested cells, in order
  std::vector<CastCandidate> candidates;  // in the order of the tests
  Contact<double> contact;                // the same as cast_box() returns
};

// Like cast_box(), for any terrain, but slower. For a long motion, or in a crowd of lines, the trace keeps
// only the first entries; the contact is right nevertheless.
CastTrace trace_cast(const Terrain& terrain, const Cast<double>& cast);

}  // namespace talus
