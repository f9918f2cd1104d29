// A short list: few runs are worked on by hand.
#include "handmade_runs.h"

#include <algorithm>

namespace talus {

HandmadeRuns::Run HandmadeRuns::take(int branch) {
  ++revision_;
  const auto found =
      std::find_if(runs_.begin(), runs_.end(), [&](const Run& r) { return r.branch == branch; });
  if (found == runs_.end()) return {branch};
  const Run run = *found;
  runs_.erase(found);
  return run;
}

void HandmadeRuns::note_marks(int branch, bool has_any) {
  Run run = take(branch);
  run.marks = has_any;
  if (run.marks || run.input) runs_.push_back(run);
}

void HandmadeRuns::note_input(int branch) {
  Run run = take(branch);
  run.input = true;
  runs_.push_back(run);
}

void HandmadeRuns::note_run_again(int branch) {
  if (std::any_of(runs_.begin(), runs_.end(), [&](const Run& r) { return r.branch == branch; })) ++revision_;
}

void HandmadeRuns::forget(int branch) { take(branch); }

void HandmadeRuns::clear() {
  ++revision_;
  runs_.clear();
}

std::vector<int> HandmadeRuns::all() const {
  std::vector<int> branches;
  for (const Run& run : runs_) branches.push_back(run.branch);
  return branches;
}

std::optional<int> HandmadeRuns::latest() const {
  return runs_.empty() ? std::nullopt : std::optional(runs_.back().branch);
}

}  // namespace talus
