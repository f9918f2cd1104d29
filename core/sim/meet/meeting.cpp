// A step from event to event.
#include "meeting.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "../event_notes.h"
#include "../lerp.h"
#include "../mouse.h"
#include "../step_limits.h"

namespace talus {
namespace {

// A body that the mouse holds is so many times as heavy.
constexpr double kHeldWeight = 1e6;

// What holds all places of a path between its time and another one.
Rect swept_by(const MovingBox& box, double to) {
  const Rect a = box.at(box.path.time), b = box.at(to);
  Rect all{std::min(a.x, b.x), std::min(a.y, b.y), 0, 0};
  all.w = std::max(a.x, b.x) + a.w - all.x;
  all.h = std::max(a.y, b.y) + a.h - all.y;
  // A parabola is at most so far beside its chord.
  const double s = to - box.path.time;
  const double x = std::abs(box.path.pull.x) * (s * s / 8), y = std::abs(box.path.pull.y) * (s * s / 8);
  const double slack = touch_slack(all, all);
  return {all.x - x - slack, all.y - y - slack, all.w + 2 * (x + slack), all.h + 2 * (y + slack)};
}

// by: radians
void turn(Body& body, double spin, double by) {
  constexpr double kTurn = 6.283185307179586476925286766559;
  const double angle = body.turn + by;
  body.spin = std::clamp(spin, -kMaxCoordinate, kMaxCoordinate) + 0.0;
  body.turn = angle - kTurn * std::floor(angle / kTurn);
}

}  // namespace

Meeting::Meeting(std::shared_ptr<const Scene> scene)
    : scene_(std::move(scene)),
      probe_(*scene_->ground),
      round_(*scene_->ground),
      gravity_{0, scene_->tuning.exact.gravity},
      slowest_(fall_gain(scene_->tuning)),
      slow_(1e-3 * slowest_),
      quiet_(quiet_speed(scene_->tuning, BodyRule::fall)),
      parts_(static_cast<int>(scene_->tuning.exact.substeps)),
      part_(1.0 / parts_) {}

bool Meeting::moves(const Body& body, const State& state) const {
  return traits_of(body.kind).rule == BodyRule::fall || body.id == state.grabbed;
}

std::int64_t Meeting::step(State& state, const Input& input, StepRecord* record,
                           std::vector<StepEvent>* events) {
  state_ = &state;
  record_ = record;
  step_events_ = events;
  budget_ = {kMaxStepWork};
  is_stopped_ = false;
  take(state, input);
  grid_.begin(members_.size());
  for (std::uint32_t i = 0; i < members_.size(); ++i) {
    members_[i].moving.path.pull = members_[i].pull;
    sweep(i);
    members_[i].is_swept = true;
  }
  const bool are_apart = leaves_apart_ && is_as_left(state);
  fall_asleep(state);
  part_overlaps(are_apart);
  for (int i = 0; i < parts_ && !is_stopped_; ++i) {
    started_ = i * part_;
    if (i > 0 && record_ == nullptr) wake_touched();
    run_part();
    if (i == 0 && record_ == nullptr) form_islands();
  }
  give(state);
  remember(state);
  return kMaxStepWork - budget_.left;
}

void Meeting::take(State& state, const Input& input) {
  const SharedTuning& t = scene_->tuning.shared;
  members_.resize(state.bodies.size());
  const bool has_curves = !probe_.ground().stretches().empty();
  for (std::size_t i = 0; i < members_.size(); ++i) {
    Body& body = state.bodies[i];
    const BodyTraits& traits = traits_of(body.kind);
    Member& member = members_[i];
    member = {.version = member.version};
    member.moving = {{0, body.box.position(), {}, {}}, {body.box.w, body.box.h}};
    member.moving.radius = radius_of(body.kind, member.moving.size);
    if (!moves(body, state)) continue;
    if (!body.is_clear) {
      const auto out = member.moving.is_round() ? round_.way_out(member.moving.form_at(0), budget_)
                                                : way_out(probe_.ground(), body.box, Foot::box, &budget_);
      if (out) member.moving.path.place = member.moving.path.place + *out;
    }
    member.inverse_mass = 1 / mass_of(body.kind, {body.box.w, body.box.h});
    member.friction = traits.friction;
    member.floor_bounce = traits.bounce.value_or(t.floor_bounce);
    member.wall_bounce = traits.bounce.value_or(t.wall_bounce);
    Vec2& velocity = member.moving.path.velocity;
    if (body.id == state.grabbed) {
      member.is_held = true;
      member.inverse_mass /= kHeldWeight;
      body.previous = body.box.position();
      velocity = within_limits(body.previous, drag_goal(t, body, input)) - body.previous;
      member.floor_bounce = member.wall_bounce = 0;
    } else {
      velocity = body.velocity;
      velocity.x = lerp(velocity.x, t.drift_speed, t.drift_blend);
      // The article's fall, as a pull: at once, at the start of a frame, it would give back what a bounce
      // loses.
      member.pull = gravity_.y > 0 ? gravity_ : Vec2{0, (t.fall_speed - velocity.y) * t.fall_blend};
    }
    if (member.moving.is_round()) {
      if (circles_.size() != members_.size()) circles_.resize(members_.size());
      Circle& circle = *(member.circle = &circles_[i]);
      // A disc of even density: half of its mass counts at its rim.
      circle.inverse_spin = 2 * member.inverse_mass;
      circle.spin = member.is_held ? 0 : lerp(body.spin, 0, t.drift_blend);
      circle.spin_pull = circle.turned = 0;
    }
    if (has_curves || member.moving.is_round()) {
      if (tracks_.size() != members_.size()) tracks_.resize(members_.size());
      member.track = &tracks_[i];
      member.leave_track();
    }
    member.is_steady =
        velocity == body.velocity && (member.circle == nullptr || member.circle->spin == body.spin);
    if (record_ != nullptr) record_->paths[i].goal = body.box.position() + velocity + member.pull * 0.5;
  }
}

void Meeting::run_part() {
  events_.clear();
  if (probe_.ground().has_conveyors()) belts_.assign(members_.size(), {});
  for (std::uint32_t i = 0; i < members_.size(); ++i) {
    Member& member = members_[i];
    member.moving.path.time = 0;
    member.moving.path.pull = member.is_asleep || member.is_capped ? Vec2() : member.pull;
    member.events = member.is_asleep ? rests_[i].events : 0;
    member.bounced = -1;
    member.is_spent = member.is_asleep && rests_[i].is_spent;
    if (!std::exchange(member.is_swept, false)) sweep(i);
  }
  for (std::uint32_t i = 0; i < members_.size(); ++i) {
    if (members_[i].inverse_mass == 0 || members_[i].is_asleep) continue;
    look_for_ground(i);
    look_for_pairs(i, true);
  }
  double now = 0, end = part_;
  while (true) {
    if (budget_.left <= 0) {  // from now on nobody knows what is met
      stop_early(now);
      end = now;
      break;
    }
    if (events_.empty()) break;
    std::pop_heap(events_.begin(), events_.end(), is_later);
    const Event event = events_.back();
    events_.pop_back();
    if (is_void(event)) continue;
    now = event.time;
    resolve(event);
  }
  for (Member& member : members_) {
    go_to(member, end);
    member.moving.path.time = 0;
    member.leave_track();
    if (member.circle != nullptr) member.circle->spin_pull = 0;
  }
}

void Meeting::give(State& state) {
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const Member& member = members_[i];
    if (record_ != nullptr) record_->paths[i].to = state.bodies[i].box;
    Body& body = state.bodies[i];
    const bool is_as_before = member.is_asleep && member.is_grounded == body.gait.grounded && body.is_clear;
    if (is_as_before || !member.may_have_moved()) continue;
    const FallPath& path = member.moving.path;
    const Vec2 place = within_limits(path.place, path.place);
    const Vec2 velocity = within_limits({}, path.velocity);
    body.box.x = place.x;
    body.box.y = place.y;
    // Adding 0 leaves no -0, whose bits are others.
    if (!member.is_held) body.velocity = {velocity.x + 0.0, velocity.y + 0.0};
    if (const Circle* circle = member.circle) turn(body, circle->spin, circle->turned / member.moving.radius);
    const bool stood = body.gait.grounded;
    leaves_apart_ = leaves_apart_ && !member.is_capped && !is_stopped_;
    body.gait.grounded = member.is_grounded;
    note_standing(step_events_, body, stood);
    body.is_clear = true;
    if (record_ == nullptr) continue;
    BodyPath& noted = record_->paths[i];
    noted.to = body.box;
    noted.limited = noted.limited || !(place == path.place) || !(velocity == path.velocity);
    noted.capped = noted.capped || member.is_capped;
    noted.cut_short = noted.cut_short || is_stopped_;
  }
}

// ---- Overlaps ----

// Whether nothing has changed the bodies that it moves since the last step.
bool Meeting::is_as_left(const State& state) const {
  if (rests_.size() != members_.size()) return false;
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const Body& body = state.bodies[i];
    if (members_[i].inverse_mass > 0 && !rests_[i].is_left_in(body)) return false;
  }
  return true;
}

// Bodies that begin inside of one another are moved apart, each by its share, as far as the ground lets them.
// are_apart: only those that do not move may be inside of some.
void Meeting::part_overlaps(bool are_apart) {
  std::vector<char> may_overlap(members_.size(), !are_apart);
  for (std::uint32_t i = 0; i < members_.size(); ++i) {
    if (!are_apart || members_[i].inverse_mass > 0) continue;
    if (!grid_.near(members_[i].moving.at(0), i, budget_.left, near_)) continue;
    for (const std::uint32_t other : near_) may_overlap[other] = 1;
  }
  std::vector<std::pair<std::uint32_t, Vec2>> ways;
  for (std::uint32_t i = 0; i < members_.size(); ++i) {
    if (!may_overlap[i] || members_[i].inverse_mass == 0 || members_[i].is_asleep) continue;
    const Vec2 way = way_apart(i);
    if (!(way == Vec2())) ways.emplace_back(i, way);
  }
  for (const auto& [index, way] : ways) {
    FallPath& path = members_[index].moving.path;
    members_[index].is_swept = false;
    members_[index].is_parted = true;
    if (Circle* const circle = members_[index].circle) {
      MovingBox straight = members_[index].moving;
      straight.path = {0, path.place, way, {}};
      const auto met = round_.next_meeting(straight, 1, {}, budget_, circle->ground);
      path.place = met ? met->place : path.place + way;
      continue;
    }
    const Contact<double> contact = cast_box<double>(
        probe_.ground(), {members_[index].moving.at(0), way, Foot::box}, {}, nullptr, &budget_);
    path.place = contact ? contact.position : path.place + way;
  }
  leaves_apart_ = ways.empty();
}

// px. Of several overlaps on one side the deepest counts. Bodies in one place make a pile, by their order.
Vec2 Meeting::way_apart(std::uint32_t index) {
  const Member& member = members_[index];
  const Form form = member.moving.form_at(0);
  const Rect& box = form.box;
  Vec2 least, most, pile;
  if (!grid_.near(box, index, budget_.left, near_)) return {};
  for (const std::uint32_t other : near_) {
    const Member& there = members_[other];
    const Form other_form = there.moving.form_at(0);
    const Rect& with = other_form.box;
    const Vec2 depth{std::min(box.right() - with.x, with.right() - box.x),
                     std::min(box.bottom() - with.y, with.bottom() - box.y)};
    const double least_depth = std::min(depth.x, depth.y);
    if (!(least_depth > 0) || least_depth <= touch_slack(box, with)) continue;
    Vec2 normal;
    double deep = 0;
    if (form.is_round() || other_form.is_round()) {
      const Nearness near = nearness(form, other_form, index < other);
      normal = near.normal;
      deep = -near.gap;
      if (deep <= kNearCircle) continue;  // a crowd takes small overlaps back by itself
    } else {
      const auto touching = touching_normal(form, other_form, index < other);
      if (!touching) continue;
      normal = *touching;
      deep = normal.x != 0 ? depth.x : depth.y;
    }
    // The upper one goes up all the way, as the lower one may stand on something.
    const double part = member.inverse_mass / (member.inverse_mass + there.inverse_mass);
    const bool is_free = there.inverse_mass > 0;
    const bool is_upright = std::abs(normal.y) > std::abs(normal.x);
    const double share = is_upright && is_free ? (normal.y < 0 ? 1 : 0) : part;
    const Vec2 way = normal * (share * deep);
    if (box.center() == with.center()) pile = pile + way;
    least = {std::min(least.x, way.x), std::min(least.y, way.y)};
    most = {std::max(most.x, way.x), std::max(most.y, way.y)};
  }
  return pile == Vec2() ? least + most : pile;
}

// ---- Events ----

void Meeting::stop(Member& member) {
  member.moving.path.velocity = member.moving.path.pull = {};
  member.leave_track();
  if (member.circle != nullptr) member.circle->spin = member.circle->spin_pull = 0;
}

// The work of the step is used up. What has met something, or would now, loses its speed: else the next step
// would begin with the same work, and not get any further.
void Meeting::stop_early(double now) {
  is_stopped_ = true;
  std::vector<char> stops(members_.size());
  for (std::size_t i = 0; i < members_.size(); ++i) stops[i] = members_[i].events > 0;
  for (const Event& event : events_) {
    if (event.time > now || is_void(event)) continue;
    stops[event.a] = 1;
    if (event.kind == Event::Kind::pair) stops[event.b] = 1;
  }
  for (std::size_t i = 0; i < members_.size(); ++i) {
    if (!stops[i]) continue;
    go_to(members_[i], now);
    stop(members_[i]);
  }
}

bool Meeting::is_void(const Event& event) const {
  if (members_[event.a].version != event.version_a) return true;
  return event.kind == Event::Kind::pair && members_[event.b].version != event.version_b;
}

bool Meeting::is_later(const Event& a, const Event& b) {
  const auto key = [](const Event& e) { return std::tuple(e.time, e.kind, e.place.y, e.place.x, e.a, e.b); };
  return key(a) > key(b);
}

void Meeting::push(Event event) {
  event.place = members_[event.a].moving.path.place;
  event.version_a = members_[event.a].version;
  if (event.kind == Event::Kind::pair) event.version_b = members_[event.b].version;
  events_.push_back(event);
  std::push_heap(events_.begin(), events_.end(), is_later);
}

void Meeting::sweep(std::uint32_t index) {
  Member& member = members_[index];
  member.swept = swept_by(member.moving, part_);
  budget_.left -= grid_.place(index, member.swept);
}

// A body has another path than before.
void Meeting::set_off(std::uint32_t index) {
  Member& member = members_[index];
  ++member.version;
  ++member.events;
  sweep(index);
  if (member.inverse_mass > 0) look_for_ground(index);
  look_for_pairs(index, false);
  look_for_end_of_track(index);
}

void Meeting::look_for_ground(std::uint32_t index) {
  Member& member = members_[index];
  const FallPath& path = member.moving.path;
  // Where a path turns back, its chord is cut: a cast knows chords alone.
  double to = part_;
  const auto turn = [&](double speed, double pull) {
    constexpr double kShortest = 1e-9;  // frames
    const double after = -speed / pull;
    if (speed * pull < 0 && after > kShortest && path.time + after < to) to = path.time + after;
  };
  turn(path.velocity.x, path.pull.x);
  turn(path.velocity.y, path.pull.y);
  const auto meeting = next_meeting(member, to);
  if (meeting) {
    member.ground = *meeting;
    push({.time = meeting->time, .kind = Event::Kind::ground, .a = index});
  } else if (to < part_ && to > path.time) {
    push({.time = to, .kind = Event::Kind::turn, .a = index});
  }
}

// Two bodies in the order in which their meeting is looked for. With a circle its last bit depends on it, and
// it must not depend on who looks.
std::pair<std::uint32_t, std::uint32_t> Meeting::in_order(std::uint32_t a, std::uint32_t b,
                                                          double time) const {
  if (members_[a].circle == nullptr && members_[b].circle == nullptr) return {a, b};
  const auto key = [&](std::uint32_t i) {
    const MovingBox& box = members_[i].moving;
    const Vec2 place = box.path.place_at(time);
    return std::tuple(box.radius, box.size.y, box.size.x, place.y, place.x, i);
  };
  return key(b) < key(a) ? std::pair(b, a) : std::pair(a, b);
}

void Meeting::look_for_pairs(std::uint32_t index, bool only_later) {
  const Member& member = members_[index];
  const Rect& here = member.swept;
  if (!grid_.near(here, index, budget_.left, near_)) return;
  for (const std::uint32_t other : near_) {
    const Member& there = members_[other];
    const bool looks = there.inverse_mass > 0 && !there.is_asleep;
    if (only_later && other < index && looks) continue;
    if (member.inverse_mass == 0 && there.inverse_mass == 0) continue;
    if (goes_along(member, other) || goes_along(there, index)) continue;
    --budget_.left;
    const Rect& with = there.swept;
    if (with.x > here.right() || here.x > with.right() || with.y > here.bottom() || here.y > with.bottom())
      continue;
    const double from = std::max(member.moving.path.time, there.moving.path.time);
    // Of a crowd what is left of an approach is not worth another event.
    const double still = member.is_spent && there.is_spent ? std::max(kStill, crowd_still()) : kStill;
    const auto [a, b] = in_order(index, other, from);
    const auto meeting = talus::next_meeting(members_[a].moving, members_[b].moving, from, part_, still);
    if (!meeting) continue;
    push({.time = meeting->time, .kind = Event::Kind::pair, .a = a, .b = b, .normal = meeting->normal});
  }
}

}  // namespace talus
