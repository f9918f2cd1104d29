// Bodies that rest cost next to nothing. An island is all bodies that were solved with one another, directly
// or through others. Where a step has changed none of them, the next one would change nothing either: the
// island sleeps until something touches it. So no bit depends on sleep.
#include "meeting.h"

#include <algorithm>
#include <numeric>

namespace talus {

// Called before a step.
void Meeting::fall_asleep(const State& state) {
  const std::size_t count = state.bodies.size();
  // A record tells of each contact, also of those that change nothing.
  if (rests_.size() != count || record_ != nullptr) {
    rests_.assign(count, {});
    islands_.clear();
  }
  solved_.clear();
  solved_ends_.clear();
  for (Island& island : islands_) {
    island.is_same = island.is_same && all_of(island, [&](std::uint32_t index) {
                       const Body& body = state.bodies[index];
                       return rests_[index].is_left_in(body) && !members_[index].is_held;
                     });
  }
  wake_touched();
  for (std::size_t i = 0; i < count; ++i) {
    Member& member = members_[i];
    if (!member.is_asleep) {
      rests_[i].island = 0;
      continue;
    }
    member.moving.path.velocity = {};
    member.is_grounded = state.bodies[i].gait.grounded;
  }
  keep_sleeping_islands();
}

void Meeting::keep_sleeping_islands() {
  std::vector<std::uint32_t> kept;
  std::vector<std::uint32_t> number(islands_.size() + 1, 0);
  std::size_t count = 0;
  for (std::size_t k = 0; k < islands_.size(); ++k) {
    const Island island = islands_[k];
    if (!island.is_same) continue;
    const std::size_t first = kept.size();
    kept.insert(kept.end(), in_islands_.begin() + static_cast<std::ptrdiff_t>(island.first),
                in_islands_.begin() + static_cast<std::ptrdiff_t>(island.end));
    islands_[count++] = {first, kept.size()};
    number[k + 1] = static_cast<std::uint32_t>(count);
  }
  islands_.resize(count);
  in_islands_ = std::move(kept);
  for (Rest& rest : rests_) rest.island = number[rest.island];
}

template <class Holds>
bool Meeting::all_of(const Island& island, Holds holds) const {
  return std::all_of(in_islands_.begin() + static_cast<std::ptrdiff_t>(island.first),
                     in_islands_.begin() + static_cast<std::ptrdiff_t>(island.end), holds);
}

// Says which bodies sleep in a part of a step.
void Meeting::wake_touched() {
  const auto find_sleepers = [&] {
    for (std::uint32_t i = 0; i < members_.size(); ++i) {
      const std::uint32_t island = rests_[i].island;
      members_[i].is_asleep = island != 0 && islands_[island - 1].is_same && members_[i].inverse_mass > 0;
    }
  };
  find_sleepers();
  time_ = 0;
  for (std::uint32_t i = 0; !islands_.empty() && i < members_.size(); ++i) {
    if (!members_[i].is_asleep) wake_beside(i);
  }
  find_sleepers();
}

// Wakes the islands that a body touches without being in them.
void Meeting::wake_beside(std::uint32_t index) {
  const Form form = members_[index].moving.form_at(0);
  if (!grid_.near(area_of_set(form), index, budget_.left, near_)) return;
  for (const std::uint32_t other : near_) {
    if (!members_[other].is_asleep) continue;
    Island& island = islands_[rests_[other].island - 1];
    if (!island.is_same) continue;
    if (!touching_in_set(index, other)) continue;
    island.is_same = !all_of(island, [&](std::uint32_t member) { return member != index; });
  }
}

// Called for each set that was solved.
void Meeting::remember_set() {
  for (std::size_t i = 0; i < set_.size(); ++i) {
    if (!is_inner(i)) continue;
    Member& member = members_[set_[i]];
    if (const std::uint32_t island = rests_[set_[i]].island; island != 0)
      islands_[island - 1].is_same = false;
    member.is_asleep = false;
    member.is_late = member.is_late || time_ > 0;
  }
  if (started_ > 0) return;
  solved_.insert(solved_.end(), set_.begin(), set_.end());
  solved_ends_.push_back(solved_.size());
}

// Whether a body is after the first part of a step as it was before it, and rests.
bool Meeting::is_unchanged(std::uint32_t index) const {
  const Member& member = members_[index];
  const Body& body = state_->bodies[index];
  if (!member.may_have_moved()) return rests_[index].is_of(body);
  const FallPath& path = member.moving.path;
  return !member.is_late && !member.is_parted && !member.is_capped && !member.is_held &&
         (member.is_steady || parts_ == 1) && path.place == body.box.position() &&
         path.velocity == body.velocity && path.velocity == Vec2() &&
         (member.circle == nullptr || member.circle->spin == 0) && body.spin == 0;
}

// Called after the first part of a step: joins what was solved together to islands.
void Meeting::form_islands() {
  if (solved_ends_.empty()) return;
  std::vector<std::uint32_t> leader(members_.size());
  std::iota(leader.begin(), leader.end(), 0u);
  const auto leader_of = [&](std::uint32_t i) {
    while (leader[i] != i) i = leader[i] = leader[leader[i]];
    return i;
  };
  const auto moves = [&](std::uint32_t i) { return members_[i].may_have_moved(); };
  const auto for_sets = [&](auto use) {
    for (std::size_t k = 0, first = 0; k < solved_ends_.size(); first = solved_ends_[k++]) {
      const std::span set(solved_.data() + first, solved_ends_[k] - first);
      const auto one = std::find_if(set.begin(), set.end(), moves);
      if (one != set.end()) use(set, *one);
    }
  };
  for_sets([&](auto set, std::uint32_t one) {
    for (const std::uint32_t index : set) {
      if (moves(index)) leader[leader_of(index)] = leader_of(one);
    }
  });
  // What does not move may be of several islands, and joins none.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> found;  // leader, index
  for_sets([&](auto set, std::uint32_t one) {
    for (const std::uint32_t index : set) found.emplace_back(leader_of(one), index);
  });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  for (auto first = found.begin(); first != found.end();) {
    const auto end = std::find_if(first, found.end(), [&](auto& f) { return f.first != first->first; });
    const bool is_same = std::all_of(first, end, [&](auto& f) { return is_unchanged(f.second); });
    const std::size_t begins = in_islands_.size();
    for (; first != end; ++first) {
      if (!is_same) continue;
      in_islands_.push_back(first->second);
      if (!moves(first->second)) continue;
      rests_[first->second].island = static_cast<std::uint32_t>(islands_.size() + 1);
      rests_[first->second].events = members_[first->second].events;
      rests_[first->second].is_spent = members_[first->second].is_spent;
    }
    if (is_same) islands_.push_back({begins, in_islands_.size()});
  }
}

void Meeting::remember(const State& state) {
  for (std::size_t i = 0; i < members_.size(); ++i) {
    rests_[i].box = state.bodies[i].box;
    rests_[i].velocity = state.bodies[i].velocity;
  }
}

}  // namespace talus
