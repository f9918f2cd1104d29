// EndSignals: holds back SIGINT (Ctrl+C) and SIGTERM, so that work can end in order.
#pragma once

#include <chrono>
#include <csignal>
#include <thread>

namespace talus {

// While it exists, signals that end a program wait for the thread that made it. If that thread does not check
// for them within two seconds, as it waits for a pipe or computes for long, they end the program
// nevertheless. Files are put in place as a whole, so this can happen at any time.
class EndSignals {
 public:
  EndSignals();
  ~EndSignals();  // a signal that still waits has its usual effect
  EndSignals(const EndSignals&) = delete;
  EndSignals& operator=(const EndSignals&) = delete;

  bool have_come() const;                          // whether signals wait
  bool wait(std::chrono::nanoseconds time) const;  // takes one; returns true if one came within the time

 private:
  sigset_t signals_{}, before_{};
  std::jthread patience_;  // it starts with signals held back, as every thread from then on
};

}  // namespace talus
