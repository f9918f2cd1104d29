// The real time comes from a system call.
#include "slow_clock.h"

#include <sys/syscall.h>
#include <unistd.h>

#include <ctime>

namespace talus {
namespace slow_clock {

inline thread_local long step = 0, added = 0;  // ns

}  // namespace slow_clock

SlowClock::SlowClock(double seconds) { slow_clock::step = static_cast<long>(seconds * 1e9); }
SlowClock::~SlowClock() { slow_clock::step = 0; }

}  // namespace talus

extern "C" int clock_gettime(clockid_t clock, timespec* time) noexcept {
  using namespace talus::slow_clock;
  constexpr long kNsPerSecond = 1'000'000'000;
  const auto result = static_cast<int>(::syscall(SYS_clock_gettime, clock, time));
  if (clock != CLOCK_THREAD_CPUTIME_ID || result != 0) return result;
  const long ns = time->tv_nsec + (added += step);
  time->tv_sec += ns / kNsPerSecond;
  time->tv_nsec = ns % kNsPerSecond;
  return 0;
}
