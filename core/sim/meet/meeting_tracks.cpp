// What circles roll along, and what of the ground they touch.
#include "meeting.h"

#include <algorithm>
#include <cmath>

namespace talus {

// ---- Where they are ----

// Takes a body along its path, whose time is another one then.
void Meeting::go_to(Member& member, double time) {
  FallPath& path = member.moving.path;
  Circle* const circle = member.circle;
  if (circle == nullptr) return void(path = path.from(time));
  const double s = time - path.time;
  double spin = circle->spin + circle->spin_pull * s;
  if (!circle->track.is_on) {
    path = path.from(time);
  } else {
    const Vec2 onward = circle->track.take(member.moving, time);
    if (circle->track.rolls < 1) spin = dot(path.velocity, onward) - circle->track.conveyor;
  }
  circle->turned += (circle->spin + spin) / 2 * s;
  circle->spin = spin;
}

// What of a body is solid at the time of the set.
Form Meeting::form_of(std::uint32_t index) const {
  const Member& member = members_[index];
  if (!member.is_on_track()) return member.moving.form_at(time_);
  MovingBox moving = member.moving;
  member.circle->track.take(moving, time_);
  return moving.form_at(time_);
}

std::optional<GroundMeeting> Meeting::next_meeting_of_circle(const Member& member, double to) {
  const auto along = member.is_on_track() ? std::span<const GroundSide>(member.circle->track.sides)
                                          : std::span<const GroundSide>();
  return round_.next_meeting(member.moving, to, along, budget_, member.circle->ground);
}

void Meeting::look_for_end_of_track(std::uint32_t index) {
  const Member& member = members_[index];
  if (!member.is_on_track() || member.moving.path.time >= part_) return;
  const double end = member.circle->track.end(member.moving, part_);
  budget_.left -= 8;
  if (end < part_) push({.time = end, .kind = Event::Kind::turn, .a = index});
}

// Whether a circle rolls on a body.
bool Meeting::goes_along(const Member& member, std::uint32_t other) const {
  if (!member.is_on_track()) return false;
  const Track& track = member.circle->track;
  return !track.is_ground && track.other == other && track.version == members_[other].version;
}

// Puts a body exactly on the ground that it stays on.
void Meeting::align(const Met& met, bool stays) {
  MovingBox& moving = members_[set_[static_cast<std::size_t>(met.touch.a)]].moving;
  if (!moving.is_round()) return probe_.align(met.contact, stays, moving, budget_);
  put_on(side_of(met).side, moving);
  const Vec2 normal = met.touch.normal;
  moving.path.velocity = moving.path.velocity - normal * dot(moving.path.velocity, normal);
  if (stays && !met.is_track) moving.path.pull = moving.path.pull - normal * dot(moving.path.pull, normal);
}

// ---- The ground that they touch ----

// Adds the contact of a circle with a side. Returns whether it is new.
bool Meeting::add_side(std::size_t place, const SideTouch& touch) {
  const Vec2 normal = touch.near.normal;
  if (!is_new(place, normal)) return false;
  const MovingBox& moving = members_[set_[place]].moving;
  const Form form = moving.form_at(time_);
  const int side = static_cast<int>(sides_.size());
  sides_.push_back({touch.side, nearness(touch.side, form.middle(), moving.radius).near});
  add_ground(place, normal, round_.contact_with(touch, form), side);
  return true;
}

// Circles in a pile press on all ground that they touch.
void Meeting::add_ground_of_circles() {
  if (circles_.empty()) return;
  for (std::size_t i = 0; i < set_.size(); ++i) {
    const MovingBox& moving = members_[set_[i]].moving;
    if (!is_inner(i) || !moving.is_round()) continue;
    const Form form = moving.form_at(time_);
    for (const SideTouch& touch : round_.touched(form, budget_)) {
      const Vec2 normal = touch.near.normal;
      if (dot(inertias_[i].velocity, normal) <= slow_) add_side(i, touch);
    }
  }
}

// The same for a circle, and all sides that it touches.
bool Meeting::probe_circle(std::size_t place, Vec2 way, double fastest) {
  if (is_still(way)) return false;
  bool finds = false;
  const Form form = members_[set_[place]].moving.form_at(time_);
  for (const SideTouch& touch : round_.touched(form, budget_)) {
    const Vec2 normal = touch.near.normal;
    if (!(-dot(way, normal) > kStillOnGround) || dot(inertias_[place].velocity, normal) > fastest) continue;
    if (add_side(place, touch)) finds = true;
  }
  return finds;
}

// ---- Tracks ----

// Of the contacts that a circle keeps, it goes along the one with the ground that bends towards it most, or
// along a body that stands still.
void Meeting::find_tracks() {
  if (circles_.empty()) return;
  for (Met& met : met_) {
    met.is_track = false;
    met.touch.parts = 0;
  }
  const auto is_at_rest = [&](int place) {
    return inertias_[static_cast<std::size_t>(place)].velocity == Vec2();
  };
  for (std::size_t i = 0; i < set_.size(); ++i) {
    const Member& member = members_[set_[i]];
    if (!is_inner(i) || !member.moving.is_round()) continue;
    const int place = static_cast<int>(i);
    Met* best = nullptr;
    bool is_on_ground = false;
    for (Met& met : met_) {
      const Touch& touch = met.touch;
      if (!met.is_round() || met.is_apart || (touch.a != place && touch.b != place)) continue;
      if (std::abs(ContactSet::speed(touch, inertias_, touch.normal)) > touch.still()) continue;
      const bool is_ground = touch.b == Touch::kGround;
      if (!is_ground && (is_on_ground || !is_at_rest(touch.a == place ? touch.b : touch.a))) continue;
      if (best == nullptr || (is_ground && !is_on_ground) ||
          side_of(met).near.bend < side_of(*best).near.bend)
        best = &met;
      is_on_ground = is_on_ground || is_ground;
    }
    if (best == nullptr) continue;
    best->is_track = true;
    best->touch.parts = side_of(*best).near.bend * dot(inertias_[i].velocity, inertias_[i].velocity);
  }
}

// A circle that something holds on a track goes along it from now on.
void Meeting::begin_track(const Met& met) {
  const auto goes = [&](int place) {
    if (place == Touch::kGround || !is_inner(static_cast<std::size_t>(place))) return false;
    const MovingBox& moving = members_[set_[static_cast<std::size_t>(place)]].moving;
    return moving.is_round() && !(moving.path.velocity == Vec2() && moving.path.pull == Vec2());
  };
  const bool is_first = goes(met.touch.a);
  if (!(met.touch.pressure > 0) || !(is_first || goes(met.touch.b))) return;
  const int place = is_first ? met.touch.a : met.touch.b, other = is_first ? met.touch.b : met.touch.a;
  Member& member = members_[set_[static_cast<std::size_t>(place)]];
  const Inertia& body = inertias_[static_cast<std::size_t>(place)];
  // It is about to leave what bends away, or is in a hollow as narrow as itself.
  const Nearness& near = side_of(met).near;
  if (near.bend > 0 && !(met.touch.pressure * body.inverse_mass > kBrink)) return;
  if (-near.bend * member.moving.radius > 1) return;
  const Vec2 normal = is_first ? met.touch.normal : Vec2() - met.touch.normal;
  Track& track = member.circle->track;
  track = {};
  track.on_end = near.on_end;
  track.is_on = other == Touch::kGround ? follow_ground(member, normal) : follow_body(track, near, other);
  if (track.is_on) track.begin(member.moving.form_at(time_));
  track.is_alone = std::none_of(met_.begin(), met_.end(), [&](const Met& m) {
    return &m != &met && (m.touch.a == place || m.touch.b == place) && m.touch.pressure > 0;
  });
  track.pull = member.pull;
  const Vec2 onward = along(normal);
  const double straight = dot(member.pull, onward), drawn = dot(body.pull, onward);
  const double slip = dot(body.velocity, onward) - body.spin - met.touch.conveyor;
  const bool rolls =
      met.touch.friction > 0 && std::abs(slip) <= kStill && std::abs(drawn - body.spin_pull) <= kStill;
  track.conveyor = met.touch.conveyor;
  track.rolls = rolls ? 1 / (1 + body.inverse_mass / body.inverse_spin) : 1;
  track.drive = drawn - track.rolls * straight;
}

// Of the sides that a circle touches, and keeps touching, it follows the one with this normal, or those that
// meet in the end that it goes round. Returns whether there are some.
bool Meeting::follow_ground(Member& member, Vec2 normal) {
  Track& track = member.circle->track;
  const MovingBox& moving = member.moving;
  const Form form = moving.form_at(time_);
  // All of the way: else the seams of tiles would be ends.
  for (const SideTouch& touch : round_.touched(form, area_around(form.box, moving.at(part_)), budget_)) {
    if (std::abs(dot(moving.path.velocity, touch.near.normal)) > kStillOnGround) continue;
    const bool is_followed = touch.near.on_end == track.on_end && is_still(touch.near.normal - normal);
    track.sides.insert(is_followed ? track.sides.begin() : track.sides.end(), touch.side);
    track.followed += is_followed;
  }
  return track.followed > 0;
}

// Returns whether the other body stands still.
bool Meeting::follow_body(Track& track, const Nearness& near, int other) const {
  const std::uint32_t index = set_[static_cast<std::size_t>(other)];
  const FallPath& path = members_[index].moving.path;
  track.is_ground = false;
  track.other = index;
  track.version = members_[index].version;
  track.form = form_of(index);
  track.gap = near.gap;
  return path.velocity == Vec2() && path.pull == Vec2();
}

}  // namespace talus
