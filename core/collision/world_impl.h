// World::Impl: the inside of World, which its source files share.
#pragma once

#include <algorithm>
#include <array>
#include <deque>
#include <limits>
#include <span>

#include <talus/collision/world.h>
#include "cell_grid.h"
#include "sweep.h"

namespace talus {

// Lends vectors, which keep their memory. A callback may call back into the world, so there may be more than
// one.
template <class T>
class ScratchPool {
 public:
  class Lease {
   public:
    explicit Lease(ScratchPool& pool) : pool_(pool) {
      if (pool_.lent_ == pool_.vectors_.size()) pool_.vectors_.emplace_back();
      vector_ = &pool_.vectors_[pool_.lent_++];
      vector_->clear();
    }
    ~Lease() { --pool_.lent_; }
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;
    std::vector<T>& operator*() { return *vector_; }
    std::vector<T>* operator->() { return vector_; }

   private:
    ScratchPool& pool_;
    std::vector<T>* vector_;
  };

 private:
  std::deque<std::vector<T>> vectors_;  // a deque, since a lease points into it
  std::size_t lent_ = 0;
};

struct World::Impl {
  // What is known about an item besides its box.
  struct Item {
    CellRange cells;
    std::uint64_t serial = 0;  // order of adding, from 1; 0 in a free slot
    std::uint32_t generation = 1;
    std::uint32_t visited = 0;  // depth of the check that has met it; 0 if none has
    int group = 0;
  };
  struct NamedResponse {
    std::string name;
    ResponseFunction function;  // empty for built-in responses
  };
  struct Visit {
    std::uint32_t slot;
    std::uint32_t previous;
  };
  struct WeightedHit {
    double weight;
    std::uint64_t serial;
    SegmentHit hit;
  };
  // A candidate of a check that later legs of it may meet, too.
  struct Near {
    Rect rect;
    std::uint32_t slot;
    Response response;
  };
  static constexpr std::int64_t kFewCells = 64;
  static constexpr std::size_t kFewInCell = 256;
  static constexpr std::uint32_t kNoSlot = std::numeric_limits<std::uint32_t>::max();

  double cell_size;
  Mode mode;
  std::vector<Item> items;
  std::vector<Rect> rects;  // apart from the items: a candidate costs little more than the fetch of its box
  std::vector<std::uint32_t> free_slots;
  std::size_t live = 0;
  std::int64_t covered = 0;  // cells of all items; a cell that two items share counts twice
  std::uint64_t next_serial = 1;
  CellGrid grid;
  std::vector<NamedResponse> responses;

  std::int64_t most_tests = World::kMaxTests;
  bool gave_up = false;    // whether the last check gave up
  std::int64_t looks = 0;  // see World::looks()

  std::uint32_t depth = 0;  // of nested checks
  std::vector<Visit> visits;
  ScratchPool<Collision> collisions;
  ScratchPool<Near> nears;
  ScratchPool<std::uint32_t> slots;
  ScratchPool<WeightedHit> segment_hits;

  Impl(double cell_size, Mode mode);

  ItemId id_of(std::uint32_t slot) const { return {slot + 1, items[slot].generation}; }
  bool has(ItemId id) const {
    return id.index - 1 < items.size() && items[id.index - 1].generation == id.generation &&
           items[id.index - 1].serial != 0;
  }
  std::uint32_t slot_of(ItemId id) const { return has(id) ? id.index - 1 : kNoSlot; }
  std::uint32_t checked_slot(ItemId id) const;  // throws if there is no such item
  void check_rect(const Rect& rect) const;      // throws if it is not a usable box
  CellRange cells_of(const Rect& rect) const;   // throws if it reaches beyond kMaxCell
  void place(std::uint32_t slot, const Rect& rect);

  // A long move may sweep more cells than there are items.
  bool is_long(const CellRange& range) const {
    return range.count() > static_cast<std::int64_t>(64 + 4 * items.size());
  }

  // Calls visit(entries) with all items except `except` that have a cell in the range, each once, in batches
  // of at most kBatch.
  static constexpr std::size_t kBatch = 64;
  template <class Callback>
  void for_candidates(const CellRange& range, std::uint32_t except, Callback visit);

  // Whether testing a range of cells is free: the usual case of a few cells with a few items each.
  bool is_free(const CellRange& range) const {
    return range.count() <= kFewCells && grid.longest_list() <= kFewInCell;
  }
  // The work charged for testing a range of cells. Unless `all` is set, what is_free() tells costs nothing.
  // The work depends on the items alone, not on how they came to their places.
  std::int64_t charge_of(const CellRange& range, bool all, std::int64_t most) const {
    if (is_long(range)) return static_cast<std::int64_t>(items.size());
    const std::int64_t cells = all || range.count() > kFewCells ? range.count() : 0;
    if (cells > most || (!all && grid.longest_list() <= kFewInCell)) return cells;
    std::int64_t entries = 0;
    for (std::int32_t y = range.top; y <= range.bottom; ++y) {
      for (std::int32_t x = range.left; x <= range.right; ++x) {
        const CellGrid::List* list = grid.find(x, y);
        const std::size_t count = list != nullptr ? list->size() : 0;
        if (all || count > kFewInCell) entries += static_cast<std::int64_t>(count);
      }
    }
    return cells + entries;
  }

  // Calls found(slot, response, contact) for every contact of the sweep with an item other than `self` that
  // reaction(entry) does not ignore; in no particular order.
  template <class Reaction, class Found>
  void for_contacts(const Sweep& sweep, std::uint32_t self, Reaction reaction, Found found);

  // The order of contacts: time, then distance from the mover's start, then age.
  struct Rank {
    double ti;
    double distance;
    std::uint64_t serial;
    bool operator<(const Rank& o) const {
      if (ti != o.ti) return ti < o.ti;
      return distance != o.distance ? distance < o.distance : serial < o.serial;
    }
  };
  Rank rank(const Collision& hit) const {
    return {hit.ti, square_distance(hit.item_rect, hit.other_rect), items[hit.other.index - 1].serial};
  }
  void sort_contacts(std::vector<Collision>& hits) const {
    std::sort(hits.begin(), hits.end(),
              [this](const Collision& a, const Collision& b) { return rank(a) < rank(b); });
  }
  void sort_by_age(std::vector<ItemId>& ids) const {
    std::sort(ids.begin(), ids.end(),
              [this](ItemId a, ItemId b) { return items[a.index - 1].serial < items[b.index - 1].serial; });
  }
  Collision collision(const Sweep& sweep, ItemId item, std::uint32_t slot, Response response,
                      const SweepContact& contact) const;
};

// Candidates are picked without branches: each one is written, and then counted or not. Which ones count is
// as good as random, and a mispredicted branch costs as much as several candidates.
template <class Callback>
void World::Impl::for_candidates(const CellRange& range, std::uint32_t except, Callback visit) {
  std::array<CellEntry, kBatch> batch;
  std::size_t count = 0;
  const std::uint32_t except_index = except + 1;
  const auto take = [&](std::size_t at, CellEntry entry, bool wanted) {
    batch[at] = entry;
    at += wanted & (entry.index != except_index);
    if (at < kBatch) return at;
    visit(std::span<const CellEntry>(batch));
    return std::size_t{0};
  };
  if (is_long(range)) {
    looks += static_cast<std::int64_t>(items.size());
    for (std::uint32_t slot = 0; slot < items.size(); ++slot) {
      count = take(count, CellEntry::of(id_of(slot), items[slot].group), items[slot].cells.meets(range));
    }
  } else {
    looks += range.count();
    for (std::int32_t y = range.top; y <= range.bottom; ++y) {
      for (std::int32_t x = range.left; x <= range.right; ++x) {
        const CellGrid::List* list = grid.find(x, y);
        if (!list) continue;
        looks += static_cast<std::int64_t>(list->size());
        // An item of several cells counts in the first one that it shares with the range.
        const std::uint32_t needed =
            (x == range.left ? 0 : CellEntry::kFirstColumn) | (y == range.top ? 0 : CellEntry::kFirstRow);
        for (const CellEntry entry : *list) count = take(count, entry, (~entry.bits & needed) == 0);
      }
    }
  }
  if (count > 0) visit(std::span<const CellEntry>(batch.data(), count));
}

template <class Reaction, class Found>
void World::Impl::for_contacts(const Sweep& sweep, std::uint32_t self, Reaction reaction, Found found) {
  for_candidates(cells_of(swept_bounds(sweep)), self, [&](std::span<const CellEntry> candidates) {
    struct Tested {
      std::uint32_t slot;
      Response response;
    };
    std::array<Tested, kBatch> tested;
    std::size_t count = 0;
    for (const CellEntry entry : candidates) {
      tested[count] = {entry.index - 1, reaction(entry)};
      count += tested[count].response != Response::ignore;
    }
    for (std::size_t i = 0; i < count; ++i) {
      const auto [slot, response] = tested[i];
      SweepContact contact;
      if (mode == Mode::robust) {
        if (detect_robust(sweep, rects[slot], contact)) found(slot, response, contact);
        continue;
      }
      const Sides difference = minkowski_difference(sweep.box, rects[slot]);
      if (misses(difference, sweep.d)) continue;
      if (detect_faithful(sweep, difference, contact)) found(slot, response, contact);
    }
  });
}

}  // namespace talus
