// What circles roll along, and what of the ground they touch.
#include "meeting.h"

#include <algorithm>
#include <cmath>

#include "../../collision/box_on_piece.h"

namespace talus {
namespace {

// The corner of a box with which it goes along a curve.
MovingBox corner_of(const MovingBox& box, const Track& track) {
  MovingBox corner{box.path, {}};
  corner.path.place = box.path.place + track.corner;
  return corner;
}

// px: the corner of a box that touches a curve, from its top-left corner.
Vec2 corner_on(const Piece<double>& piece, Vec2 size) {
  return {foot_offset(piece, size.x, Foot::box), piece.facing == Facing::up ? size.y : 0};
}

// Whether a way along x, from a corner that touches a curve, does not leave it at once.
bool leads_along(const GroundSide& side, Vec2 corner, double way) {
  return way < 0 ? corner.x > side.from.x + kPast : corner.x < side.to.x - kPast;
}

}  // namespace

// ---- Where they are ----

// Takes a body along its path, whose time is another one then.
void Meeting::go_to(Member& member, double time) {
  FallPath& path = member.moving.path;
  Circle* const circle = member.circle;
  const double s = time - path.time;
  double spin = circle == nullptr ? 0 : circle->spin + circle->spin_pull * s;
  if (!member.is_on_track()) {
    path = path.from(time);
  } else {
    const Vec2 onward = take_along(*member.track, member.moving, time);
    if (member.track->rolls < 1) spin = dot(path.velocity, onward) - member.track->conveyor;
  }
  if (circle == nullptr) return;
  circle->turned += (circle->spin + spin) / 2 * s;
  circle->spin = spin;
}

// Takes a body on its track to a time, and returns the direction of the track there. The track of a box leads
// a little beside the path for which the ground was looked at: it must not lead into what is there.
Vec2 Meeting::take_along(const Track& track, MovingBox& moving, double time) {
  if (moving.is_round()) return track.take(moving, time);
  const Rect from = moving.at(moving.path.time);
  MovingBox corner = corner_of(moving, track);
  const Vec2 onward = track.take(corner, time);
  moving.path = corner.path;
  moving.path.place = corner.path.place - track.corner;
  const Piece<double>& piece = *track.sides.front().piece;
  const Vec2 way = moving.path.place - from.position();
  const Contact<double> met = cast_box<double>(probe_.ground(), {from, way, Foot::box}, {}, &piece, &budget_);
  if (!met) return onward;
  // The way is straight, and may be beside the curve where it ends.
  const Rect there{met.position.x, met.position.y, from.w, from.h};
  const double rest = rest_on(piece, probe_.ground().stretches(), there, Foot::box);
  const bool is_in = piece.facing == Facing::up ? there.y > rest : there.y < rest;
  moving.path.place = {there.x, is_in ? rest : there.y};
  return onward;
}

// What of a body is solid at the time of the set.
Form Meeting::form_of(std::uint32_t index) {
  const Member& member = members_[index];
  if (!member.is_on_track()) return member.moving.form_at(time_);
  MovingBox moving = member.moving;
  take_along(*member.track, moving, time_);
  return moving.form_at(time_);
}

std::optional<GroundMeeting> Meeting::next_meeting(const Member& member, double to) {
  const auto along =
      member.is_on_track() ? std::span<const GroundSide>(member.track->sides) : std::span<const GroundSide>();
  if (member.circle != nullptr) {
    auto met = round_.next_meeting(member.moving, to, along, budget_, member.circle->ground);
    if (met && member.is_on_track()) meet_on_track(member, to, *met);
    return met;
  }
  const Piece<double>* leaves = member.track != nullptr ? member.track->leaves : nullptr;
  return probe_.next_meeting(member.moving, to, along.empty() ? leaves : along.front().piece, budget_);
}

// The path of a circle leads a little beside its track. Changes the time of a meeting to that at which the
// circle on the track touches the side.
void Meeting::meet_on_track(const Member& member, double to, GroundMeeting& met) const {
  constexpr double kSame = 1e-12;  // frames
  constexpr int kMaxTries = 3;
  for (int i = 0; i < kMaxTries; ++i) {
    MovingBox there = member.moving;
    member.track->take(there, met.time);
    const Form form = there.form_at(met.time);
    const Nearness near = nearness(member.circle->ground, form.middle(), form.radius).near;
    const double time = met.time + near.gap / -dot(there.path.velocity, near.normal);
    if (!(time >= member.moving.path.time && time <= to)) break;
    if (!near.on_end) met.normal = near.normal;
    const bool is_same = std::abs(time - met.time) <= kSame;
    met.time = time;
    if (is_same) break;
  }
}

void Meeting::look_for_end_of_track(std::uint32_t index) {
  const Member& member = members_[index];
  if (!member.is_on_track() || member.moving.path.time >= part_) return;
  const MovingBox& moving = member.moving;
  const double end = member.track->end(moving.is_round() ? moving : corner_of(moving, *member.track), part_);
  budget_.left -= 8;
  if (end < part_) push({.time = end, .kind = Event::Kind::turn, .a = index});
}

// Whether a circle rolls on a body.
bool Meeting::goes_along(const Member& member, std::uint32_t other) const {
  if (!member.is_on_track()) return false;
  const Track& track = *member.track;
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
bool Meeting::add_side(std::size_t place, const SideTouch& touch, bool is_sorted) {
  const Vec2 normal = touch.near.normal;
  if (!is_new(place, normal)) return false;
  const MovingBox& moving = members_[set_[place]].moving;
  const Form form = moving.form_at(time_);
  const int side = static_cast<int>(sides_.size());
  sides_.push_back({touch.side, nearness(touch.side, form.middle(), moving.radius).near, touch.is_in_gap});
  add_ground(place, normal, round_.contact_with(touch, form), side, is_sorted);
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
      if (dot(inertias_[i].velocity, normal) <= slow_) add_side(i, touch, false);
    }
  }
  sort_met();
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

void Meeting::find_tracks() {
  if (tracks_.empty()) return;
  for (Met& met : met_) {
    met.is_track = false;
    met.touch.parts = 0;
  }
  for (std::size_t i = 0; i < set_.size(); ++i) {
    if (!is_inner(i)) continue;
    members_[set_[i]].moving.is_round() ? find_track_of_circle(i) : find_track_of_box(i);
  }
}

// Of the contacts that a circle keeps, it goes along the one with the ground that bends towards it most, or
// along a body that stands still.
void Meeting::find_track_of_circle(std::size_t place) {
  const int index = static_cast<int>(place);
  const auto is_at_rest = [&](int other) {
    return inertias_[static_cast<std::size_t>(other)].velocity == Vec2();
  };
  Met* best = nullptr;
  bool is_on_ground = false;
  for (Met& met : met_) {
    const Touch& touch = met.touch;
    if (!met.is_round() || met.is_apart || (touch.a != index && touch.b != index)) continue;
    if (side_of(met).is_in_gap) continue;  // a circle goes through it, not round its end
    if (std::abs(ContactSet::speed(touch, inertias_, touch.normal)) > touch.still()) continue;
    const bool is_ground = touch.b == Touch::kGround;
    if (!is_ground && (is_on_ground || !is_at_rest(touch.a == index ? touch.b : touch.a))) continue;
    if (best == nullptr || (is_ground && !is_on_ground) || side_of(met).near.bend < side_of(*best).near.bend)
      best = &met;
    is_on_ground = is_on_ground || is_ground;
  }
  if (best == nullptr || is_too_narrow(side_of(*best).near, place)) return;
  const Vec2 velocity = inertias_[place].velocity;
  best->is_track = true;
  best->touch.parts = side_of(*best).near.bend * dot(velocity, velocity);
}

// Whether a circle would turn so much in a hollow hardly wider than itself that parabolas cannot follow.
bool Meeting::is_too_narrow(const Nearness& near, std::size_t place) const {
  constexpr double kMaxTurn = 4;  // radians, in a part of a step
  const Vec2 velocity = inertias_[place].velocity;
  return -near.bend * std::sqrt(dot(velocity, velocity)) * part_ > kMaxTurn;
}

// A box goes along the one that bends towards it most of the curves that it keeps touching with a corner.
void Meeting::find_track_of_box(std::size_t place) {
  Met* best = nullptr;
  double least = 0;
  for (Met& met : met_) {
    const Touch& touch = met.touch;
    if (touch.a != static_cast<int>(place) || touch.b != Touch::kGround) continue;
    if (std::abs(ContactSet::speed(touch, inertias_, touch.normal)) > touch.still()) continue;
    const auto curve = curve_of(met);
    if (!curve || (best != nullptr && curve->near.bend >= least)) continue;
    best = &met;
    least = curve->near.bend;
  }
  if (best == nullptr) return;
  const Vec2 velocity = inertias_[place].velocity;
  best->is_track = true;
  best->touch.parts = least * dot(velocity, velocity);
}

// The curve along which a box goes that touches one with a corner.
std::optional<SideTouch> Meeting::curve_of(const Met& met) {
  const Piece<double>* const piece = met.contact.piece;
  if (piece == nullptr || piece->stretch == 0 || met.contact.on_end) return std::nullopt;
  const auto place = static_cast<std::size_t>(met.touch.a);
  const MovingBox& box = members_[set_[place]].moving;
  const Vec2 corner = box.path.place_at(time_) + corner_on(*piece, box.size);
  const double speed = inertias_[place].velocity.x, way = speed != 0 ? speed : inertias_[place].pull.x;
  GroundSide side = talus::side_of(*piece, probe_.ground().stretches());
  if (!leads_along(side, corner, way)) {
    const auto next = next_curve(side, corner, way);
    if (!next) return std::nullopt;
    side = *next;
  }
  return SideTouch{side, nearness(side, corner, 0).near};
}

// The curve that goes on where another one ends at a corner, and which the same corner of a box touches. way:
// px, along x.
std::optional<GroundSide> Meeting::next_curve(const GroundSide& last, Vec2 corner, double way) {
  const Rect around{corner.x - kPast, corner.y - kPast, 2 * kPast, 2 * kPast};
  std::vector<GroundSide> sides;
  find_sides(probe_.ground(), around, budget_, sides);
  for (const GroundSide& side : sides) {
    if (side.stretch == nullptr || side.facing != last.facing || !leads_along(side, corner, way)) continue;
    if (side.piece->rises_to_the_right() != last.piece->rises_to_the_right()) continue;
    const Vec2 end = way < 0 ? side.to : side.from;
    if (std::abs(end.x - corner.x) <= kPast && std::abs(end.y - corner.y) <= kPast) return side;
  }
  return std::nullopt;
}

// A body that something holds on a track goes along it from now on.
void Meeting::begin_track(const Met& met) {
  if (!met.is_round()) return begin_track_of_box(met);
  const auto goes = [&](int place) {
    return place != Touch::kGround && members_[set_[static_cast<std::size_t>(place)]].moving.is_round() &&
           is_moving(static_cast<std::size_t>(place));
  };
  const bool is_first = goes(met.touch.a);
  if (!(met.touch.pressure > 0) || !(is_first || goes(met.touch.b))) return;
  const int place = is_first ? met.touch.a : met.touch.b, other = is_first ? met.touch.b : met.touch.a;
  Member& member = members_[set_[static_cast<std::size_t>(place)]];
  const Inertia& body = inertias_[static_cast<std::size_t>(place)];
  const Nearness& near = side_of(met).near;
  if (near.bend > 0 && !(met.touch.pressure * body.inverse_mass > kBrink)) return;  // it is about to leave
  const Vec2 normal = is_first ? met.touch.normal : Vec2() - met.touch.normal;
  Track& track = *member.track;
  track = {};
  track.on_end = near.on_end;
  track.is_on = other == Touch::kGround ? follow_ground(member, normal) : follow_body(track, near, other);
  if (track.is_on) track.begin(member.moving.form_at(time_));
  const double slip = dot(body.velocity, along(normal)) - body.spin - met.touch.conveyor;
  const double drawn = dot(body.pull, along(normal));
  const bool rolls =
      met.touch.friction > 0 && std::abs(slip) <= kStill && std::abs(drawn - body.spin_pull) <= kStill;
  track.conveyor = met.touch.conveyor;
  track.rolls = rolls ? 1 / (1 + body.inverse_mass / body.inverse_spin) : 1;
  drive(track, met, place, normal);
  if (track.is_on) keep_pace(member, near.bend, normal);
}

// A box that a curve holds goes along it with a corner.
void Meeting::begin_track_of_box(const Met& met) {
  const auto place = static_cast<std::size_t>(met.touch.a);
  const auto curve = curve_of(met);
  if (!curve || !is_moving(place)) return;
  Member& member = members_[set_[place]];
  Track& track = *member.track;
  track = {};
  if (curve->near.bend > 0 && !(met.touch.pressure * inertias_[place].inverse_mass > kBrink)) {
    track.leaves = curve->side.piece;
  } else if (met.touch.pressure > 0) {
    track.is_on = true;
    leaves_apart_ = false;  // it leaves its path a little, to stay on the curve
    track.corner = corner_on(*curve->side.piece, member.moving.size);
    track.sides = {curve->side};
    track.followed = 1;
    track.begin(corner_of(member.moving, track).form_at(time_));
    drive(track, met, met.touch.a, met.touch.normal);
  }
}

// Changes the pull along the track of a circle, so that the path ends, with this piece of the track, where
// the circle would be. A parabola goes further along than what it is bent to, and the pull changes as the
// track turns: each makes a difference with the third power of the time. bend: as in Nearness. normal: out of
// what it follows.
void Meeting::keep_pace(Member& member, double bend, Vec2 normal) const {
  FallPath& path = member.moving.path;
  const Track& track = *member.track;
  const Vec2 onward = along(normal);
  const double speed = dot(path.velocity, onward), turn = bend * speed;
  if (turn == 0) return;
  const double time = std::min(part_ - time_, Track::longest(turn, true));
  const double change = -turn * (track.rolls * dot(track.pull, normal) + turn * speed);
  path.pull = path.pull + onward * (change * time / 3);
}

bool Meeting::is_moving(std::size_t place) const {
  const FallPath& path = members_[set_[place]].moving.path;
  return is_inner(place) && !(path.velocity == Vec2() && path.pull == Vec2());
}

// Says what moves a body along its track. normal: out of what it follows.
void Meeting::drive(Track& track, const Met& met, int place, Vec2 normal) const {
  const auto index = static_cast<std::size_t>(place);
  track.is_alone = std::none_of(met_.begin(), met_.end(), [&](const Met& m) {
    return &m != &met && (m.touch.a == place || m.touch.b == place) && m.touch.pressure > 0;
  });
  track.pull = members_[set_[index]].pull;
  const Vec2 onward = along(normal);
  track.drive = dot(inertias_[index].pull, onward) - track.rolls * dot(track.pull, onward);
}

// Of the sides that a circle touches, and keeps touching, it follows the one with this normal, or those that
// meet in the end that it goes round. Returns whether there are some.
bool Meeting::follow_ground(Member& member, Vec2 normal) {
  Track& track = *member.track;
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
bool Meeting::follow_body(Track& track, const Nearness& near, int other) {
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
