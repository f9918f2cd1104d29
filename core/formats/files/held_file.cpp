// Uses flock, whose locks belong to an open file and not to a process: so two threads exclude one another,
// too.
#include "held_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace talus {

bool has_name(int descriptor, const std::string& name) {
  struct stat held = {}, named = {};
  return ::fstat(descriptor, &held) == 0 && ::lstat(name.c_str(), &named) == 0 &&
         held.st_dev == named.st_dev && held.st_ino == named.st_ino;
}

bool try_lock(int descriptor, const std::string& name) {
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) return false;
  if (has_name(descriptor, name)) return true;
  errno = ENOENT;
  return false;
}

bool remove_if_unlocked(const std::string& name) {
  const int descriptor = ::open(name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool removed = try_lock(descriptor, name) && ::unlink(name.c_str()) == 0;
  ::close(descriptor);
  return removed;
}

FileLock::FileLock(const std::string& file)
    : lock_(::open((file + ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  if (lock_ >= 0) (void)::flock(lock_, LOCK_EX);
}

FileLock::~FileLock() {
  if (lock_ >= 0) ::close(lock_);
}

}  // namespace talus
