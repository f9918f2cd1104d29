// Proof: what was tried on a level, and what was found.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "trial_runner.h"

namespace talus {

inline constexpr std::size_t kMostFindings = 10'000;

// Shows that bodies move over the ground of a level as its geometry says: every place where a body can stand
// is walked, rolled, jumped and dropped over by the solver, and each step is judged by exact geometry.
struct Proof {
  SolverKind solver = SolverKind::exact;
  std::vector<ProveBody> bodies;  // that were tried
  std::size_t left_out = 0;       // kinds of bodies of the level that were not
  ProveCounts counts;
  std::vector<Finding> findings;  // by row, column, kind, body and direction; at most kMostFindings
  std::size_t more = 0;           // findings that are not listed
  std::size_t of_solver() const;  // how many of the listed ones are faults of the solver
};

// The certificate as a sentence without a full stop: "480 places, 120,000 steps of the solver exact, no
// finding".
std::string summary_of(const Proof& proof);

// blocks: of all blocks of the scene.
Proof join(const ProveScene& scene, std::span<const BlockProof> blocks);

// Proves all blocks. threads: at least 1; the result is the same for every number. progress: called by this
// thread with the share that is done, 0..1; if it returns false, the work ends, and there is no proof.
std::optional<Proof> prove(const ProveScene& scene, int threads,
                           const std::function<bool(double)>& progress = {});

}  // namespace talus
