#include <talus/sim/solver.h>

#include "article_solver.h"
#include "bump_solver.h"
#include "exact_solver.h"

namespace talus {

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
