// A thread for one level at a time.
#include "prover.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <utility>

#include <talus/level/ground.h>
#include "formats/last_catch.h"

namespace talus {

namespace {

constexpr double kShownStep = 0.05;  // of the level; after so much more the findings are listed

}  // namespace

struct Prover::Job {
  // before: a job that was given up; this one waits for its end. ended: see ProofRun.
  Job(const Level& copied, Cell its_near, std::unique_ptr<Job> before, std::shared_ptr<const ProofRun> ended)
      : level(copied), near(its_near), older(std::move(before)), last(std::move(ended)) {
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

  const Level level;
  Cell near;
  std::unique_ptr<Job> older;
  std::shared_ptr<const ProofRun> last;
  bool is_stale = false;  // the level has changed since the start
  std::atomic<double> progress = 0;
  std::atomic<bool> wanted = true, begun = false, done = false;
  std::shared_ptr<ProofRun> run;  // written before `begun`
  std::string problem;            // a sentence; empty: no problem; written before `done`
  std::thread thread;
};

void Prover::Job::work() {
  if (!wanted) return;
  if (const auto too_much = ground_problem(level)) {
    problem = "The level " + *too_much + ".";
    return;
  }
  run =
      std::make_shared<ProofRun>(std::make_shared<const ProveScene>(level, ProveOptions()), last.get(), near);
  begun = true;
  // The window keeps a processor, if there are several.
  const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
  run->run(threads, [this](double share) {
    progress = share;
    return wanted.load();
  });
}

Prover::Prover() = default;
Prover::~Prover() = default;

void Prover::start(const Level& level, Cell near) {
  cancel();
  near_ = near;
  follows_ = true;
  shown_ = 0;
  job_ = std::make_unique<Job>(level, near, std::move(given_up_), last_);
}

// A job looks only now and then whether it is wanted, so nobody waits for it here.
void Prover::cancel() {
  follows_ = false;
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
  last_.reset();
  proof_.reset();
  is_stale_ = false;
}

std::optional<std::string> Prover::advance(const Level* level) {
  if (given_up_ && given_up_->done) given_up_.reset();
  if (job_ && job_->begun && job_->progress >= shown_ + kShownStep) {
    shown_ = job_->progress;
    proof_ = job_->run->proof();
    is_stale_ = job_->is_stale;
  }
  if (job_ && job_->done) {
    const std::unique_ptr<Job> job = std::move(job_);
    if (!job->problem.empty()) {
      follows_ = false;  // it would be said again and again
      return job->problem;
    }
    last_ = job->run;
    proof_ = job->run->proof();
    is_stale_ = job->is_stale;
  }
  if (!job_ && is_stale_ && follows_ && level != nullptr) start(*level, near_);
  return std::nullopt;
}

double Prover::progress() const { return job_ ? job_->progress.load() : 1; }

}  // namespace talus
