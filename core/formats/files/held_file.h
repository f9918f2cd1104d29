// Locks on files, that tell other processes whether who made a file still runs, or keep them waiting until it
// is written: the system gives them back however a process ends.
#pragma once

#include <string>

namespace talus {

// Takes the lock of an open file that has this name, until the descriptor is closed. False with errno: with
// EWOULDBLOCK another one holds it, with ENOENT the file has lost its name, as one that nobody held; with
// others there are no locks here.
bool try_lock(int descriptor, const std::string& name);

// Removes a file whose lock nobody holds; false: it is held, or cannot be removed.
bool remove_if_unlocked(const std::string& name);

// One program at a time changes a file that several of them keep: while it lives, no other one of the same
// file does. Where there can be no lock, it does not wait.
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
