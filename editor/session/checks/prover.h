// Prover: a thread proves a level while the editor goes on with it.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <talus/level/level.h>
#include "prove/proof.h"

namespace talus {

class Prover {
 public:
  Prover();
  ~Prover();  // waits until the thread has given up
  Prover(const Prover&) = delete;
  Prover& operator=(const Prover&) = delete;

  // Proves a copy of the level, instead of what is being proved; near a cell first. Blocks that are as in the
  // last proof are taken over from it.
  void start(const Level& level, Cell near);
  void cancel();       // keeps what is found so far
  void note_change();  // the level has changed: what is found, or will be, is out of date
  void forget();       // another level is open
  // Takes what is found so far. After a change it proves the level again, unless it was cancelled. level: the
  // current one; null: it is not to be proved now. Returns an error in one sentence if there is no proof.
  std::optional<std::string> advance(const Level* level);

  const Proof* found() const { return proof_ ? &*proof_ : nullptr; }  // null: there is none
  bool is_stale() const { return is_stale_; }  // whether the level has changed since found() was begun
  bool running() const { return job_ != nullptr; }
  bool follows_edits() const { return follows_; }  // whether it proves the level again after a change
  double progress() const;                         // of what is being proved, 0..1; 1: nothing is

 private:
  struct Job;
  std::unique_ptr<Job> job_;
  std::unique_ptr<Job> given_up_;         // ends soon
  std::shared_ptr<const ProofRun> last_;  // the last one that was ended; null: there is none
  std::optional<Proof> proof_;
  double shown_ = 0;  // share of the job that proof_ holds
  bool is_stale_ = false;
  bool follows_ = false;
  Cell near_;
};

}  // namespace talus
