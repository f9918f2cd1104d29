// Metrics: numbers of a body in a frame, which plots show and conditions ask for.
#pragma once

#include <span>
#include <string_view>

#include "frame.h"

namespace talus {

enum class Metric {
  id,
  x,
  y,
  w,
  h,
  right,
  bottom,
  vx,
  vy,
  speed,
  energy,
  grounded,
  landed,
  left_ground,
  hit,
  contacts,
  penetration,
  floor_error,
  normal_x,
  normal_y,
  normal_angle,
  slope_delta,
  capped,
  cut_short,
  limited,
  parting
};

struct MetricInfo {
  Metric metric;
  std::string_view name;  // its name in expressions: "vx"
  std::string_view unit;  // "px", "px/frame", "px^2/frame^2", "mass*px/frame", "degrees" or ""
  bool is_truth;          // 0 or 1
  std::string_view help;  // one sentence
};
std::span<const MetricInfo> metric_infos();  // in the order of the enum

// Returns NaN if there is nothing to measure, such as the normal of a body that touches nothing. body: one of
// the frame's state.
//
// The energy of a body of mass 1 is v^2 / 2 - g * y, with y of its middle: 0 for a body at rest at the map's
// top edge, less below. g is the gravity that pulls the body: exact's gravity for balls, the player's for
// players. Without gravity, g is what falling gains in its first frame (fall_blend * fall_speed). Under
// constant gravity velocities belong to the middle between two frames, so v is taken half a part of a step
// later, but for bodies that meet. Then a flight keeps its energy to rounding.
double measure(Metric metric, const Frame& frame, const Body& body);

// Of a way, px, or of a velocity, px/frame.
double length(Vec2 v);

// The record of a step has the bodies one after the other, by id.
std::span<const ContactRecord> contacts_of(const StepRecord& record, int body);
const BodyPath* path_of(const StepRecord& record, int body);  // null if there is none

// Whether a contact changed the way or the speed of its body. A contact that was only crossed did not.
bool has_effect(const ContactRecord& contact);
// The normal that turned the body. For the article on a slope, it is the normal of the slope, not of its box.
Vec2 normal_of_effect(const ContactRecord& contact);

}  // namespace talus
