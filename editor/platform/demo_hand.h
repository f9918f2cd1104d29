// The hand that lifts and drops balls of the demo while nobody touches it, so that something always moves.
#pragma once

#include <cstdint>
#include <optional>

#include <talus/sim/state.h>

#include "session/run/run_actions.h"

namespace talus {

class DemoHand {
 public:
  // What the mouse does in the next step from this state; nothing while the balls are left alone.
  std::optional<action::HoldMouse> next(const State& state);
  // Whether it holds a ball.
  bool holds() const { return from_.has_value(); }

 private:
  std::int64_t round_ = -1;   // of the ball that it took up last
  std::optional<Vec2> from_;  // px, where it took up the ball that it holds
};

}  // namespace talus
