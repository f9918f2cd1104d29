#include "proof.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <tuple>

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

std::size_t Proof::of_solver() const {
  return static_cast<std::size_t>(std::count_if(findings.begin(), findings.end(), [](const Finding& finding) {
    return !info_of(finding.kind).of_level;
  }));
}

std::string summary_of(const Proof& proof) {
  const auto count = [](std::int64_t number) { return with_commas(static_cast<std::size_t>(number)); };
  std::string text = count(proof.counts.places) + " places, " + count(proof.counts.steps) +
                     " steps of the solver " + std::string(solver_name(proof.solver)) + ", ";
  if (proof.findings.empty()) return text + "no finding";
  const std::size_t all = proof.findings.size() + proof.more, of_solver = proof.of_solver();
  text += with_commas(all) + (all == 1 ? " finding" : " findings");
  if (proof.more == 0)
    text += ": " + with_commas(proof.findings.size() - of_solver) + " of the level, " +
            with_commas(of_solver) + " of the solver";
  return text;
}

Proof join(const ProveScene& scene, std::span<const BlockProof> blocks) {
  Proof proof;
  proof.solver = scene.solver();
  proof.bodies = scene.bodies();
  proof.left_out = scene.left_out();
  for (const BlockProof& block : blocks) {
    proof.counts.add(block.counts);
    proof.findings.insert(proof.findings.end(), block.findings.begin(), block.findings.end());
  }
  std::stable_sort(proof.findings.begin(), proof.findings.end(),
                   [](const Finding& a, const Finding& b) { return key_of(a) < key_of(b); });
  std::vector<Finding> merged;
  for (Finding& finding : proof.findings) {
    if (!merged.empty() && key_of(merged.back()) == key_of(finding)) {
      merged.back().count += finding.count;
    } else if (merged.size() < kMostFindings) {
      merged.push_back(std::move(finding));
    } else {
      ++proof.more;
    }
  }
  proof.findings = std::move(merged);
  return proof;
}

std::optional<Proof> prove(const ProveScene& scene, int threads,
                           const std::function<bool(double)>& progress) {
  std::vector<BlockProof> blocks(static_cast<std::size_t>(scene.blocks()));
  std::atomic<int> next = 0;
  std::atomic<bool> stopped = false;
  const auto work = [&](bool is_first) {
    TrialRunner runner(scene);
    for (int block = next++; block < scene.blocks() && !stopped; block = next++) {
      if (is_first && progress && !progress(static_cast<double>(block) / scene.blocks())) stopped = true;
      if (!stopped) blocks[static_cast<std::size_t>(block)] = runner.prove(block);
    }
  };
  {
    std::vector<std::jthread> others;
    for (int i = 1; i < threads; ++i) others.emplace_back(work, false);
    work(true);
  }
  if (stopped) return std::nullopt;
  return join(scene, blocks);
}

}  // namespace talus
