// SlowClock lets the processor time of a thread pass quickly, as if its work were slow. It replaces the C
// library's clock_gettime in the whole program that it is linked into, so that the tested code knows nothing
// of it.
#pragma once

namespace talus {

class SlowClock {
 public:
  // From now on each look of this thread at its processor time finds so many seconds more.
  explicit SlowClock(double seconds);
  ~SlowClock();
  SlowClock(const SlowClock&) = delete;
  SlowClock& operator=(const SlowClock&) = delete;
};

}  // namespace talus
