// The solver of the article "Slopes in AABB collision systems" (A. Listopadov, 2026), to the last bit and
// with its defects: blocks snag at seams, the floor of a slope is rounded, and only the body's centre stands
// on it.
#pragma once

#include <optional>

#include "world_solver.h"

namespace talus {

class ArticleSolver final : public WorldSolver {
 public:
  explicit ArticleSolver(std::shared_ptr<const Scene> scene);

 private:
  void fall(Body& body, Placed& placed) override;
  void drag(Body& body, Placed& placed, const Input& input) override;
  std::optional<SlopeProbe> probe_slope(const Body& body, const Placed& placed, double speed);
  std::optional<SlopeProbe> settle_on_slope(Body& body, Placed& placed, double speed, ContactRecord* contact);

  std::vector<Collision> slope_hits_;
};

}  // namespace talus
