// Playback: whether a session plays, how fast, and the held input.
#pragma once

#include <talus/sim/state.h>

namespace talus {

inline constexpr double kStepsPerSecond = 60;  // at speed 1; TIC-80's rate
inline constexpr int kMaxCatchUpSteps = 64;    // limit for steps made in one go

inline constexpr double kMinSpeed = 1.0 / 8;
inline constexpr double kMaxSpeed = 8;

struct Playback {
  bool running = false;
  double speed = 1;  // kMinSpeed to kMaxSpeed
  Input input;       // held until changed
};

}  // namespace talus
