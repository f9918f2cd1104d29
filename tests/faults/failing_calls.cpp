// Definitions in the program come before those of the C library, even for calls by the standard library. The
// real work is done by system calls.
#include "failing_calls.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <mutex>
#include <string_view>

namespace talus {
namespace failing_calls {

constexpr int kMaxDescriptors = 4096;

struct State {
  std::mutex mutex;
  std::string folder;
  std::array<std::string, kMaxDescriptors> names;  // names of open files in the folder; empty: another file
  std::vector<std::string> log;
  int fails_at = -1;
  int error = 0;
  bool for_good = false;
  std::string failed;
};

State& state() {
  static State* const state = new State;  // never freed, as files are closed until the very end
  return *state;
}
inline std::atomic<bool> watching = false;

std::string name_of(std::string_view path) { return std::string(path.substr(path.rfind('/') + 1)); }

bool is_watched(const char* path) {
  return watching && path != nullptr && std::string_view(path).starts_with(state().folder);
}

// Counts a call. Returns true if the call must fail; errno then says why.
bool fails(std::string call) {
  State& w = state();
  const int number = static_cast<int>(w.log.size());
  const bool failing = w.fails_at >= 0 && (w.for_good ? number >= w.fails_at : number == w.fails_at);
  if (failing && w.failed.empty()) w.failed = call;
  w.log.push_back(std::move(call));
  if (failing) errno = w.error;
  return failing;
}

bool fails_at_path(const char* call, const char* path) {
  if (!is_watched(path)) return false;
  const std::lock_guard lock(state().mutex);
  return fails(call + std::string(" ") + name_of(path));
}

bool fails_at_file(const char* call, int descriptor) {
  if (!watching || descriptor < 0 || descriptor >= kMaxDescriptors) return false;
  const std::lock_guard lock(state().mutex);
  const std::string& name = state().names[static_cast<std::size_t>(descriptor)];
  return !name.empty() && fails(call + std::string(" ") + name);
}

bool is_watched_file(int descriptor) {
  if (!watching || descriptor < 0 || descriptor >= kMaxDescriptors) return false;
  const std::lock_guard lock(state().mutex);
  return !state().names[static_cast<std::size_t>(descriptor)].empty();
}

int opened(const char* path, int flags, mode_t mode) {
  if (fails_at_path("open", path)) return -1;
  const auto descriptor = static_cast<int>(::syscall(SYS_openat, AT_FDCWD, path, flags, mode));
  if (descriptor >= 0 && descriptor < kMaxDescriptors && is_watched(path)) {
    const std::lock_guard lock(state().mutex);
    state().names[static_cast<std::size_t>(descriptor)] = name_of(path);
  }
  return descriptor;
}

}  // namespace failing_calls

FailingCalls::FailingCalls(const std::string& folder) {
  failing_calls::State& w = failing_calls::state();
  const std::lock_guard lock(w.mutex);
  w.folder = folder;
  w.names.fill("");
  w.log.clear();
  w.fails_at = -1;
  w.failed.clear();
  failing_calls::watching = true;
}

FailingCalls::~FailingCalls() { failing_calls::watching = false; }

void FailingCalls::fail_from(int number, int error, bool for_good) {
  const std::lock_guard lock(failing_calls::state().mutex);
  failing_calls::state().fails_at = number;
  failing_calls::state().error = error;
  failing_calls::state().for_good = for_good;
}

void FailingCalls::heal() { fail_from(-1, 0, false); }

int FailingCalls::count() const { return static_cast<int>(log().size()); }

std::vector<std::string> FailingCalls::log() const {
  const std::lock_guard lock(failing_calls::state().mutex);
  return failing_calls::state().log;
}

std::string FailingCalls::failed() const {
  const std::lock_guard lock(failing_calls::state().mutex);
  return failing_calls::state().failed;
}

}  // namespace talus

using talus::failing_calls::fails_at_file;
using talus::failing_calls::fails_at_path;
using talus::failing_calls::is_watched_file;

extern "C" {

int open(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(arguments, mode_t) : 0;
  va_end(arguments);
  return talus::failing_calls::opened(path, flags, mode);
}

ssize_t read(int descriptor, void* bytes, size_t count) {
  return fails_at_file("read", descriptor) ? -1 : ::syscall(SYS_read, descriptor, bytes, count);
}

ssize_t write(int descriptor, const void* bytes, size_t count) {
  return fails_at_file("write", descriptor) ? -1 : ::syscall(SYS_write, descriptor, bytes, count);
}

// Does not wait for the disk, which would take most of the time: no test cuts the power.
int fsync(int descriptor) {
  if (fails_at_file("fsync", descriptor)) return -1;
  return is_watched_file(descriptor) ? 0 : static_cast<int>(::syscall(SYS_fsync, descriptor));
}

int ftruncate(int descriptor, off_t length) noexcept {
  if (fails_at_file("ftruncate", descriptor)) return -1;
  return static_cast<int>(::syscall(SYS_ftruncate, descriptor, length));
}

int fchmod(int descriptor, mode_t mode) noexcept {
  if (fails_at_file("fchmod", descriptor)) return -1;
  return static_cast<int>(::syscall(SYS_fchmod, descriptor, mode));
}

int flock(int descriptor, int operation) noexcept {
  if (fails_at_file("flock", descriptor)) return -1;
  return static_cast<int>(::syscall(SYS_flock, descriptor, operation));
}

// The file is closed even if the call fails, as on Linux.
int close(int descriptor) {
  const bool failing = fails_at_file("close", descriptor);
  if (is_watched_file(descriptor)) {
    const std::lock_guard lock(talus::failing_calls::state().mutex);
    talus::failing_calls::state().names[static_cast<std::size_t>(descriptor)].clear();
  }
  const int error = errno;
  const auto closed = static_cast<int>(::syscall(SYS_close, descriptor));
  if (failing) errno = error;
  return failing ? -1 : closed;
}

int rename(const char* from, const char* to) noexcept {
  if (talus::failing_calls::is_watched(to) &&
      fails_at_path("rename", (std::string(from) + " " + talus::failing_calls::name_of(to)).c_str()))
    return -1;
  return static_cast<int>(::syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

int mkdir(const char* path, mode_t mode) noexcept {
  if (fails_at_path("mkdir", path)) return -1;
  return static_cast<int>(::syscall(SYS_mkdirat, AT_FDCWD, path, mode));
}

int unlink(const char* path) noexcept {
  if (fails_at_path("unlink", path)) return -1;
  return static_cast<int>(::syscall(SYS_unlinkat, AT_FDCWD, path, 0));
}

}  // extern "C"
