#include "proof.h"

#include <algorithm>
#include <thread>
#include <tuple>
#include <utility>

#include "level/with_commas.h"

namespace talus {
namespace {

// Findings of one kind in one cell, which two blocks may have found.
auto key_of(const Finding& finding) {
  const Trial& trial = finding.trial;
  return std::make_tuple(finding.cell.y, finding.cell.x, finding.kind, trial.body.kind, trial.body.foot,
                         trial.body.box.w, trial.body.box.h, trial.direction);
}

}  // namespace

std::string summary_of(const Proof& proof) {
  if (proof.counts.steps == 0) return "no place where a body can stand, so nothing was tried";
  const auto count = [](std::int64_t number) { return with_commas(static_cast<std::size_t>(number)); };
  std::string text = count(proof.counts.places) + (proof.counts.places == 1 ? " place, " : " places, ") +
                     count(proof.counts.steps) + " steps of the solver " +
                     std::string(solver_name(proof.solver)) + ", ";
  if (proof.stands_still) text += "but no walk of a player, as run_speed is 0, ";
  if (proof.findings.empty()) return text + "no finding";
  const std::size_t all = proof.findings.size() + proof.more;
  text += with_commas(all) + (all == 1 ? " finding: " : " findings: ") + with_commas(all - proof.of_solver) +
          " of the level, " + with_commas(proof.of_solver) + " of the solver";
  return text;
}

ProofRun::ProofRun(std::shared_ptr<const ProveScene> scene, const ProofRun* before, Cell near)
    : scene_(std::move(scene)), blocks_(static_cast<std::size_t>(scene_->blocks())) {
  for (const int block : scene_->blocks_around(near)) {
    const auto at = static_cast<std::size_t>(block);
    const bool is_known = before != nullptr && at < before->blocks_.size() && before->blocks_[at] &&
                          scene_->is_same_in(*before->scene_, block);
    if (is_known) {
      blocks_[at] = before->blocks_[at];
      ++done_;
    } else {
      order_.push_back(block);
    }
  }
}

bool ProofRun::run(int threads, const std::function<bool(double)>& progress) {
  {
    std::vector<std::jthread> others;
    for (int i = 1; i < threads; ++i) others.emplace_back([this] { work({}); });
    work(progress);
  }
  if (problem_) std::rethrow_exception(problem_);
  return done_ == blocks_.size();
}

// An exception of any thread ends all of them.
void ProofRun::work(const std::function<bool(double)>& progress) try {
  TrialRunner runner(*scene_);
  for (std::size_t i = next_++; i < order_.size() && !stopped_; i = next_++) {
    const int block = order_[i];
    if (progress && !progress(static_cast<double>(i) / static_cast<double>(order_.size()))) stopped_ = true;
    if (stopped_) return;
    BlockProof proof = runner.prove(block);
    const std::scoped_lock lock(mutex_);
    blocks_[static_cast<std::size_t>(block)] = std::move(proof);
    ++done_;
  }
} catch (...) {
  stopped_ = true;
  const std::scoped_lock lock(mutex_);
  if (!problem_) problem_ = std::current_exception();
}

Proof ProofRun::proof() const {
  Proof proof;
  proof.solver = scene_->solver();
  proof.bodies = scene_->bodies();
  proof.left_out = scene_->left_out();
  proof.assumes_body = scene_->assumes_body();
  proof.stands_still = scene_->speeds().front().scene->tuning.player.run_speed == 0 &&
                       std::any_of(proof.bodies.begin(), proof.bodies.end(),
                                   [](const ProveBody& body) { return traits_of(body.kind).takes_keys; });
  {
    const std::scoped_lock lock(mutex_);
    proof.share = static_cast<double>(done_) / static_cast<double>(blocks_.size());
    for (const auto& block : blocks_) {
      if (!block) continue;
      proof.counts.add(block->counts);
      proof.findings.insert(proof.findings.end(), block->findings.begin(), block->findings.end());
    }
  }
  std::stable_sort(proof.findings.begin(), proof.findings.end(),
                   [](const Finding& a, const Finding& b) { return key_of(a) < key_of(b); });
  std::vector<Finding> merged;
  for (Finding& finding : proof.findings) {
    if (!merged.empty() && key_of(merged.back()) == key_of(finding)) {
      add_alike(merged.back(), finding);
    } else {
      merged.push_back(std::move(finding));
    }
  }
  proof.of_solver = static_cast<std::size_t>(std::count_if(
      merged.begin(), merged.end(), [](const Finding& finding) { return !info_of(finding.kind).of_level; }));
  proof.more = merged.size() - std::min(merged.size(), kMaxFindings);
  merged.resize(merged.size() - proof.more);
  proof.findings = std::move(merged);
  return proof;
}

std::optional<Proof> prove(const ProveScene& scene, int threads,
                           const std::function<bool(double)>& progress) {
  ProofRun run(std::shared_ptr<const ProveScene>(std::shared_ptr<const void>(), &scene));  // does not own it
  return run.run(threads, progress) ? std::optional(run.proof()) : std::nullopt;
}

}  // namespace talus
