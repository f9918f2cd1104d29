// FailingCalls: makes the system's calls on files below a folder fail as a full or broken disk does, and
// writes down their order. It stands in for the C library's open, read, write, fsync, rename, mkdir, close
// and so on in the whole program that it is linked into, so that nothing of what is tested knows about it.
#pragma once

#include <string>
#include <vector>

namespace talus {

class FailingCalls {
 public:
  // From now on, what any thread does with files below the folder counts. One at a time.
  explicit FailingCalls(const std::string& folder);
  ~FailingCalls();
  FailingCalls(const FailingCalls&) = delete;
  FailingCalls& operator=(const FailingCalls&) = delete;

  // The call of this number, from 0, fails with this errno; for_good: and all that come after it.
  void fail_from(int number, int error, bool for_good);
  void heal();        // none fails any more
  int count() const;  // calls until now
  // All calls until now: "open a.tmp", "write a.tmp", "fsync a.tmp", "rename a.tmp a", "close a". Names are
  // without folders; that of the folder itself is its own.
  std::vector<std::string> log() const;
  std::string failed() const;  // the first call that failed; empty: none
};

}  // namespace talus
