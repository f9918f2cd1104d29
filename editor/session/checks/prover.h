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

  // Proves a copy of the level, instead of what is being proved. The last proof stays until this one is
  // there.
  void start(const Level& level);
  void cancel();       // keeps the last proof
  void note_change();  // the level has changed: what is found, or will be, is out of date
  void forget();       // another level is open
  // Takes the proof if it is there. Returns an error in one sentence if there is none.
  std::optional<std::string> advance();

  const Proof* found() const { return proof_ ? &*proof_ : nullptr; }  // null: there is none
  bool is_stale() const { return is_stale_; }  // whether the level has changed since found() was begun
  bool running() const { return job_ != nullptr; }
  double progress() const;  // of what is being proved, 0..1; 1: nothing is

 private:
  struct Job;
  std::unique_ptr<Job> job_;
  std::unique_ptr<Job> given_up_;  // ends soon
  std::optional<Proof> proof_;
  bool is_stale_ = false;
};

}  // namespace talus
