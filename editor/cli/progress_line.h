// ProgressLine: shows on a terminal how far a long command is, and lets Ctrl+C end it.
#pragma once

#include <chrono>
#include <iosfwd>
#include <string>

#include "end_signals.h"

namespace talus {

// While it exists, signals that end a program wait, so that the work can end in order. They have their usual
// effect when it is destroyed.
class ProgressLine {
 public:
  using Clock = std::chrono::steady_clock;
  // label: what is being done. shows: false if the stream is not a terminal; then nothing is written. after:
  // how long the work goes on before a line appears. between: how long each share is shown at least.
  ProgressLine(std::ostream& stream, const std::string& label, bool shows,
               Clock::duration after = std::chrono::seconds(1),
               Clock::duration between = std::chrono::milliseconds(100));
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  // Shows the share that is done, 0..1, unless another one was shown just now. Returns false if a signal
  // came: the work should end.
  bool at(double share);
  void wipe();  // call it before anything else is written there

 private:
  std::ostream& stream_;
  std::string label_;
  bool shows_;
  Clock::time_point next_;  // when the line is written again
  Clock::duration between_;
  bool is_shown_ = false;
  EndSignals signals_;
};

// Whether a user sees the output at once: it is the program's own error stream, on a terminal.
bool is_terminal(const std::ostream& stream);

}  // namespace talus
