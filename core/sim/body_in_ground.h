// Bodies in the ground, as the solver of a scene sees them: as boxes, or as circles.
#pragma once

#include <optional>

#include <talus/collision/cast.h>
#include <talus/sim/scene.h>
#include <talus/sim/state.h>

namespace talus {

// px: the radius of the circle that a body of a scene is; 0: it is a box.
double circle_of(const Scene& scene, const Body& body);

// px: the way of a body out of the ground; nothing if it is not inside, or if none is found. budget: not
// null; the work is taken from it.
std::optional<Vec2> way_out_of(const Scene& scene, const Terrain& ground, const Body& body,
                               CastBudget* budget);

}  // namespace talus
