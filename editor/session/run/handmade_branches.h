// HandmadeBranches: the branches of a session that the user has worked on and that no file has yet: branches
// with marks, or with inputs that were set by hand. A branch that was only played is easily played again.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace talus {

class HandmadeBranches {
 public:
  // The branch with this id now has marks, or no longer has any.
  void note_marks(int branch, bool has_any);
  void note_input(int branch);  // an input of it was set by hand
  void note_rerun(int branch);  // it was run again to its end: earlier saves of it are out of date
  void note_saved(int branch) { forget(branch); }
  void note_gone(int branch) { forget(branch); }
  void clear();
  // Sorted by the time of the last change, the latest last. Empty: everything worth keeping is in files.
  std::vector<int> all() const;
  std::optional<int> latest() const;
  std::uint64_t revision() const { return revision_; }  // grows with each of these changes

 private:
  struct Entry {
    int branch = 0;
    bool marks = false, input = false;
  };
  void forget(int branch);
  Entry take(int branch);

  std::vector<Entry> entries_;  // the latest last
  std::uint64_t revision_ = 0;
};

}  // namespace talus
