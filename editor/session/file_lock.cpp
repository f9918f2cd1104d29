// By flock(), which ends with the process.
#include "file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace talus {

FileLock::FileLock(const std::string& file)
    : lock_(::open((file + ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  if (lock_ >= 0) (void)::flock(lock_, LOCK_EX);
}

FileLock::~FileLock() {
  if (lock_ >= 0) ::close(lock_);
}

}  // namespace talus
