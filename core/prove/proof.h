// Proof: what was tried on a level, and what was found.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "trial_runner.h"

namespace talus {

inline constexpr std::size_t kMaxFindings = 10'000;

// Shows that bodies move over the ground of a level as its geometry says: every place where a body can stand
// is walked, rolled, jumped and dropped over by the solver, and each step is judged by exact geometry.
struct Proof {
  SolverKind solver = SolverKind::exact;
  std::vector<ProveBody> bodies;  // that were tried
  std::size_t left_out = 0;       // kinds of bodies of the level that were not
  bool assumes_body = false;      // the level has no bodies, and a player was tried
  bool stands_still = false;      // players were tried, but the level's run_speed is 0
  ProveCounts counts;
  std::vector<Finding> findings;  // by row, column, kind, body and direction; at most kMaxFindings
  std::size_t more = 0;           // findings that are not listed
  std::size_t of_solver = 0;      // findings, listed or not, that are faults of the solver
  double share = 1;               // of the level that is proved, 0..1
};

// The certificate as a sentence without a full stop: "480 places, 120,000 steps of the solver exact, no
// finding".
std::string summary_of(const Proof& proof);

// Proves a level, block by block.
class ProofRun {
 public:
  // before: a run of a level that is much the same, which has ended; what it found in blocks that are the
  // same is taken over. Null: there is none. near: blocks near this cell are proved first. Neither changes
  // the proof.
  explicit ProofRun(std::shared_ptr<const ProveScene> scene, const ProofRun* before = nullptr,
                    Cell near = {});

  // Proves the blocks that are left. threads: at least 1; the result is the same for every number. progress:
  // called by this thread with the share that is done, 0..1; if it returns false, the work ends. Returns
  // whether all is done.
  bool run(int threads, const std::function<bool(double)>& progress = {});
  // Of the blocks that are done. May be called by another thread.
  Proof proof() const;

 private:
  void work(const std::function<bool(double)>& progress);

  std::shared_ptr<const ProveScene> scene_;
  std::vector<int> order_;             // the blocks that are left
  std::atomic<std::size_t> next_ = 0;  // index into it
  std::atomic<bool> stopped_ = false;
  mutable std::mutex mutex_;                       // guards the rest
  std::vector<std::optional<BlockProof>> blocks_;  // nothing: it is not done
  std::size_t done_ = 0;
  std::exception_ptr problem_;  // of a thread
};

// The proof of a level; nothing if `progress` stopped it. See ProofRun::run.
std::optional<Proof> prove(const ProveScene& scene, int threads,
                           const std::function<bool(double)>& progress = {});

}  // namespace talus
