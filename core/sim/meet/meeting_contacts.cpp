// What bodies that touch at one time do to one another: they bounce, and then rest on one another or part.
#include "meeting.h"

#include <algorithm>
#include <cmath>

#include "../../collision/ground_queries.h"
#include "../contact_notes.h"
#include "../event_notes.h"
#include "../step_limits.h"

namespace talus {
namespace {

// After so many, it and what it touches stop there until the part is over.
constexpr int kMaxEvents = 64;

// The point at which a circle touches a level or upright side, as a box without size.
Rect point_on(const GroundSide& side, const Form& form) {
  const Vec2 middle = form.middle();
  const auto [top, bottom] = std::minmax(side.from.y, side.to.y);
  return {std::clamp(middle.x, side.from.x, side.to.x), std::clamp(middle.y, top, bottom), 0, 0};
}

}  // namespace

void Meeting::resolve(const Event& event) {
  Member& first = members_[event.a];
  time_ = event.time;
  const bool is_ground = event.kind == Event::Kind::ground;
  if (is_ground) {
    if (!belts_.empty()) belts_[event.a] = {};
    const bool is_on_track = first.is_on_track();
    go_to(first, time_);
    if (is_on_track) first.track->is_on = false;
    if (!is_on_track) first.moving.path.place = first.ground.place;
  }
  shaken_.clear();
  reach_ = first_reach(event);
  bool is_crowded = false, goes_on = false;
  do {
    gather(event);
    add_ground_of_circles();
    if (is_ground) {
      // What it meets at the same time belongs to the same impact; rounding is not to choose.
      const auto place = static_cast<std::size_t>(first.place_in_set);
      const Vec2 velocity = inertias_[place].velocity;
      if (first.circle != nullptr)
        add_side(place, {first.circle->ground, {first.ground.normal}});
      else if (!leaves_crest(place, first.ground.contact))
        add_ground(place, first.ground.normal, first.ground.contact);
      probe(place, {velocity.x, 0}, -kStillOnGround);
      probe(place, {0, velocity.y}, -kStillOnGround);
    }
    is_crowded = is_crowd();
    if (is_crowded) {
      bounce_crowd();
      move_on();
      goes_on = reaches_further();
    } else {
      bounce();
      goes_on = shakes_more();
    }
  } while (goes_on);
  is_crowded ? spend_pulls() : hold();
  if (!is_crowded && is_dozing()) {
    for (Inertia& body : inertias_) {
      body.velocity = body.pull = {};
      body.spin = body.spin_pull = 0;
    }
  }
  remember_set();
  note_contacts();
  set_paths();
  const bool is_capped = std::any_of(
      set_.begin(), set_.end(), [&](std::uint32_t index) { return members_[index].events >= kMaxEvents; });
  if (is_capped) stop_set();
  for (std::size_t i = 0; i < set_.size(); ++i) {
    members_[set_[i]].place_in_set = -1;
    if (is_inner(i)) set_off(set_[i]);
  }
  for (const Met& met : met_) look_for_turn(met);
}

// Gives the bodies of the set their new paths.
void Meeting::set_paths() {
  for (std::size_t i = 0; i < set_.size(); ++i) {
    if (!is_inner(i)) continue;
    Member& member = members_[set_[i]];
    FallPath& path = member.moving.path;
    path.velocity = within_limits({}, inertias_[i].velocity);
    path.pull = within_limits({}, inertias_[i].pull);
    if (is_still(path.velocity) && is_still(path.pull)) path.velocity = path.pull = {};
    if (member.circle == nullptr) continue;
    const Vec2 spin{inertias_[i].spin, inertias_[i].spin_pull};
    member.circle->spin = is_still(spin) ? 0 : spin.x;
    member.circle->spin_pull = is_still(spin) ? 0 : spin.y;
  }
  for (const Met& met : met_) {
    const auto a = static_cast<std::size_t>(met.touch.a);
    if (met.touch.b == Touch::kGround && is_inner(a)) {
      const double speed = ContactSet::speed(met.touch, inertias_, met.touch.normal);
      const bool stays = ContactSet::gain(met.touch, inertias_) <= kStillOnGround;
      if (std::abs(speed) <= kStillOnGround) align(met, stays);
    }
    if (met.is_track) begin_track(met);
    if (!(met.touch.impulse > 0) || met.touch.bounce == 0) continue;
    members_[set_[a]].bounced = time_;
    if (met.touch.b != Touch::kGround) members_[set_[static_cast<std::size_t>(met.touch.b)]].bounced = time_;
  }
}

// The bodies of the set have had more contacts than a step handles.
void Meeting::stop_set() {
  for (std::size_t i = 0; i < set_.size(); ++i) {
    if (!is_inner(i)) continue;
    Member& member = members_[set_[i]];
    member.is_capped = true;
    member.inverse_mass = 0;
    if (member.circle != nullptr) member.circle->inverse_spin = 0;
    stop(member);
  }
}

// ---- The ground that they touch ----

// px/frame, of the ground that a body touches. What keeps its ground keeps the speed: on the way over a joint
// a body that has become as fast as its conveyor would be too fast at once, and so on.
double Meeting::conveyor_under(const Met& met) {
  if (belts_.empty()) return 0;
  const std::uint32_t index = set_[static_cast<std::size_t>(met.touch.a)];
  const bool is_upright = met.contact.facing == Facing::left || met.contact.facing == Facing::right;
  Belt& belt = belts_[index][is_upright ? 1 : 0];
  if (belt.normal == met.touch.normal) return belt.speed;
  const MovingBox& moving = members_[index].moving;
  const Rect touching =
      met.is_round() ? point_on(side_of(met).side, moving.form_at(time_)) : moving.at(time_);
  belt = {met.touch.normal, conveyor_at(probe_.ground(), met.contact, touching)};
  return belt.speed;
}

// side: as Met::side. is_sorted: else sort_met() is to follow.
void Meeting::add_ground(std::size_t place, Vec2 normal, const Contact<double>& contact, int side,
                         bool is_sorted) {
  Met& met = met_.emplace_back();
  met.contact = contact;
  met.side = side;
  met.touch.a = static_cast<int>(place);
  met.touch.normal = normal;
  met.touch.friction = members_[set_[place]].friction;
  met.touch.conveyor = conveyor_under(met);
  if (met.is_round()) met.touch.slow = slow_;
  if (is_sorted) sort_met();
}

void Meeting::sort_met() {
  std::sort(met_.begin(), met_.end(), [](const Met& a, const Met& b) {
    const auto key = [](const Touch& t) { return std::tuple(t.a, t.b, t.normal.y, t.normal.x); };
    return key(a.touch) < key(b.touch);
  });
}

// Whether a box that has no speed is moved off a crest. One that slides over it goes on by itself.
bool Meeting::leaves_crest(std::size_t place, const Contact<double>& contact) {
  MovingBox& moving = members_[set_[place]].moving;
  Rect box = moving.at(time_);
  if (!is_still(inertias_[place].velocity) || !probe_.moves_off_crest(contact, box, budget_)) return false;
  moving.path.place = box.position();
  return true;
}

// Looks for ground that a body touches, that it would go into on this way, and that it leaves no faster than
// `fastest`. Returns whether there is some that is new.
bool Meeting::probe(std::size_t place, Vec2 way, double fastest) {
  if (!is_inner(place)) return false;
  Member& member = members_[set_[place]];
  if (member.moving.is_round()) return probe_circle(place, way, fastest);
  constexpr int kMaxTries = 3;
  for (int i = 0; i < kMaxTries && !is_still(way); ++i) {
    Rect box = member.moving.at(time_);
    const auto contact = probe_.touched(box, way, budget_);
    if (!contact) return false;
    const Vec2 normal = contact->normal;
    member.moving.path.place = box.position();
    if (leaves_crest(place, *contact)) continue;
    if (!(-dot(way, normal) > kStillOnGround)) return false;
    if (dot(inertias_[place].velocity, normal) <= fastest) {
      if (!is_new(place, normal)) return false;
      add_ground(place, normal, *contact);
      return true;
    }
    // It leaves this piece: there may be another one behind it.
    way = slide_along(normal, way);
  }
  return false;
}

bool Meeting::is_new(std::size_t place, Vec2 normal) const {
  return std::none_of(met_.begin(), met_.end(), [&](const Met& met) {
    return met.touch.a == static_cast<int>(place) && met.touch.b == Touch::kGround &&
           is_still(met.touch.normal - normal);
  });
}

// ---- Impacts ----

// Whether what has this normal is a floor or a ceiling, not a wall.
bool Meeting::is_level(Vec2 normal) const {
  return std::abs(normal.x) <= scene_->tuning.exact.steepest * std::abs(normal.y);
}

// What the mouse presses on others would tremble if they bounced.
bool Meeting::is_dragged() const {
  return state_->grabbed != 0 &&
         std::any_of(set_.begin(), set_.end(), [&](std::uint32_t index) { return members_[index].is_held; });
}

double Meeting::bounce_of(const Touch& touch) const {
  if (is_dragged()) return 0;
  const auto of = [&](int place) {
    const Member& member = members_[set_[static_cast<std::size_t>(place)]];
    return is_level(touch.normal) ? member.floor_bounce : member.wall_bounce;
  };
  if (touch.b == Touch::kGround) return of(touch.a);
  return std::min(1.0, std::max(of(touch.a), of(touch.b)));
}

// px/frame: a bounce that is slower is over within a step.
double Meeting::slowest_on(const Touch& touch) const {
  const double up = -touch.normal.y;
  return slowest_ * (touch.b == Touch::kGround ? std::max(up, 0.0) : std::abs(up));
}

// Bounces that follow one another ever sooner would never end: a slow one stays that follows another one so
// soon. (Luding and McNamara 1998, "How to handle the inelastic collapse", let such bounces lose nothing.)
bool Meeting::bounced_lately(const Touch& touch) const {
  constexpr double kSoon = 0.25;  // frames
  const auto has = [&](int place) {
    const double bounced = members_[set_[static_cast<std::size_t>(place)]].bounced;
    return bounced >= 0 && bounced < time_ && time_ - bounced < kSoon;
  };
  return has(touch.a) && (touch.b == Touch::kGround || has(touch.b));
}

bool Meeting::is_restless(int place) const {
  return place != Touch::kGround && members_[set_[static_cast<std::size_t>(place)]].events > kMaxSlowEvents;
}

// Chooses what is reflected at once: what approaches, and what is held together already. Returns whether
// anything approaches. is_late: it has gone on for so long that nothing bounces any more.
bool Meeting::choose(bool is_late) {
  chosen_.clear();
  chosen_at_.clear();
  bool approaches = false;
  for (std::size_t i = 0; i < met_.size(); ++i) {
    if (met_[i].is_apart) continue;
    Touch& touch = met_[i].touch;
    const double speed = -ContactSet::speed(touch, inertias_, touch.normal), still = touch.still();
    if (!met_[i].is_round() && speed < -still && -speed <= slowest_ &&
        (is_restless(touch.a) || is_restless(touch.b)))
      touch.is_caught = true;
    approaches = approaches || speed > still || (touch.is_caught && speed < -still);
    if (speed > still && !touch.is_held) {
      const double bounce = bounce_of(touch);
      touch.is_held =
          is_late || speed * bounce <= slowest_on(touch) || (speed <= slowest_ && bounced_lately(touch));
      touch.bounce = touch.is_held ? 0 : bounce;
    }
    if (!(speed > still) && !touch.is_held && !touch.is_caught) continue;
    chosen_.push_back(touch);
    chosen_at_.push_back(i);
  }
  // Where nothing bounces, all are solved at once: friction makes circles press on what they did not
  // approach.
  const bool bounces = std::any_of(chosen_.begin(), chosen_.end(), [](const Touch& t) { return !t.is_held; });
  const bool is_round =
      std::any_of(chosen_.begin(), chosen_.end(), [](const Touch& t) { return t.slow > 0; });
  if (approaches && is_round && !bounces) {
    chosen_.clear();
    chosen_at_.clear();
    for (std::size_t i = 0; i < met_.size(); ++i) {
      if (met_[i].is_apart) continue;
      chosen_.push_back(met_[i].touch);
      if (!chosen_.back().is_held) chosen_.back().bounce = 0;
      chosen_at_.push_back(i);
    }
  }
  return approaches;
}

// Reflects what approaches, again until nothing does.
void Meeting::bounce() {
  for (std::size_t i = 0; i < set_.size(); ++i) before_[i] = inertias_[i].velocity;
  std::vector<char> is_changed(set_.size(), 1);
  const std::size_t most = 32 + 4 * set_.size();
  for (std::size_t turn = 0; turn < 2 * most; ++turn) {
    for (std::size_t i = 0; i < set_.size(); ++i) {
      if (is_changed[i]) probe(i, inertias_[i].velocity, -kStillOnGround);
      is_changed[i] = 0;
    }
    if (!choose(turn >= most)) return level_out();
    if (budget_.left <= 0) return;
    contacts_.reflect(inertias_, chosen_);
    budget_.left -= contacts_.take_work();
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
      met_[chosen_at_[i]].touch = chosen_[i];
      is_changed[static_cast<std::size_t>(chosen_[i].a)] = 1;
      if (chosen_[i].b != Touch::kGround) is_changed[static_cast<std::size_t>(chosen_[i].b)] = 1;
    }
  }
}

// What is left of an approach that is too slow to bounce would add up over the frames.
void Meeting::level_out() {
  constexpr double kLeft = 1e-14;  // px/frame
  bool approaches = false;
  chosen_.clear();
  for (const Met& met : met_) {
    if (met.is_apart) continue;
    const bool is_own = met.touch.b == Touch::kGround || is_inner(static_cast<std::size_t>(met.touch.b));
    if (!is_own || !is_inner(static_cast<std::size_t>(met.touch.a))) continue;
    const double speed = ContactSet::speed(met.touch, inertias_, met.touch.normal);
    approaches = approaches || speed < -kLeft;
    if (speed > met.touch.still()) continue;
    Touch& touch = chosen_.emplace_back();
    touch.a = met.touch.a;
    touch.b = met.touch.b;
    touch.normal = met.touch.normal;
  }
  if (!approaches) return;
  contacts_.reflect(inertias_, chosen_);
  budget_.left -= contacts_.take_work();
}

// ---- Rest ----

// Slow bodies that go to and fro ever sooner, as between two slopes, would never come to rest: they stop for
// the rest of the step.
bool Meeting::is_dozing() const {
  bool has_restless = false;
  for (std::size_t i = 0; i < set_.size(); ++i) {
    const Vec2 v = inertias_[i].velocity;
    if (std::abs(v.x) > slowest_ || std::abs(v.y) > slowest_ || std::abs(inertias_[i].spin) > slowest_)
      return false;
    has_restless = has_restless || is_restless(static_cast<int>(i));
  }
  return has_restless;
}

// Finds the pulls of bodies that stay together.
void Meeting::hold() {
  std::vector<Vec2> free(set_.size());
  for (std::size_t i = 0; i < set_.size(); ++i) {
    free[i] = inertias_[i].pull;
    if (!is_inner(i)) inertias_[i].inverse_mass = inertias_[i].inverse_spin = 0;
  }
  constexpr int kMaxTurns = 16;
  bool has_settled = false;
  for (int turn = 0; turn < kMaxTurns; ++turn) {
    chosen_.clear();
    chosen_at_.clear();
    for (std::size_t i = 0; i < set_.size(); ++i) {
      inertias_[i].pull = free[i];
      if (is_inner(i)) inertias_[i].spin_pull = 0;
    }
    find_tracks();
    for (std::size_t i = 0; i < met_.size(); ++i) {
      const Touch& touch = met_[i].touch;
      if (met_[i].is_apart) continue;
      if (ContactSet::speed(touch, inertias_, touch.normal) > std::max(touch.still(), touch.slow)) continue;
      chosen_.push_back(touch);
      chosen_at_.push_back(i);
    }
    if (!chosen_.empty()) {
      contacts_.support(inertias_, chosen_);
      budget_.left -= contacts_.take_work();
    }
    for (std::size_t i = 0; i < chosen_.size(); ++i) met_[chosen_at_[i]].touch = chosen_[i];
    bool finds = false;
    for (std::size_t i = 0; i < set_.size(); ++i) {
      if (probe(i, inertias_[i].pull, kStillOnGround)) finds = true;
    }
    if (finds) continue;
    const bool is_slow =
        std::any_of(chosen_.begin(), chosen_.end(), [](const Touch& touch) { return touch.slow > 0; });
    if (!is_slow || has_settled) return;
    has_settled = true;
    const bool may_rub_otherwise = contacts_.settle(inertias_, chosen_);
    budget_.left -= contacts_.take_work();
    if (!may_rub_otherwise) return;
  }
}

// Friction stops a body that slides: then it is held.
void Meeting::look_for_turn(const Met& met) {
  if (!(met.touch.pressure > 0) || met.touch.friction == 0) return;
  Vec2 velocity, pull;
  double spin = 0, spin_pull = 0;
  const auto add = [&](int place, double sign) {
    if (place == Touch::kGround) return;
    const Member& member = members_[set_[static_cast<std::size_t>(place)]];
    velocity = velocity + member.moving.path.velocity * sign;
    pull = pull + member.moving.path.pull * sign;
    if (member.circle == nullptr) return;
    spin += member.circle->spin;
    spin_pull += member.circle->spin_pull;
  };
  add(met.touch.a, 1);
  add(met.touch.b, -1);
  const Vec2 along = met.touch.along();
  const double speed = dot(velocity, along) - spin - met.touch.conveyor, gain = dot(pull, along) - spin_pull;
  if (!(speed * gain < 0) || std::abs(speed) <= kStill) return;
  const double then = time_ - speed / gain;
  if (!(then < part_)) return;
  const int mover = is_inner(static_cast<std::size_t>(met.touch.a)) ? met.touch.a : met.touch.b;
  push({.time = then, .kind = Event::Kind::turn, .a = set_[static_cast<std::size_t>(mover)]});
}

// ---- Records ----

// Which bodies stand; and the contacts of impacts, and those of rest once in a step. Of each body those come
// first that stop it, and then those that only push it.
void Meeting::note_contacts() {
  note_hits();
  for (const bool stops : {true, false}) {
    for (const Met& met : met_) {
      if (!(met.touch.impulse > 0) && !(met.touch.pressure > 0)) continue;
      note(met, met.touch.a, met.touch.b, met.touch.normal, stops);
      note(met, met.touch.b, met.touch.a, Vec2() - met.touch.normal, stops);
    }
  }
}

void Meeting::note_hits() {
  if (step_events_ == nullptr) return;
  for (const Met& met : met_) {
    const auto member = [&](int place) -> const Member& {
      return members_[set_[static_cast<std::size_t>(place)]];
    };
    const Touch& touch = met.touch;
    const bool is_ground = touch.b == Touch::kGround;
    const double yields = member(touch.a).inverse_mass + (is_ground ? 0 : member(touch.b).inverse_mass);
    // An impulse that only holds what rests above changes the speed of none of the two.
    const auto change = [&](int place) {
      const auto at = static_cast<std::size_t>(place);
      return std::abs(dot(inertias_[at].velocity - before_[at], touch.normal));
    };
    const double changed = std::max(change(touch.a), is_ground ? 0 : change(touch.b));
    if (!(touch.impulse * yields > quiet_ && changed > quiet_)) continue;
    const auto id = [&](int place) { return state_->bodies[set_[static_cast<std::size_t>(place)]].id; };
    const int a = id(touch.a), b = is_ground ? 0 : id(touch.b);
    if (member(touch.a).is_inner) note_hit(step_events_, a, b, touch.normal, touch.impulse);
    if (!is_ground && member(touch.b).is_inner)
      note_hit(step_events_, b, a, Vec2() - touch.normal, touch.impulse);
  }
}

// One side of a contact: a body by its place in the set, and what it has met, out of which the normal leads.
void Meeting::note(const Met& met, int place, int other, Vec2 normal, bool stops) {
  if (place == Touch::kGround || !is_inner(static_cast<std::size_t>(place))) return;
  const std::uint32_t index = set_[static_cast<std::size_t>(place)];
  Member& member = members_[index];
  if (normal.y < 0 && is_level(normal)) member.is_grounded = true;
  const bool is_impact = met.touch.impulse > 0;
  if (record_ == nullptr || !(is_impact || time_ == 0)) return;
  const Vec2 move = before_[static_cast<std::size_t>(place)] * part_ + member.pull * (part_ * part_ / 2);
  if (stops != (dot(move, normal) < 0)) return;
  ContactRecord& c = record_->contacts.emplace_back();
  c.body = state_->bodies[index].id;
  c.order = member.order++;
  if (other == Touch::kGround) {
    c.other = obstacle_of(probe_.ground(), met.contact);
    c.slope = slope_probe(met.contact, c.other, member.moving.size);
  } else {
    const std::uint32_t there = set_[static_cast<std::size_t>(other)];
    const Body& body = state_->bodies[there];
    c.other = {TileRole::ball, body.origin.cell, body.id, members_[there].moving.at(time_)};
  }
  c.ti = time_ / part_;
  c.move = move;
  c.normal = normal;
  c.touch = member.moving.path.place;
  c.handled = true;
  c.impulse = std::max(met.touch.impulse, 0.0);
  c.after = inertias_[static_cast<std::size_t>(place)].velocity * (part_ - time_);
}

}  // namespace talus
