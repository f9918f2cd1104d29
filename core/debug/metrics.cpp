#include "metrics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "../collision/ground_queries.h"
#include "../sim/body_in_ground.h"
#include "compare.h"

namespace talus {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr double kFloorReach = 64;  // px below a body within which a floor is searched

constexpr std::array kInfos = {
    MetricInfo{Metric::id, "id", "", false, "number of the body, from 1"},
    MetricInfo{Metric::x, "x", "px", false, "left side of the box"},
    MetricInfo{Metric::y, "y", "px", false, "top of the box; y grows downwards"},
    MetricInfo{Metric::w, "w", "px", false, "width of the box"},
    MetricInfo{Metric::h, "h", "px", false, "height of the box"},
    MetricInfo{Metric::right, "right", "px", false, "right side of the box"},
    MetricInfo{Metric::bottom, "bottom", "px", false, "bottom of the box, its feet"},
    MetricInfo{Metric::vx, "vx", "px/frame", false, "velocity to the right"},
    MetricInfo{Metric::vy, "vy", "px/frame", false, "velocity downwards"},
    MetricInfo{Metric::speed, "speed", "px/frame", false, "length of the velocity"},
    MetricInfo{Metric::energy, "energy", "px^2/frame^2", false,
               "kinetic and potential energy for each unit of mass; only its changes matter"},
    MetricInfo{Metric::grounded, "grounded", "", true, "the body stood on ground in this step"},
    MetricInfo{Metric::landed, "landed", "", true, "it stands, and did not a frame before; solver exact"},
    MetricInfo{Metric::left_ground, "left_ground", "", true,
               "it stood a frame before, and does no longer; solver exact"},
    MetricInfo{Metric::hit, "hit", "mass*px/frame", false,
               "impulse of its hardest hit in this step; 0 without one; solver exact"},
    MetricInfo{Metric::contacts, "contacts", "", false, "contacts of the step that changed its way or speed"},
    MetricInfo{Metric::penetration, "penetration", "px", false,
               "how far the box is inside the ground; 0 outside, infinite when no straight way out is found"},
    MetricInfo{Metric::floor_error, "floor_error", "px", false,
               "feet below (+) or above (-) the exact floor while grounded; nothing in the air"},
    MetricInfo{Metric::normal_x, "normal.x", "", false, "normal of the step's last contact, to the right"},
    MetricInfo{Metric::normal_y, "normal.y", "", false, "normal of the step's last contact, downwards"},
    MetricInfo{Metric::normal_angle, "normal.angle", "degrees", false,
               "angle of that normal: 0 a level floor, 90 a wall that faces right, -90 left, 180 a ceiling"},
    MetricInfo{
        Metric::slope_delta, "slope_delta", "", false,
        "how far along the slope of the step's last contact with one: 0 at its left end, 1 at its right"},
    MetricInfo{Metric::capped, "capped", "", true, "it met more contacts than the solver handles in a step"},
    MetricInfo{Metric::cut_short, "cut_short", "", true,
               "it met the limit of work for a step, and stopped early"},
    MetricInfo{Metric::limited, "limited", "", true, "its way or speed was cut to the largest allowed"},
    MetricInfo{Metric::parting, "parting", "px", false,
               "distance from the same body on the other side of a comparison; infinite without one"},
};

// The entries of a body in a list that is sorted by body.
template <class Entry>
auto range_of(const std::vector<Entry>& entries, int body) {
  const auto less = [](const Entry& entry, int id) { return entry.body < id; };
  const auto first = std::lower_bound(entries.begin(), entries.end(), body, less);
  const auto last = std::lower_bound(first, entries.end(), body + 1, less);
  return std::make_pair(first, last);
}

// The last contact of a body for which `wanted` holds; null if there is none.
template <class Wanted>
const ContactRecord* last_contact(const Frame& frame, int body, Wanted wanted) {
  const auto contacts = contacts_of(frame.record, body);
  const auto at = std::find_if(contacts.rbegin(), contacts.rend(), wanted);
  return at == contacts.rend() ? nullptr : &*at;
}

bool is_grounded(const Frame& frame, const Body& body) {
  if (frame.scene->tuning.solver == SolverKind::exact) return body.gait.grounded;
  return last_contact(frame, body.id, [](const ContactRecord& c) {
           return has_effect(c) && normal_of_effect(c).y < 0;
         }) != nullptr;
}

bool has_event(const Frame& frame, int body, StepEvent::Kind kind) {
  const auto& events = frame.record.events;
  return std::any_of(events.begin(), events.end(),
                     [&](const StepEvent& event) { return event.body == body && event.kind == kind; });
}

double hardest_hit(const Frame& frame, int body) {
  double hardest = 0;
  for (const StepEvent& event : frame.record.events) {
    if (event.body == body && event.kind == StepEvent::Kind::hit) hardest = std::max(hardest, event.impulse);
  }
  return hardest;
}

double energy(const Frame& frame, const Body& body) {
  const Tuning& t = frame.scene->tuning;
  const bool runs = t.solver == SolverKind::exact && traits_of(body.kind).rule == BodyRule::run;
  const bool is_constant = t.solver == SolverKind::exact && (runs || t.exact.gravity > 0);
  double gravity = t.shared.fall_blend * t.shared.fall_speed;
  if (is_constant) gravity = runs ? t.player.gravity : t.exact.gravity;
  Vec2 v = body.velocity;
  const double part = runs ? 1 : 1 / t.exact.substeps;
  const bool meets = frame.scene->features.meets && !runs;  // its velocity is that of the frame itself
  if (is_constant && !meets && !body.gait.grounded) v.y += gravity * part / 2;
  return dot(v, v) / 2 - gravity * body.box.center().y;
}

double penetration(const Frame& frame, const Body& body) {
  const Terrain& ground = *frame.ground;
  CastBudget budget{kMaxQueryWork};
  const bool is_circle = circle_of(*frame.scene, body) > 0;
  if (!is_circle && !overlaps_ground(ground, body.box, body.foot)) return 0;
  if (const auto out = way_out_of(*frame.scene, ground, body, &budget)) return length(*out);
  return is_circle ? 0 : std::numeric_limits<double>::infinity();
}

double floor_error(const Frame& frame, const Body& body) {
  if (frame.ground == nullptr || !is_grounded(frame, body)) return kNothing;
  CastBudget budget{kMaxQueryWork};
  if (const auto out = way_out_of(*frame.scene, *frame.ground, body, &budget))
    return out->y < 0 ? -out->y : kNothing;
  if (circle_of(*frame.scene, body) > 0) return kNothing;  // it touches a slope beside its lowest point
  const auto floor = floor_below(*frame.ground, body.box, kFloorReach, body.foot, &budget);
  return floor ? body.box.bottom() - floor->y : kNothing;
}

Vec2 last_normal(const Frame& frame, int body) {
  const ContactRecord* contact = last_contact(frame, body, has_effect);
  return contact != nullptr ? normal_of_effect(*contact) : Vec2{kNothing, kNothing};
}

double angle_of(Vec2 normal) {
  constexpr double kDegrees = 57.29577951308232;
  // + 0.0, as -0 would turn a ceiling's 180 into -180.
  return std::atan2(normal.x + 0.0, -normal.y) * kDegrees;
}

double slope_delta(const Frame& frame, int body) {
  const ContactRecord* contact =
      last_contact(frame, body, [](const ContactRecord& c) { return c.slope.has_value(); });
  return contact != nullptr ? contact->slope->delta : kNothing;
}

double contact_count(const Frame& frame, int body) {
  const auto contacts = contacts_of(frame.record, body);
  return static_cast<double>(std::count_if(contacts.begin(), contacts.end(), has_effect));
}

}  // namespace

double length(Vec2 v) { return std::sqrt(dot(v, v)); }

std::span<const MetricInfo> metric_infos() { return kInfos; }

std::span<const ContactRecord> contacts_of(const StepRecord& record, int body) {
  const auto [first, last] = range_of(record.contacts, body);
  return {first, last};
}

const BodyPath* path_of(const StepRecord& record, int body) {
  const auto [first, last] = range_of(record.paths, body);
  return first != last ? &*first : nullptr;
}

bool has_effect(const ContactRecord& contact) {
  if (!contact.handled) return false;
  return contact.response != Response::cross || (contact.slope && contact.slope->corrected);
}

Vec2 normal_of_effect(const ContactRecord& contact) {
  return contact.slope && contact.slope->corrected ? contact.slope->normal : contact.normal;
}

double measure(Metric metric, const Frame& frame, const Body& body) {
  const BodyPath* path = nullptr;
  switch (metric) {
    case Metric::id:
      return body.id;
    case Metric::x:
      return body.box.x;
    case Metric::y:
      return body.box.y;
    case Metric::w:
      return body.box.w;
    case Metric::h:
      return body.box.h;
    case Metric::right:
      return body.box.right();
    case Metric::bottom:
      return body.box.bottom();
    case Metric::vx:
      return body.velocity.x;
    case Metric::vy:
      return body.velocity.y;
    case Metric::speed:
      return length(body.velocity);
    case Metric::energy:
      return energy(frame, body);
    case Metric::grounded:
      return is_grounded(frame, body);
    case Metric::landed:
      return has_event(frame, body.id, StepEvent::Kind::landed);
    case Metric::left_ground:
      return has_event(frame, body.id, StepEvent::Kind::left);
    case Metric::hit:
      return hardest_hit(frame, body.id);
    case Metric::contacts:
      return contact_count(frame, body.id);
    case Metric::penetration:
      return frame.ground != nullptr ? penetration(frame, body) : kNothing;
    case Metric::floor_error:
      return floor_error(frame, body);
    case Metric::normal_x:
      return last_normal(frame, body.id).x;
    case Metric::normal_y:
      return last_normal(frame, body.id).y;
    case Metric::normal_angle:
      return angle_of(last_normal(frame, body.id));
    case Metric::slope_delta:
      return slope_delta(frame, body.id);
    case Metric::capped:
      path = path_of(frame.record, body.id);
      return path != nullptr && path->capped;
    case Metric::cut_short:
      path = path_of(frame.record, body.id);
      return path != nullptr && path->cut_short;
    case Metric::limited:
      path = path_of(frame.record, body.id);
      return path != nullptr && path->limited;
    case Metric::parting:
      return frame.other ? parting_of(body, *frame.other) : kNothing;
  }
  return kNothing;
}

}  // namespace talus
