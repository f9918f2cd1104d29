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
  // condition: as for a breakpoint on any body; empty: the run does not stop. A faulty condition counts as
  // empty; problem_of_condition() reports it.
  explicit Until(const std::string& condition);

  bool wanted() const { return condition_.has_value(); }
  // Takes the next frame of the run, from 0 on. Returns true if the condition holds in it and the run should
  // stop; always false without a condition.
  bool stops_at(Frame frame);
  // Looks at the frames 0 to `last` of a source. Returns the frame at which it stops, or `last`. goes_on:
  // receives the share that is done, 0..1; if it returns false, the result is `last`, too.
  std::int64_t run(const FrameSource& source, std::int64_t last, FunctionRef<bool(double share)> goes_on);
  // Prints the frame as a line of a trace, and a sentence about the body for which the condition holds. Fails
  // if it never held.
  void report(CommandContext& context, const std::string& file) const;

 private:
  std::optional<ArmedBreakpoint> condition_;
  FrameHistory history_;
  std::optional<int> body_;  // for which it holds in the newest frame
};

// For the option: empty, or "at 3: MESSAGE" with the character of the mistake, from 1.
std::string problem_of_condition(const std::string& condition);

}  // namespace talus
