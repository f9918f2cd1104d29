// What a command that may take long shows meanwhile on a terminal, and how Ctrl+C ends it.
#pragma once

#include <chrono>
#include <iosfwd>
#include <string>

#include "end_signals.h"

namespace talus {

// While there is one, the signals that end a program wait, so that the work can be ended in order; at the
// latest when it goes they have their usual effect.
class ProgressLine {
 public:
  using Clock = std::chrono::steady_clock;
  // label: what is being done. shows: false: nothing is written, as where the stream is no terminal.
  // after: how long the work goes on before there is a line.
  ProgressLine(std::ostream& stream, const std::string& label, bool shows,
               Clock::duration after = std::chrono::seconds(1));
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  // Shows the share that is done, 0..1, ten times a second at most. False: a signal came, the work is to end.
  bool at(double share);
  void wipe();  // before anything else is written there

 private:
  std::ostream& stream_;
  std::string label_;
  bool shows_;
  Clock::time_point next_;  // when the line is written again
  bool is_shown_ = false;
  EndSignals signals_;
};

// Whether somebody sees at once what is written there: it is the program's own error stream, on a terminal.
bool is_terminal(const std::ostream& stream);

}  // namespace talus
