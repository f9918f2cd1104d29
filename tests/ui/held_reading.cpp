#include "held_reading.h"

#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <condition_variable>
#include <mutex>
#include <thread>

namespace talus {
namespace held_reading {

struct State {
  std::mutex mutex;
  std::condition_variable released;
  bool is_held = false;
  ino_t number = 0;  // of the file
  std::thread::id spared;
};

State& state() {
  static State* const state = new State;  // never freed, as files are read until the very end
  return *state;
}

void wait(int descriptor) {
  struct stat status = {};
  std::unique_lock lock(state().mutex);
  state().released.wait(lock, [&] {
    return !state().is_held || state().spared == std::this_thread::get_id() ||
           ::fstat(descriptor, &status) != 0 || status.st_ino != state().number;
  });
}

}  // namespace held_reading

HeldReading::HeldReading(const std::string& path) {
  struct stat status = {};
  ::stat(path.c_str(), &status);
  const std::lock_guard lock(held_reading::state().mutex);
  held_reading::state().is_held = true;
  held_reading::state().number = status.st_ino;
  held_reading::state().spared = std::this_thread::get_id();
}

HeldReading::~HeldReading() {
  const std::lock_guard lock(held_reading::state().mutex);
  held_reading::state().is_held = false;
  held_reading::state().released.notify_all();
}

}  // namespace talus

extern "C" ssize_t read(int descriptor, void* bytes, size_t count) {
  talus::held_reading::wait(descriptor);
  return ::syscall(SYS_read, descriptor, bytes, count);
}
