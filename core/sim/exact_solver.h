// The exact solver: sweeps bodies against the ground's outline and puts them on what they hit. They slide,
// bounce or walk along it.
#pragma once

#include <memory>

#include <talus/sim/solver.h>

namespace talus {

// The scene must have been compiled for the exact solver (asserted).
std::unique_ptr<Solver> make_exact_solver(std::shared_ptr<const Scene> scene);

}  // namespace talus
