// FailingCalls makes system calls on files in a folder fail as on a full or broken disk, and logs their
// order. It replaces the C library's open, read, write, fsync, rename, mkdir, close and so on in the whole
// program that it is linked into, so that the tested code knows nothing of it.
#pragma once

#include <string>
#include <vector>

namespace talus {

class FailingCalls {
 public:
  // Counts from now on what any thread does with files in the folder. Only one object may exist at a time.
  explicit FailingCalls(const std::string& folder);
  ~FailingCalls();
  FailingCalls(const FailingCalls&) = delete;
  FailingCalls& operator=(const FailingCalls&) = delete;

  // Lets the call of this number, from 0, fail with this errno; with for_good, all later calls fail too.
  void fail_from(int number, int error, bool for_good);
  void heal();        // lets no call fail any more
  int count() const;  // calls so far
  // All calls so far: "open a.tmp", "write a.tmp", "fsync a.tmp", "rename a.tmp a", "close a". Names have no
  // folders, and the folder itself is written by its own name.
  std::vector<std::string> log() const;
  std::string failed() const;  // the first call that failed; empty: no call failed
};

}  // namespace talus
