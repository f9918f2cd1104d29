#include "body_in_ground.h"

#include "../collision/ground_queries.h"
#include "meet/round_ground.h"

namespace talus {

double circle_of(const Scene& scene, const Body& body) {
  return scene.features.meets ? radius_of(body.kind, {body.box.w, body.box.h}) : 0;
}

std::optional<Vec2> way_out_of(const Scene& scene, const Terrain& ground, const Body& body,
                               CastBudget* budget) {
  const double radius = circle_of(scene, body);
  if (radius > 0) return RoundGround(ground).way_out({body.box, radius}, *budget);
  return way_out(ground, body.box, body.foot, budget);
}

}  // namespace talus
