// A second thread watches the first one.
#include "end_signals.h"

#include <pthread.h>

#include <condition_variable>
#include <ctime>
#include <mutex>

namespace talus {
namespace {

constexpr auto kLook = std::chrono::milliseconds(50);
constexpr auto kPatience = std::chrono::seconds(2);

bool is_waiting() {
  sigset_t waiting;
  sigpending(&waiting);
  return sigismember(&waiting, SIGINT) == 1 || sigismember(&waiting, SIGTERM) == 1;
}

// Gives a signal that nobody has taken for long its usual effect.
void look_after(const std::stop_token& stop, const sigset_t& signals) {
  std::mutex mutex;
  std::condition_variable_any wake;
  std::unique_lock lock(mutex);
  for (std::chrono::milliseconds waited{0}; !stop.stop_requested();) {
    wake.wait_for(lock, stop, kLook, [] { return false; });
    waited = is_waiting() ? waited + kLook : std::chrono::milliseconds(0);
    if (waited > kPatience) pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
  }
}

}  // namespace

EndSignals::EndSignals() {
  sigemptyset(&signals_);
  sigaddset(&signals_, SIGINT);
  sigaddset(&signals_, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals_, &before_);
  patience_ = std::jthread([signals = signals_](const std::stop_token& stop) { look_after(stop, signals); });
}

EndSignals::~EndSignals() {
  patience_ = {};
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

bool EndSignals::have_come() const { return is_waiting(); }

bool EndSignals::wait(std::chrono::nanoseconds time) const {
  constexpr long kNsPerSecond = 1'000'000'000;
  const timespec spec{time.count() / kNsPerSecond, time.count() % kNsPerSecond};
  return sigtimedwait(&signals_, nullptr, &spec) > 0;
}

}  // namespace talus
