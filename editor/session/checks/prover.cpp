// A thread for one level at a time.
#include "prover.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <utility>

#include <talus/level/ground.h>
#include "formats/last_catch.h"

namespace talus {

struct Prover::Job {
  // before: a job that was given up; this one waits for its end.
  Job(const Level& copied, std::unique_ptr<Job> before)
      : level(std::make_shared<const Level>(copied)), older(std::move(before)) {
    thread = std::thread([this] {
      older.reset();
      try {
        work();
      } catch (...) {
        problem = "The level could not be proved: " + caught_text() + ".";
      }
      done = true;
    });
  }
  ~Job() {
    wanted = false;
    thread.join();
  }
  void work();

  std::shared_ptr<const Level> level;
  std::unique_ptr<Job> older;
  bool is_stale = false;  // the level has changed since the start
  std::atomic<double> progress = 0;
  std::atomic<bool> wanted = true, done = false;
  std::optional<Proof> proof;  // written before `done`, like:
  std::string problem;         // a sentence; empty: no problem
  std::thread thread;
};

void Prover::Job::work() {
  if (!wanted) return;
  if (const auto too_much = ground_problem(*level)) {
    problem = "The level " + *too_much + ".";
    return;
  }
  const ProveScene scene(*level, {});
  // The window keeps a processor, if there are several.
  const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
  proof = prove(scene, threads, [this](double share) {
    progress = share;
    return wanted.load();
  });
}

Prover::Prover() = default;
Prover::~Prover() = default;

void Prover::start(const Level& level) {
  cancel();
  job_ = std::make_unique<Job>(level, std::move(given_up_));
}

// A job looks only now and then whether it is wanted, so nobody waits for it here.
void Prover::cancel() {
  if (!job_) return;
  job_->wanted = false;
  given_up_ = std::move(job_);
}

void Prover::note_change() {
  is_stale_ = proof_.has_value();
  if (job_) job_->is_stale = true;
}

void Prover::forget() {
  cancel();
  proof_.reset();
  is_stale_ = false;
}

std::optional<std::string> Prover::advance() {
  if (given_up_ && given_up_->done) given_up_.reset();
  if (!job_ || !job_->done) return std::nullopt;
  const std::unique_ptr<Job> job = std::move(job_);
  if (!job->problem.empty()) return job->problem;
  proof_ = std::move(job->proof);
  is_stale_ = job->is_stale;
  return std::nullopt;
}

double Prover::progress() const { return job_ ? job_->progress.load() : 1; }

}  // namespace talus
