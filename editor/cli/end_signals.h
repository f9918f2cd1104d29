// SIGINT (Ctrl+C) and SIGTERM, held back so that work can be ended in order.
#pragma once

#include <chrono>
#include <csignal>
#include <thread>

namespace talus {

// While there is one, the signals that end a program wait for the thread that made it. Work that does not
// look for them within two seconds, as it waits for a pipe or computes for long, is ended by them all the
// same: files are put in place whole, so that it may be ended anywhere.
class EndSignals {
 public:
  EndSignals();
  ~EndSignals();  // a signal that still waits has its usual effect
  EndSignals(const EndSignals&) = delete;
  EndSignals& operator=(const EndSignals&) = delete;

  bool have_come() const;                          // and still wait
  bool wait(std::chrono::nanoseconds time) const;  // takes one; true when one came within the time

 private:
  sigset_t signals_{}, before_{};
  std::jthread patience_;  // begun with the signals held back, as in every thread from then on
};

}  // namespace talus
