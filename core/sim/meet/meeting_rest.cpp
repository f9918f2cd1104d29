// Bodies that rest cost next to nothing. A set of them that was solved at the beginning of the last step, and
// that nothing has changed since, would be solved alike: it sleeps. So no bit depends on sleep.
#include "meeting.h"

#include <algorithm>

namespace talus {

void Meeting::fall_asleep(const State& state) {
  const std::size_t count = state.bodies.size();
  // A record tells of each contact, also of those that change nothing.
  if (rests_.size() != count || record_ != nullptr) {
    rests_.assign(count, {});
    sets_.clear();
  }
  for (RestingSet& set : sets_) {
    for (std::size_t i = set.first; i < set.end && set.is_same; ++i) {
      const std::uint32_t index = in_sets_[i];
      const Body& body = state.bodies[index];
      const Rest& rest = rests_[index];
      set.is_same = rest.is_of(body) && body.is_clear && !members_[index].is_held;
    }
  }
  wake_touched();
  for (std::size_t i = 0; i < count; ++i) {
    Member& member = members_[i];
    if (!member.is_asleep) {
      rests_[i].set = 0;
      continue;
    }
    member.moving.path.velocity = {};
    member.is_grounded = state.bodies[i].gait.grounded;
  }
  // The sets that still sleep stay, the others begin anew.
  std::vector<std::uint32_t> kept;
  std::vector<std::uint32_t> number(sets_.size() + 1, 0);
  std::size_t sets = 0;
  for (std::size_t k = 0; k < sets_.size(); ++k) {
    if (!sets_[k].is_same) continue;
    const std::size_t first = kept.size();
    kept.insert(kept.end(), in_sets_.begin() + static_cast<std::ptrdiff_t>(sets_[k].first),
                in_sets_.begin() + static_cast<std::ptrdiff_t>(sets_[k].end));
    sets_[sets++] = {first, kept.size(), true, sets_[k].is_cut};
    number[k + 1] = static_cast<std::uint32_t>(sets);
  }
  sets_.resize(sets);
  in_sets_ = std::move(kept);
  for (Rest& rest : rests_) rest.set = number[rest.set];
}

// A set wakes if something new touches it. Which bodies of a large pile are solved together depends on all of
// it, so that it sleeps as a whole or not at all.
void Meeting::wake_touched() {
  const auto is_in = [&](std::uint32_t index) {
    const std::uint32_t set = rests_[index].set;
    return set != 0 && sets_[set - 1].is_same && members_[index].inverse_mass > 0;
  };
  const auto find_sleepers = [&] {
    for (std::uint32_t i = 0; i < members_.size(); ++i) members_[i].is_asleep = is_in(i);
  };
  find_sleepers();
  for (std::uint32_t i = 0; !sets_.empty() && i < members_.size(); ++i) {
    if (!members_[i].is_asleep) wake_beside(i);
  }
  bool has_changed = true;
  while (has_changed) {
    has_changed = false;
    for (RestingSet& set : sets_) {
      for (std::size_t i = set.first; i < set.end && set.is_same && set.is_cut; ++i) {
        const std::uint32_t index = in_sets_[i];
        if (members_[index].inverse_mass == 0 || is_in(index)) continue;
        set.is_same = false;
        has_changed = true;
      }
    }
  }
  find_sleepers();
}

// Wakes the sets that a body touches without being in them.
void Meeting::wake_beside(std::uint32_t index) {
  const Rect box = members_[index].moving.at(0);
  if (!grid_.near(touch_area(box), index, budget_.left, near_)) return;
  for (const std::uint32_t other : near_) {
    if (!members_[other].is_asleep) continue;
    RestingSet& set = sets_[rests_[other].set - 1];
    if (!touching_normal(box, members_[other].moving.at(0), index < other)) continue;
    const auto first = in_sets_.begin() + static_cast<std::ptrdiff_t>(set.first);
    const auto end = in_sets_.begin() + static_cast<std::ptrdiff_t>(set.end);
    if (std::find(first, end, index) == end) set.is_same = false;
  }
}

// Called for each set that was solved.
void Meeting::remember_set() {
  const bool is_first = time_ == 0 && started_ == 0 && record_ == nullptr;
  const bool is_cut =
      std::any_of(set_.begin(), set_.end(), [&](std::uint32_t i) { return members_[i].is_cut; });
  if (is_first) sets_.push_back({in_sets_.size(), in_sets_.size() + set_.size(), true, is_cut});
  for (std::size_t i = 0; i < set_.size(); ++i) {
    if (is_first) in_sets_.push_back(set_[i]);
    if (!is_inner(i)) continue;
    Rest& rest = rests_[set_[i]];
    if (rest.set != 0) sets_[rest.set - 1].is_same = false;  // it was solved twice
    rest.set = is_first && rest.set == 0 ? static_cast<std::uint32_t>(sets_.size()) : 0;
    members_[set_[i]].is_asleep = false;
  }
}

void Meeting::remember(const State& state) {
  std::vector<char> is_same(members_.size());
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const Body& body = state.bodies[i];
    Rest& rest = rests_[i];
    is_same[i] = rest.is_of(body) && !members_[i].is_capped;
    rest.box = body.box;
    rest.velocity = body.velocity;
  }
  for (RestingSet& set : sets_) {
    for (std::size_t i = set.first; i < set.end && set.is_same; ++i) set.is_same = is_same[in_sets_[i]] != 0;
  }
}

}  // namespace talus
