// HeldReading lets the program's threads wait where they read a file, for what the window does meanwhile. It
// replaces the C library's read in the whole program that it is linked into, so that the tested code knows
// nothing of it.
#pragma once

#include <string>

namespace talus {

class HeldReading {
 public:
  // While it exists, threads other than the caller's wait where they read this file. Only one object may
  // exist at a time.
  explicit HeldReading(const std::string& path);
  ~HeldReading();
  HeldReading(const HeldReading&) = delete;
  HeldReading& operator=(const HeldReading&) = delete;
};

}  // namespace talus
