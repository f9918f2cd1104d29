// A player walks along each random walkway to its other end and back, and its proof has no finding.
// TALUS_WALKWAYS: the number of walkways, at least kWalkways.
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include <talus/sim/solver.h>
#include "prove/proof.h"
#include "random_walkways.h"
#include "tries.h"

namespace talus::walkway_property_test {

constexpr int kWalkways = 120;
constexpr int kShares = 8;  // tests, so that they run side by side
constexpr int kFirst = 8;   // steps, in which a player comes to stand

class WalkwayProperty : public testing::TestWithParam<int> {
 protected:
  template <class Check>
  void for_walkways(Check check) {
    const auto count = static_cast<std::uint64_t>(tries("TALUS_WALKWAYS", kWalkways));
    for (auto seed = static_cast<std::uint64_t>(GetParam()); seed < count; seed += kShares) {
      SCOPED_TRACE("walkway " + std::to_string(seed));
      Dice dice(seed);
      check(random_walkway(dice));
    }
  }
};

void walk_to_the_end(const Level& level, Solver& solver, State& state, int direction) {
  const double end = level.map.px_width(), margin = 4.0 * level.map.tile_size().width;
  const double speed = level.tuning.player.run_speed;
  Input input;
  input.left = direction < 0;
  input.right = direction > 0;
  const Body& body = state.bodies.front();
  for (int steps = 0; steps < 2 * end / speed + 60; ++steps) {
    const double before = body.box.x;
    solver.step(state, input, nullptr);
    ASSERT_TRUE(body.gait.grounded) << "leaves the floor at x " << before;
    if (direction > 0 ? body.box.right() > end - margin : body.box.x < margin) return;
    if (steps > 1) {
      ASSERT_GT((body.box.x - before) * direction, 0) << "stops at x " << before;
    }
  }
  FAIL() << "does not get there";
}

TEST_P(WalkwayProperty, PlayersWalkThereAndBack) {
  for_walkways([](const Level& level) {
    const auto scene = std::make_shared<const Scene>(compile_scene(level));
    const auto solver = make_solver(scene);
    State state = initial_state(*scene);
    for (int i = 0; i < kFirst; ++i) solver->step(state, {}, nullptr);
    walk_to_the_end(level, *solver, state, 1);
    walk_to_the_end(level, *solver, state, -1);
  });
}

TEST_P(WalkwayProperty, ProofsHaveNoFinding) {
  for_walkways([](const Level& level) {
    const Proof proof = *prove(ProveScene(level, {}), 1);
    for (const Finding& finding : proof.findings) ADD_FAILURE() << message_of(finding);
  });
}

INSTANTIATE_TEST_SUITE_P(, WalkwayProperty, testing::Range(0, kShares));

}  // namespace talus::walkway_property_test
