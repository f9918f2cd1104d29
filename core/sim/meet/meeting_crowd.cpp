// Circles in a pile touch many others, and roll on all of them. Such a crowd is not solved to the end, but
// once for the rest of a part of the step.
#include "meeting.h"

#include <algorithm>
#include <cmath>

namespace talus {

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

// Whether a circle meets something so slowly that the rest of a pile need not give way.
bool Meeting::is_gentle(const Event& event) const {
  const Member &a = members_[event.a], &b = members_[event.b];
  const bool is_pair = event.kind == Event::Kind::pair;
  if (!a.moving.is_round() && !(is_pair && b.moving.is_round())) return false;
  if (event.kind == Event::Kind::turn) return true;
  const Vec2 velocity = a.moving.path.velocity_at(time_);
  const Vec2 speed = is_pair ? velocity - b.moving.path.velocity_at(time_) : velocity;
  return std::abs(dot(speed, is_pair ? event.normal : a.ground.normal)) <= slowest_;
}

// Whether circles touch so many others, or meet so often, that they are not solved to the end.
bool Meeting::is_crowd() const {
  if (circles_.empty()) return false;
  constexpr int kMost = 6;
  int pairs = 0;
  for (const Met& met : met_) pairs += met.touch.b != Touch::kGround && met.is_round() && !met.is_apart;
  if (pairs > kMost) return true;
  if (pairs == 0) return false;
  return std::any_of(set_.begin(), set_.end(), [&](std::uint32_t index) {
    const Member& member = members_[index];
    return member.is_inner && member.moving.is_round() && member.events > kMostSlowEvents && !(slowest_ == 0);
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
  contacts_.stop(inertias_, chosen_);
  budget_.left -= contacts_.take_work();
  for (std::size_t i = 0; i < chosen_.size(); ++i) met_[chosen_at_[i]].touch.impulse = chosen_[i].pressure;
}

// Circles that press on one another, and roll, would meet again and again. They get what their pulls would
// give them in the rest of the part at once, and go straight on: two that do not come nearer then never do.
void Meeting::move_on() {
  const double rest = part_ - time_;
  for (std::size_t i = 0; i < set_.size(); ++i) {
    Inertia& body = inertias_[i];
    if (!is_inner(i)) {
      body.inverse_mass = body.inverse_spin = 0;
      continue;
    }
    Member& member = members_[set_[i]];
    if (!member.is_spent) body.velocity = body.velocity + member.pull * rest;
    body.pull = {};
    body.spin_pull = 0;
    member.is_spent = true;
    if (!member.moving.is_round()) probe(i, body.velocity, -kStillOnGround);
  }
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
  contacts_.stop(inertias_, chosen_);
  if (stick()) contacts_.stop(inertias_, chosen_);
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
// whether there are both.
bool Meeting::stick() {
  constexpr double kShare = 1.0 / 8;
  bool sticks = false;
  for (std::size_t i = 0; i < set_.size(); ++i) {
    Inertia& body = inertias_[i];
    const double most = kShare * slowest_;
    if (!is_inner(i) || dot(before_[i], before_[i]) > most * most) continue;
    if (dot(body.velocity, body.velocity) > most * most || std::abs(body.spin) > most) continue;
    body.velocity = {};
    body.spin = 0;
    body.inverse_mass = body.inverse_spin = 0;
    sticks = true;
  }
  return sticks && std::any_of(inertias_.begin(), inertias_.end(),
                               [](const Inertia& body) { return body.inverse_mass > 0; });
}

}  // namespace talus
