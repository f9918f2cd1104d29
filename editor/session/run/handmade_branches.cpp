// A short list: few branches are worked on by hand.
#include "handmade_branches.h"

#include <algorithm>

namespace talus {

HandmadeBranches::Entry HandmadeBranches::take(int branch) {
  ++revision_;
  const auto found =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.branch == branch; });
  if (found == entries_.end()) return {branch};
  const Entry entry = *found;
  entries_.erase(found);
  return entry;
}

void HandmadeBranches::note_marks(int branch, bool has_any) {
  Entry entry = take(branch);
  entry.marks = has_any;
  if (entry.marks || entry.input) entries_.push_back(entry);
}

void HandmadeBranches::note_input(int branch) {
  Entry entry = take(branch);
  entry.input = true;
  entries_.push_back(entry);
}

void HandmadeBranches::note_rerun(int branch) {
  if (std::any_of(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.branch == branch; }))
    ++revision_;
}

void HandmadeBranches::forget(int branch) { take(branch); }

void HandmadeBranches::clear() {
  ++revision_;
  entries_.clear();
}

std::vector<int> HandmadeBranches::all() const {
  std::vector<int> branches;
  for (const Entry& entry : entries_) branches.push_back(entry.branch);
  return branches;
}

std::optional<int> HandmadeBranches::latest() const {
  return entries_.empty() ? std::nullopt : std::optional(entries_.back().branch);
}

}  // namespace talus
