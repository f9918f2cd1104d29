// talus sim --until: stops a run at the first frame in which a condition holds.
#pragma once

#include <optional>
#include <string>

#include <talus/collision/function_ref.h>
#include "command.h"
#include "debug/breakpoint.h"

namespace talus {

class Until {
 public:
  // condition: as of a breakpoint for any body; empty: the run stops nowhere. One that is wrong counts as
  // empty; problem_of_condition() tells.
  explicit Until(const std::string& condition);

  bool wanted() const { return condition_.has_value(); }
  // The next frame of the run, from 0 on. True: the condition holds in it, and the run should stop. False
  // where none is wanted.
  bool stops_at(Frame frame);
  // The frames 0 to `last` of a source; the one at which it stops, or `last`. goes_on: told the share of them
  // that it has looked at, 0..1; where it says no, the frame is `last` too.
  std::int64_t run(const FrameSource& source, std::int64_t last, FunctionRef<bool(double share)> goes_on);
  // Prints the frame as a line of a trace, and a sentence about the body for which the condition holds; where
  // it never held, fails.
  void report(CommandContext& context, const std::string& file) const;

 private:
  std::optional<ArmedBreakpoint> condition_;
  FrameHistory history_;
  std::optional<int> body_;  // for which it holds in the newest frame
};

// For the option: empty, or "at 3: MESSAGE" with the character where the mistake is, from 1.
std::string problem_of_condition(const std::string& condition);

}  // namespace talus
