// Locks on files. They tell other processes whether the owner of a file still runs, or make them wait until
// the file is written. The system releases a lock however a process ends.
#pragma once

#include <string>

namespace talus {

// Whether an open file still has this name, in the same folder. False, too, if that cannot be found out.
bool has_name(int descriptor, const std::string& name);

// Locks an open file that has this name, until the descriptor is closed. Returns false with errno otherwise:
// EWOULDBLOCK if somebody else holds the lock, ENOENT if the file no longer has the name, other numbers if
// locks are not supported here.
bool try_lock(int descriptor, const std::string& name);

// Removes a file that nobody has locked. Returns false if it is locked or cannot be removed.
bool remove_if_unlocked(const std::string& name);

// While a FileLock lives, no other program can make one of the same file: they change a shared file one at a
// time. Without support for locks it does not wait.
class FileLock {
 public:
  explicit FileLock(const std::string& file);  // the lock is on "FILE.lock" beside the file
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  int lock_;  // descriptor
};

}  // namespace talus
