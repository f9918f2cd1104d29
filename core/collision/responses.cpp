// How a mover continues after a contact: check() and move(), the built-in responses and the user's own.
#include <cassert>
#include <cmath>

#include <talus/collision/world.h>
#include "world_impl.h"

namespace talus {
namespace {

// A bounce between near walls, or a user's response, may go on for ever. After this many legs the mover stays
// where its last contact put it, and the contacts show that.
constexpr std::size_t kMaxLegs = 64;
// Only unusual work of these first legs of a check is charged.
constexpr std::size_t kFreeLegs = 16;

// Whether the goal lies on the free side of the surface, as it may after an overlap was left.
bool leads_away(const Collision& hit, Vec2 goal) {
  return (goal.x - hit.touch.x) * hit.normal.x + (goal.y - hit.touch.y) * hit.normal.y >= 0;
}

Vec2 slide(const Collision& hit, Vec2 goal) {
  return hit.normal.x != 0 ? Vec2{hit.touch.x, goal.y} : Vec2{goal.x, hit.touch.y};
}

Vec2 bounce(const Collision& hit, Vec2 goal) {
  const Vec2 rest = goal - hit.touch;
  return hit.touch + (hit.normal.x == 0 ? Vec2{rest.x, -rest.y} : Vec2{-rest.x, rest.y});
}

}  // namespace

// A check chooses the response to an item either by the user's function...
struct ByFilter {
  static constexpr bool kIsTable = false;
  World::Filter filter;
  Response operator()(ItemId mover, ItemId other, std::size_t) const { return filter(mover, other); }
};

// ...or by a table. The table may be read at any time, as reading it has no effect.
struct ByGroup {
  static constexpr bool kIsTable = true;
  const World::GroupResponses& responses;
  Response operator()(ItemId, ItemId, std::size_t group) const { return responses[group]; }
};

// One check of one mover. It marks the items that it has met and removes the marks at its end, since a user's
// response may start a check, too.
template <class Choice>
class World::Checker {
 public:
  Checker(const World& world, ItemId item, Rect start, Choice choice, std::vector<Collision>& hits)
      : world_(world),
        impl_(*world.impl_),
        item_(item),
        self_(impl_.slot_of(item)),
        start_(start),
        choice_(choice),
        hits_(hits),
        near_(impl_.nears),
        first_visit_(impl_.visits.size()) {
    ++impl_.depth;
    impl_.gave_up = false;
    hits_.clear();
  }
  ~Checker() {
    for (; impl_.visits.size() > first_visit_; impl_.visits.pop_back()) {
      const Impl::Visit& visit = impl_.visits.back();
      impl_.items[visit.slot].visited = visit.previous;
    }
    --impl_.depth;
  }
  Checker(const Checker&) = delete;
  Checker& operator=(const Checker&) = delete;

  Vec2 run(Vec2 goal) { return impl_.mode == Mode::robust ? robust(goal) : faithful(goal); }

 private:
  // The filter, except for items that this check has met. It copies what it needs, so that the loop over the
  // candidates finds it in registers.
  auto reaction() const {
    return [this, bits = seen_bits_, item = item_, choice = choice_](const CellEntry& entry) {
      const ItemId other = entry.id();
      if ((bits & bit(other.index)) && seen(other)) return Response::ignore;
      return choice(item, other, entry.group());
    };
  }
  bool seen(ItemId item) const { return impl_.items[item.index - 1].visited == impl_.depth; }
  static std::uint64_t bit(std::uint32_t index) { return std::uint64_t{1} << (index & 63); }

  // bump's loop: only the first contact counts, and each item counts once.
  Vec2 faithful(Vec2 goal) {
    bool more = append_first(leg_to(start_.position(), goal));
    while (more) {
      Collision& hit = hits_.back();
      mark(hit.other);
      if (is_user(hit.response)) {
        ScratchPool<Collision>::Lease next(impl_.collisions);
        goal = respond(hit, goal, *next);
        more = !next->empty() && may_look(leg_to(hit.touch, goal));
        if (more) append(next->front());
      } else if (hit.response == Response::touch) {
        return hit.touch;
      } else if (hit.response == Response::cross) {
        more = append_first(leg_to(start_.position(), goal));
      } else {
        const bool moves = hit.move != Vec2{};
        // Without motion there is nothing to mirror: the mover is put out of the box that it overlaps.
        if (!moves && hit.response == Response::bounce) goal = hit.touch;
        goal = redirect(hit, goal, moves);
        more = append_first(leg_to(hit.touch, goal));
      }
    }
    if (!impl_.gave_up) return goal;
    hits_.clear();
    return start_.position();
  }

  // A straight part of the mover's way, up to the next contact.
  struct Leg {
    Sweep sweep;
    Rect bounds;
    CellRange cells;
  };
  Leg leg_to(Vec2 from, Vec2 goal) const {
    const Sweep sweep({from.x, from.y, start_.w, start_.h}, goal);
    const Rect bounds = swept_bounds(sweep);
    return {sweep, bounds, impl_.cells_of(bounds)};
  }

  // Whether a leg may look for contacts. If not, the check gives up.
  bool may_look(const Leg& leg) {
    if (hits_.size() < kFreeLegs && impl_.is_free(leg.cells)) return true;
    const std::int64_t left = impl_.most_tests - tests_;
    tests_ += impl_.charge_of(leg.cells, hits_.size() >= kFreeLegs, left);
    // Counting the entries of many cells takes one test for each cell.
    if (leg.cells.count() > Impl::kFewCells) impl_.looks += std::min(leg.cells.count(), left);
    if (tests_ > impl_.most_tests) impl_.gave_up = true;
    return !impl_.gave_up;
  }

  // Leg by leg from contact to contact. A crossed item is reported and bends nothing; a solid one ends the
  // leg, and may be met again on a later one.
  Vec2 robust(Vec2 goal) {
    Vec2 from = start_.position();
    for (std::size_t leg = 0; leg < kMaxLegs; ++leg) {
      if (!append_leg(from, goal)) return goal;
      Collision& hit = hits_.back();
      if (hit.overlaps) mark(hit.other);
      from = hit.touch;
      if (is_user(hit.response)) {
        ScratchPool<Collision>::Lease next(impl_.collisions);
        goal = respond(hit, goal, *next);
        if (next->empty()) return goal;
        from = next->front().item_rect.position();
      } else if (hit.response == Response::touch) {
        return hit.touch;
      } else {
        goal = redirect(hit, goal, !leads_away(hit, goal));
      }
    }
    return from;
  }

  // Appends the first contact of a leg. Returns false if there is none, or if it may not look for one.
  bool append_first(const Leg& leg) {
    if (!may_look(leg)) return false;
    std::uint32_t first = Impl::kNoSlot;
    Response first_response{};
    SweepContact first_contact{};
    const auto& [sweep, bounds, range] = leg;
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
      const double da = square_distance(leg.sweep.box, impl_.rects[a]);
      const double db = square_distance(leg.sweep.box, impl_.rects[b]);
      return da != db ? da < db : impl_.items[a].serial < impl_.items[b].serial;
    };
    const auto take = [&](std::uint32_t slot, Response response, const SweepContact& contact) {
      if (first == Impl::kNoSlot || contact.ti < first_contact.ti ||
          (contact.ti == first_contact.ti && before(slot, first))) {
        first = slot;
        first_response = response;
        first_contact = contact;
      }
    };
    const bool is_near = near_cells_.covers(range) && bounds.x >= near_area_.x && bounds.y >= near_area_.y &&
                         bounds.right() <= near_area_.right() && bounds.bottom() <= near_area_.bottom();
    const std::int64_t looks = impl_.looks;
    if (!is_near) look_around(bounds, range);
    if constexpr (Choice::kIsTable) {
      if (!is_near) gather(bounds, range);
      for_near_contacts(sweep, range, take);
    } else {
      impl_.for_contacts(sweep, self_, reaction(), take);
    }
    // Both count alike.
    if (is_near) {
      impl_.looks = looks + near_looks_;
    } else {
      near_looks_ = impl_.looks - looks;
    }
    if (first == Impl::kNoSlot) return false;
    append(impl_.collision(sweep, item_, first, first_response, first_contact));
    return true;
  }

  // The same as for_contacts in faithful mode. Later legs mostly stay where the first one went, so its
  // candidates are kept. A kept candidate counts only if this leg's own cells hold it, as a new look-up would
  // find.
  template <class Found>
  void for_near_contacts(const Sweep& sweep, const CellRange& range, Found found) {
    for (const Impl::Near& near : *near_) {
      const Sides difference = minkowski_difference(sweep.box, near.rect);
      if (misses(difference, sweep.d)) continue;
      if (seen_bits_ != 0 && impl_.items[near.slot].visited == impl_.depth) continue;
      SweepContact contact;
      if (!detect_faithful(sweep, difference, contact)) continue;
      if (range == near_cells_ || impl_.items[near.slot].cells.meets(range)) {
        found(near.slot, near.response, contact);
      }
    }
  }

  // The margins are far larger than what rounding adds to a leg, or bump's tolerance to a contact.
  static double margin_of(const Rect& bounds) {
    return 1e-4 + 1e-9 * (std::abs(bounds.x) + std::abs(bounds.y) + bounds.w + bounds.h);
  }

  void look_around(const Rect& bounds, const CellRange& range) {
    const double gain = margin_of(bounds);
    near_area_ = {bounds.x - gain, bounds.y - gain, bounds.w + 2 * gain, bounds.h + 2 * gain};
    near_cells_ = range;
  }

  // Keeps what a leg within near_area_ and near_cells_, of `bounds` and its cells, can hit.
  void gather(const Rect& bounds, const CellRange& range) {
    const double gain = margin_of(bounds);
    near_->clear();
    const Sides reach{bounds.x - 2 * gain, bounds.y - 2 * gain, bounds.right() + 2 * gain,
                      bounds.bottom() + 2 * gain};
    impl_.for_candidates(range, self_, [&](std::span<const CellEntry> candidates) {
      for (const CellEntry entry : candidates) {
        const Response response = choice_(item_, entry.id(), entry.group());
        if (response == Response::ignore) continue;
        const Rect& rect = impl_.rects[entry.index - 1];
        const bool is_far = rect.x > reach.right || rect.y > reach.bottom || rect.x + rect.w < reach.left ||
                            rect.y + rect.h < reach.top;
        if (!is_far) near_->push_back({rect, entry.index - 1, response});
      }
    });
  }

  // Appends the items crossed on the way to the first solid one, and that one. Returns false if none ends the
  // leg.
  bool append_leg(Vec2 from, Vec2 goal) {
    ScratchPool<Collision>::Lease contacts(impl_.collisions);
    const Sweep sweep({from.x, from.y, start_.w, start_.h}, goal);
    impl_.for_contacts(sweep, self_, reaction(),
                       [&](std::uint32_t slot, Response response, const SweepContact& contact) {
                         contacts->push_back(impl_.collision(sweep, item_, slot, response, contact));
                       });
    impl_.sort_contacts(*contacts);
    for (const Collision& contact : *contacts) {
      append(contact);
      if (contact.response != Response::cross || is_user(contact.response)) return true;
      mark(contact.other);
    }
    return false;
  }

  void append(const Collision& hit) {
    // Only a user's response that ignores its filter can report more contacts than there are items.
    if (hits_.size() > impl_.live + 64 * kMaxLegs) {
      throw WorldError("The responses report items without end.");
    }
    hits_.push_back(hit);
  }

  static Vec2 redirect(Collision& hit, Vec2 goal, bool into_surface) {
    if (into_surface) goal = hit.response == Response::slide ? slide(hit, goal) : bounce(hit, goal);
    hit.aim = goal;
    return goal;
  }

  Vec2 respond(Collision& hit, Vec2 goal, std::vector<Collision>& next) const {
    const auto unseen = [this](ItemId mover, ItemId other) {
      if (!impl_.has(other)) return choice_(mover, other, 0);
      return seen(other) ? Response::ignore : choice_(mover, other, impl_.items[other.index - 1].group);
    };
    const auto& function = impl_.responses[static_cast<std::size_t>(hit.response)].function;
    return function(world_, hit, start_, goal, unseen, next);
  }

  bool is_user(Response response) const {
    const auto index = static_cast<std::size_t>(response);
    if (index >= impl_.responses.size()) throw WorldError(unknown_response_message(std::to_string(index)));
    return static_cast<bool>(impl_.responses[index].function);
  }

  void mark(ItemId item) {
    if (!impl_.has(item) || seen(item)) return;
    std::uint32_t& visited = impl_.items[item.index - 1].visited;
    impl_.visits.push_back({item.index - 1, visited});
    visited = impl_.depth;
    seen_bits_ |= bit(item.index);
  }

  const World& world_;
  Impl& impl_;
  ItemId item_;
  std::uint32_t self_;
  Rect start_;
  Choice choice_;
  std::vector<Collision>& hits_;
  ScratchPool<Impl::Near>::Lease near_;  // what can be hit within near_area_ and near_cells_
  Rect near_area_;
  CellRange near_cells_;
  std::int64_t near_looks_ = 0;  // work of the search for the kept candidates
  std::size_t first_visit_;
  std::int64_t tests_ = 0;  // work charged so far
  // one bit for each met item, by its index modulo 64: spares most looks at the item
  std::uint64_t seen_bits_ = 0;
};

template <class Choice>
Vec2 World::run_check(ItemId item, Rect start, Vec2 goal, Choice choice, std::vector<Collision>& hits) const {
  return Checker<Choice>(*this, item, start, choice, hits).run(goal);
}

Vec2 World::check(ItemId item, Vec2 goal, Filter filter, std::vector<Collision>& hits) const {
  return run_check(item, rect(item), goal, ByFilter{filter}, hits);
}

Vec2 World::check(ItemId item, Vec2 goal, const GroupResponses& responses,
                  std::vector<Collision>& hits) const {
  return run_check(item, rect(item), goal, ByGroup{responses}, hits);
}

Vec2 World::check(Rect start, Vec2 goal, Filter filter, std::vector<Collision>& hits) const {
  impl_->check_rect(start);
  return run_check({}, start, goal, ByFilter{filter}, hits);
}

Vec2 World::check(Rect start, Vec2 goal, const GroupResponses& responses,
                  std::vector<Collision>& hits) const {
  impl_->check_rect(start);
  return run_check({}, start, goal, ByGroup{responses}, hits);
}

Vec2 World::move(ItemId item, Vec2 goal, Filter filter, std::vector<Collision>& hits) {
  const Vec2 at = check(item, goal, filter, hits);
  update(item, at);
  return at;
}

Vec2 World::move(ItemId item, Vec2 goal, const GroupResponses& responses, std::vector<Collision>& hits) {
  const Vec2 at = check(item, goal, responses, hits);
  update(item, at);
  return at;
}

Vec2 World::move(ItemId item, Vec2 goal, std::vector<Collision>& hits) {
  GroupResponses slides;
  slides.fill(Response::slide);
  return move(item, goal, slides, hits);
}

// The names are searched from 1: `ignore` is an answer of filters, not a response.
std::optional<Response> World::find_response(std::string_view name) const {
  for (std::size_t i = 1; i < impl_->responses.size(); ++i) {
    if (impl_->responses[i].name == name) return static_cast<Response>(i);
  }
  return std::nullopt;
}

Response World::add_response(std::string name, ResponseFunction function) {
  assert(impl_->depth == 0 && "a filter or response must not change the world");
  assert(function);
  if (const auto known = find_response(name)) {
    impl_->responses[static_cast<std::size_t>(*known)].function = std::move(function);
    return *known;
  }
  impl_->responses.push_back({std::move(name), std::move(function)});
  return static_cast<Response>(impl_->responses.size() - 1);
}

std::string_view World::response_name(Response response) const {
  const auto index = static_cast<std::size_t>(response);
  if (index >= impl_->responses.size()) throw WorldError(unknown_response_message(std::to_string(index)));
  return impl_->responses[index].name;
}

}  // namespace talus
