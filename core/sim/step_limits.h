// How far and how long one step of a solver may go.
#pragma once

#include <cstddef>
#include <cstdint>

#include <talus/sim/solver.h>

namespace talus {

// What all bodies together, and one alone, may look at in a step: cells, lines and boxes, in units of some
// ns. So no step takes long, whatever the level; ordinary ones come nowhere near. A body that has used up its
// part stops at a place that it can be at, and the record says so.
inline constexpr std::int64_t kMostStepWork = 1 << 24;
inline constexpr std::int64_t kMostBodyWork = 1 << 20;
inline constexpr std::int64_t kLeastBodyWork = 1 << 10;
std::int64_t max_work_per_body(std::size_t bodies);

// A goal within these limits. What is within them is left as it is, to the last bit.
Vec2 within_limits(Vec2 from, Vec2 goal);

}  // namespace talus
