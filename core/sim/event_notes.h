// The events of a step, as the exact solver and bodies that meet find them.
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

#include <talus/level/tuning.h>
#include <talus/sim/record.h>
#include <talus/sim/state.h>

namespace talus {

// px/frame: how much faster a falling body becomes in its first frame.
inline double fall_gain(const Tuning& t) {
  return t.exact.gravity > 0 ? t.exact.gravity : std::abs(t.shared.fall_speed * t.shared.fall_blend);
}

// px/frame: a contact that changes the speed of a body by no more is no hit. A body that rests, or that its
// keys press against a wall, loses half of it in each step.
inline double quiet_speed(const Tuning& t, BodyRule rule) {
  constexpr double kRounding = 1e-9;
  const auto most = [](std::initializer_list<double> gains) { return kRounding + 2 * std::max(gains); };
  if (rule == BodyRule::run) return most({t.player.gravity, t.player.run_gain, t.player.air_gain});
  return most({fall_gain(t), std::abs(t.shared.drift_speed * t.shared.drift_blend)});
}

// events: null, if nobody wants them. impulse: mass times px/frame, along the normal.
inline void note_hit(std::vector<StepEvent>* events, int body, int other, Vec2 normal, double impulse) {
  if (events != nullptr) events->push_back({StepEvent::Kind::hit, body, other, normal, impulse});
}

// stood: after the step before.
inline void note_standing(std::vector<StepEvent>* events, const Body& body, bool stood) {
  if (events == nullptr || body.gait.grounded == stood) return;
  StepEvent& event = events->emplace_back();
  event.kind = stood ? StepEvent::Kind::left : StepEvent::Kind::landed;
  event.body = body.id;
}

}  // namespace talus
