// Which bodies touch at the time of an event.
#include "meeting.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace talus {
namespace {

// Of a large pile only so many bodies are solved at once. The ones that touch them go on as they do until
// they are solved themselves, or are hit.
constexpr std::size_t kMaxInner = 16;
constexpr std::size_t kMaxCircles = 1024;  // the same for circles, each of which lets four more boxes in
// An impact goes on through at most so many; the others are like walls to it.
constexpr std::size_t kMaxShaken = 32;
// Bodies inside of one another may touch by the thousand. A set has so many contacts of two bodies at most.
constexpr std::size_t kMaxPairs = 256;
constexpr std::size_t kMaxPairsOfCircles = 4096;

}  // namespace

// By their places, so that nothing depends on the order of the bodies.
void Meeting::sort_by_place(std::span<std::uint32_t> indices) const {
  std::sort(indices.begin(), indices.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto key = [&](std::uint32_t i) {
      const MovingBox& box = members_[i].moving;
      return std::tuple(box.path.place.y, box.path.place.x, box.size.y, box.size.x, i);
    };
    return key(a) < key(b);
  });
}

// Finds all bodies that touch those of the event, or one that does, and where.
void Meeting::gather(const Event& event) {
  for (const std::uint32_t index : set_) members_[index].place_in_set = -1;
  set_.clear();
  met_.clear();
  sides_.clear();
  pairs_.clear();
  join(event.a, 0);
  if (event.kind == Event::Kind::pair) join(event.b, 0);
  hit_ = hit_of(event);
  is_gentle_ = is_gentle(event);
  sort_by_place(shaken_);
  for (const std::uint32_t index : shaken_) join(index, 0);
  const std::size_t given = set_.size();
  std::size_t inner = 0;
  std::size_t circles = 0;  // of those
  bool is_cut = false;
  for (std::size_t i = 0; i < set_.size(); ++i) {
    Member& member = members_[set_[i]];
    const bool is_solved = member.is_cut && member.events > 0 && member.moving.path.time == time_;
    const std::size_t most = member.moving.is_round() ? kMaxCircles : kMaxInner + 4 * circles;
    const bool is_reached = i < given || member.depth <= reach_;
    const bool has_room =
        i < given ||
        (is_reached && (member.moving.is_round() ? circles : inner - circles) < most && !is_solved);
    member.is_inner = has_room && member.inverse_mass > 0;
    is_cut = is_cut || (is_reached && !has_room);
    if (!member.is_inner) continue;
    ++inner;
    circles += member.moving.is_round();
    look_around(i, event);
  }
  for (const std::uint32_t index : set_) {
    Member& member = members_[index];
    if (!member.is_inner) continue;
    member.is_cut = is_cut;
    go_to(member, time_);
    member.leave_track();
  }
  sort_by_place(set_);
  inertias_.clear();
  before_.resize(set_.size());
  for (std::size_t i = 0; i < set_.size(); ++i) {
    Member& member = members_[set_[i]];
    const FallPath& path = member.moving.path;
    member.place_in_set = static_cast<int>(i);
    // One that rests, and is not solved yet, is going to rest on.
    const bool may_rest = member.events == 0 && path.velocity == Vec2();
    const Vec2 pull = is_inner(i) ? (member.is_spent ? Vec2() : member.pull) : may_rest ? Vec2() : path.pull;
    const bool is_wall = !is_inner(i) && (shaken_.size() >= kMaxShaken || (is_gentle_ && reach_ == kAll));
    Inertia& body = inertias_.emplace_back();
    body.velocity = path.velocity_at(time_);
    body.pull = pull;
    body.inverse_mass = is_wall ? 0 : member.inverse_mass;
    const Circle* circle = member.circle;
    if (circle == nullptr) continue;
    body.spin = circle->spin + circle->spin_pull * (time_ - path.time);
    body.spin_pull = is_inner(i) ? 0 : circle->spin_pull;
    body.inverse_spin = is_wall ? 0 : circle->inverse_spin;
  }
  add_pairs(event);
}

// depth: as Member::depth.
void Meeting::join(std::uint32_t index, int depth) {
  if (members_[index].place_in_set >= 0) return;
  members_[index].place_in_set = static_cast<int>(set_.size());
  members_[index].depth = depth;
  set_.push_back(index);
}

// Joins what touches a body of the set.
void Meeting::look_around(std::size_t place, const Event& event) {
  const std::uint32_t index = set_[place];
  const Form form = form_of(index);
  if (!grid_.near(area_of_set(form), index, budget_.left, near_)) return;
  sort_by_place(near_);
  for (const std::uint32_t other : near_) {
    const int known = members_[other].place_in_set;
    if (known >= 0 && known < static_cast<int>(place) && members_[other].is_inner) continue;
    --budget_.left;
    // Two corners meet on the way alone.
    if (!event.is_pair_of(index, other) && !touching_in_set(index, other)) continue;
    if (pairs_.size() == (form.is_round() ? kMaxPairsOfCircles : kMaxPairs)) return;
    pairs_.emplace_back(index, other);
    join(other, members_[index].depth + 1);
  }
}

void Meeting::add_pairs(const Event& event) {
  const auto place = [&](std::uint32_t index) { return members_[index].place_in_set; };
  for (auto& [a, b] : pairs_) {
    if (place(a) > place(b)) std::swap(a, b);
  }
  std::sort(pairs_.begin(), pairs_.end(), [&](const auto& a, const auto& b) {
    return std::pair(place(a.first), place(a.second)) < std::pair(place(b.first), place(b.second));
  });
  for (const auto& [a, b] : pairs_) {
    const auto normal = touching_in_set(a, b);
    if (!normal && !event.is_pair_of(a, b)) continue;
    Met& met = met_.emplace_back();
    met.touch.a = place(a);
    met.touch.b = place(b);
    met.touch.normal = normal ? *normal : a == event.a ? event.normal : event.normal * -1;
    met.touch.friction = std::sqrt(members_[a].friction * members_[b].friction);
    if (members_[a].circle == nullptr && members_[b].circle == nullptr) continue;
    met.touch.slow = slow_;
    met.side = static_cast<int>(sides_.size());
    sides_.push_back({{}, nearness(form_of(a), form_of(b), a < b)});
    met.is_apart = sides_.back().near.gap > kTouching;
  }
}

// Whether an impact has moved bodies whose own neighbours are not in the set. Then they are to be.
bool Meeting::shakes_more() {
  const std::size_t before = shaken_.size();
  if (before >= kMaxShaken) return false;
  for (std::size_t i = 0; i < set_.size(); ++i) {
    const Member& member = members_[set_[i]];
    const bool is_moved = !(inertias_[i].velocity == before_[i]);
    if (!member.is_inner && member.inverse_mass > 0 && is_moved) shaken_.push_back(set_[i]);
  }
  return shaken_.size() > before;
}

}  // namespace talus
