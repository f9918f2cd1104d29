// FileLock: one program at a time changes a file that several of them keep.
#pragma once

#include <string>

namespace talus {

// While it lives, no other one of the same file does; where there can be no lock, it does not wait.
class FileLock {
 public:
  explicit FileLock(const std::string& file);  // the lock is beside it, "FILE.lock"
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  int lock_;  // descriptor
};

}  // namespace talus
