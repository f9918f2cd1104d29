#include "solver.h"

#include <algorithm>

#include "article_solver.h"
#include "bump_solver.h"
#include "exact_solver.h"
#include "lerp.h"

namespace talus {

std::int64_t max_work_per_body(std::size_t bodies) {
  const auto share = kMostStepWork / std::max<std::int64_t>(static_cast<std::int64_t>(bodies), 1);
  return std::clamp(share, kLeastBodyWork, kMostBodyWork);
}

Vec2 within_limits(Vec2 from, Vec2 goal) {
  const auto limit = [](double at, double to) {
    const double reachable = std::clamp(to, at - kMaxBodySpeed, at + kMaxBodySpeed);
    return std::clamp(reachable, -kMaxBodyDistance, kMaxBodyDistance);
  };
  return {limit(from.x, goal.x), limit(from.y, goal.y)};
}

Vec2 drag_goal(const SharedTuning& t, const Body& body, const Input& input) {
  return {lerp(body.box.x, input.mouse.x - t.drag_offset, t.drag_blend),
          lerp(body.box.y, input.mouse.y - t.drag_offset, t.drag_blend)};
}

std::unique_ptr<Solver> make_solver(std::shared_ptr<const Scene> scene) {
  switch (scene->tuning.solver) {
    case SolverKind::article:
      return std::make_unique<ArticleSolver>(std::move(scene));
    case SolverKind::bump:
      return std::make_unique<BumpSolver>(std::move(scene));
    case SolverKind::exact:
      return make_exact_solver(std::move(scene));
  }
  return nullptr;
}

State step(const Scene& scene, const State& state, const Input& input, StepRecord* record) {
  // The solver lives no longer than this call, so it may look at the caller's scene without owning it.
  const std::shared_ptr<const Scene> borrowed(std::shared_ptr<const Scene>(), &scene);
  State next = state;
  make_solver(borrowed)->step(next, input, record);
  return next;
}

}  // namespace talus
