// Slopes as one more response of `World`: move() carries a body along the ground, and one check() finds
// whether it stands. The article's bodies and numbers, without its rounding, and with the true normals of
// slopes.
#pragma once

#include "world_solver.h"

namespace talus {

class BumpSolver final : public WorldSolver {
 public:
  explicit BumpSolver(std::shared_ptr<const Scene> scene);

  // Whether the body stands on something: one check, kGroundReach down. Returns false if there is no such
  // body.
  bool is_grounded(const State& state, int body);
  static constexpr double kGroundReach = 1.0 / 64;  // px

 private:
  void fall(Body& body, Placed& placed) override;
  void drag(Body& body, Placed& placed, const Input& input) override;
  Vec2 respond(const World& world, Collision& hit, Vec2 goal, World::Filter filter,
               std::vector<Collision>& next) const;
  // Changes a contact with a slope so that the body does not get below a one-way line.
  void keep_above_lines(const World& world, Collision& hit, Vec2 goal, World::Filter filter,
                        SlopeContact& contact) const;
  void note_surface(std::size_t i);  // of the hit with this index

  bool has_one_way_ = false;  // whether a slope of the scene stops what comes from one side alone
};

}  // namespace talus
