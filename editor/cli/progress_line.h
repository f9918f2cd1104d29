// ProgressLine: shows how far a long command is, and lets Ctrl+C end it.
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
  // label: what is being done. is_terminal: whether a line can be overwritten; else there is a new one each
  // minute. after: how long the work goes on before a line appears on a terminal. between: how long each
  // share is shown there at least.
  ProgressLine(std::ostream& stream, const std::string& label, bool is_terminal,
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
  bool is_terminal_;
  Clock::time_point start_, next_;  // of the work; when the line is written again
  Clock::duration between_;
  bool is_shown_ = false;
  EndSignals signals_;
};

// Whether a user sees the output at once: it is the program's own error stream, on a terminal.
bool is_terminal(const std::ostream& stream);

}  // namespace talus
