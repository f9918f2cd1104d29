// The exact solver: bodies are swept against the ground's outline, put on what they hit, and slide, bounce or
// walk along it.
#pragma once

#include <memory>

#include <talus/sim/solver.h>

namespace talus {

// The scene must have been compiled for the exact solver (asserted).
std::unique_ptr<Solver> make_exact_solver(std::shared_ptr<const Scene> scene);

}  // namespace talus
