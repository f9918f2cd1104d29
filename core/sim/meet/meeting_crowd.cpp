// Circles in a pile touch many others, and roll on all of them. Such a crowd is not solved to the end, but
// once for the rest of a part of the step.
#include "meeting.h"

#include <algorithm>
#include <cmath>

namespace talus {
namespace {

constexpr int kMaxTurns = 50;  // of ContactSet::stop()

}  // namespace

// The normal of two that touch at the time of the set. Circles that are slow to part or to meet are in it a
// little earlier: in a pile that comes to rest, each would go on to meet the others again.
std::optional<Vec2> Meeting::touching_in_set(std::uint32_t a, std::uint32_t b) {
  const Form one = form_of(a), other = form_of(b);
  if (members_[a].circle == nullptr && members_[b].circle == nullptr)
    return touching_normal(one, other, a < b);
  const Nearness near = nearness(one, other, a < b);
  if (near.gap > kNearCircle) return std::nullopt;
  if (near.gap <= touch_slack(one.box, other.box)) return near.normal;
  const auto velocity = [&](std::uint32_t i) { return members_[i].moving.path.velocity_at(time_); };
  const double speed = dot(velocity(a) - velocity(b), near.normal);
  return std::abs(speed) <= slowest_ ? std::optional(near.normal) : std::nullopt;
}

// px: holds what may be in a set with a body.
Rect Meeting::area_of_set(const Form& form) const {
  const Rect area = touch_area(form.box);
  if (circles_.empty()) return area;
  const double more = 2 * kNearCircle;
  return {area.x - more, area.y - more, area.w + 2 * more, area.h + 2 * more};
}

// 0 for a turn.
double Meeting::hit_of(const Event& event) const {
  if (event.kind == Event::Kind::turn) return 0;
  const Member &a = members_[event.a], &b = members_[event.b];
  const bool is_pair = event.kind == Event::Kind::pair;
  const Vec2 velocity = a.moving.path.velocity_at(time_);
  const Vec2 speed = is_pair ? velocity - b.moving.path.velocity_at(time_) : velocity;
  return std::abs(dot(speed, is_pair ? event.normal : a.ground.normal));
}

// Whether a circle meets something so slowly that the rest of a pile need not give way.
bool Meeting::is_gentle(const Event& event) const {
  const bool is_pair = event.kind == Event::Kind::pair;
  if (!members_[event.a].moving.is_round() && !(is_pair && members_[event.b].moving.is_round())) return false;
  return hit_ <= slowest_;
}

// Whether circles touch so many others, or meet so often, that they are not solved to the end.
bool Meeting::is_crowd() const {
  if (circles_.empty()) return false;
  constexpr int kMax = 6;
  int pairs = 0;
  for (const Met& met : met_) pairs += met.touch.b != Touch::kGround && met.is_round() && !met.is_apart;
  if (pairs > kMax || reach_ < kAll) return true;
  if (pairs == 0) return false;
  return std::any_of(set_.begin(), set_.end(), [&](std::uint32_t index) {
    const Member& member = members_[index];
    return member.is_inner && member.moving.is_round() && member.events > kMaxSlowEvents && !(slowest_ == 0);
  });
}

// Each contact bounces as if it were alone.
void Meeting::bounce_crowd() {
  for (std::size_t i = 0; i < set_.size(); ++i) before_[i] = inertias_[i].velocity;
  chosen_.clear();
  chosen_at_.clear();
  bool bounces = false;
  for (std::size_t i = 0; i < met_.size(); ++i) {
    if (met_[i].is_apart) continue;
    Touch& touch = chosen_.emplace_back(met_[i].touch);
    chosen_at_.push_back(i);
    const double speed = -ContactSet::speed(touch, inertias_, touch.normal), bounce = bounce_of(touch);
    if (!(speed > slowest_) || speed * bounce <= slowest_on(touch)) continue;
    touch.room = -bounce * speed;
    bounces = true;
  }
  if (!bounces) return;
  contacts_.stop(inertias_, chosen_, crowd_left(), kMaxTurns);
  budget_.left -= contacts_.take_work();
  for (std::size_t i = 0; i < chosen_.size(); ++i) met_[chosen_at_[i]].touch.impulse = chosen_[i].pressure;
}

// What has happened in a crowd since it was solved as a whole is looked at near by at first.
int Meeting::first_reach(const Event& event) const {
  constexpr int kFirst = 2;
  const bool is_pair = event.kind == Event::Kind::pair;
  const bool is_spent = members_[event.a].is_spent || (is_pair && members_[event.b].is_spent);
  return is_spent && slowest_ > 0 ? kFirst : kAll;
}

// Whether a part of a crowd was solved that moves what is around it. Then more of it is to be solved.
bool Meeting::reaches_further() {
  constexpr int kMaxReach = 8;
  constexpr double kShare = 1.0 / 64;
  if (reach_ == kAll) return false;
  const double most = std::max(crowd_still(), kShare * hit_);
  for (std::size_t i = 0; i < set_.size(); ++i) {
    const Vec2 change = inertias_[i].velocity - before_[i];
    if (is_inner(i) || !(dot(change, change) > most * most)) continue;
    reach_ = reach_ < kMaxReach ? 2 * reach_ : kAll;
    return true;
  }
  return false;
}

void Meeting::spend_pulls() {
  leaves_apart_ = false;
  for (std::size_t i = 0; i < set_.size(); ++i) {
    if (is_inner(i)) members_[set_[i]].is_spent = true;
  }
}

// Adds the ground that a circle would come to at once by its pull, beside what it touches.
void Meeting::add_near_ground(std::size_t place) {
  Form form = members_[set_[place]].moving.form_at(time_);
  form.box = {form.box.x - kTouching, form.box.y - kTouching, form.box.w + 2 * kTouching,
              form.box.h + 2 * kTouching};
  form.radius += kTouching;
  for (const SideTouch& touch : round_.touched(form, budget_)) {
    if (dot(inertias_[place].velocity, touch.near.normal) <= 0) add_side(place, touch);
  }
}

// Gives bodies what their pulls would give them in the rest of the part, in frames.
// What is around a whole crowd is like walls; around a part of one it gives way, which shows how far it
// reaches.
void Meeting::give_pulls(double rest) {
  for (std::size_t i = 0; i < set_.size(); ++i) {
    Inertia& body = inertias_[i];
    if (!is_inner(i)) {
      if (reach_ == kAll) body.inverse_mass = body.inverse_spin = 0;
      continue;
    }
    Member& member = members_[set_[i]];
    if (!member.is_spent) body.velocity = body.velocity + member.pull * rest;
    body.pull = {};
    body.spin_pull = 0;
    member.moving.is_round() ? add_near_ground(i) : void(probe(i, body.velocity, -kStillOnGround));
  }
}

// Circles that press on one another, and roll, would meet again and again. They get what their pulls would
// give them in the rest of the part at once, and go straight on: two that do not come nearer then never do.
void Meeting::move_on() {
  const double rest = part_ - time_;
  give_pulls(rest);
  chosen_.clear();
  for (const Met& met : met_) {
    chosen_.push_back(met.touch);
    constexpr double kMargin = 1e-8;  // px
    constexpr double kBack = 0.25;    // share of an overlap that a frame takes back
    double& room = chosen_.back().room;
    const double gap = met.is_round() ? side_of(met).near.gap : 0;
    if (gap > kMargin && rest > 0) room = (gap - kMargin) / rest;
    if (gap < -kMargin) room = kBack * gap;
  }
  contacts_.stop(inertias_, chosen_, crowd_left(), kMaxTurns);
  constexpr int kMaxTimes = 8, kTurnsAgain = 12;
  for (int i = 0; i < kMaxTimes && stick(); ++i)
    contacts_.stop(inertias_, chosen_, crowd_left(), kTurnsAgain);
  budget_.left -= contacts_.take_work();
  for (std::size_t i = 0; i < met_.size(); ++i) {
    const Touch& touch = met_[i].touch;
    met_[i].touch.pressure = chosen_[i].pressure;
    if (touch.b != Touch::kGround) continue;
    Vec2& velocity =
        inertias_[static_cast<std::size_t>(touch.a)].velocity;  // nothing of the ground gives way
    velocity = velocity - touch.normal * std::min(0.0, dot(velocity, touch.normal) + chosen_[i].room);
  }
}

// Bodies of a crowd that hardly moved, and would hardly move, come to rest, and stop the others. Returns
// whether there are both. What is left of a load that has not come through a pile yet would move it for ever.
bool Meeting::stick() {
  constexpr double kShare = 1.0 / 8;
  bool sticks = false;
  for (std::size_t i = 0; i < set_.size(); ++i) {
    Inertia& body = inertias_[i];
    const double most = kShare * slowest_;
    if (!is_inner(i) || body.inverse_mass == 0 || dot(before_[i], before_[i]) > most * most) continue;
    if (dot(body.velocity, body.velocity) > most * most || std::abs(body.spin) > most) continue;
    body.velocity = {};
    body.spin = 0;
    body.inverse_mass = body.inverse_spin = 0;
    sticks = true;
  }
  if (!sticks) return false;
  for (std::size_t i = 0; i < set_.size(); ++i) {
    if (is_inner(i) && inertias_[i].inverse_mass > 0) return true;
  }
  return false;
}

}  // namespace talus
