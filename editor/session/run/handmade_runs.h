// HandmadeRuns: the runs of a session that hold something the user has made, which no file has yet: marks,
// and inputs that were set by hand. What is only played is as easily played again.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace talus {

class HandmadeRuns {
 public:
  // The branch with this id has marks now, or has none any more.
  void note_marks(int branch, bool has_any);
  void note_input(int branch);      // was set by hand in it
  void note_run_again(int branch);  // as far as it goes: what was kept of it before is old
  void note_saved(int branch) { forget(branch); }
  void note_gone(int branch) { forget(branch); }
  void clear();
  // By when they were worked on, the latest last; empty: all that is worth keeping is in files.
  std::vector<int> all() const;
  std::optional<int> latest() const;
  std::uint64_t revision() const { return revision_; }  // grows with each of these changes

 private:
  struct Run {
    int branch = 0;
    bool marks = false, input = false;
  };
  void forget(int branch);
  Run take(int branch);

  std::vector<Run> runs_;  // the latest last
  std::uint64_t revision_ = 0;
};

}  // namespace talus
