// Changes of the grid; looking up is inline in the header.
#include "cell_grid.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <utility>

namespace talus {
namespace {

constexpr std::size_t kSmallest = 64;

}  // namespace

void CellGrid::insert(CellEntry entry, const CellRange& range) {
  for (std::int32_t y = range.top; y <= range.bottom; ++y) {
    for (std::int32_t x = range.left; x <= range.right; ++x) {
      const std::uint32_t first =
          (x == range.left ? CellEntry::kFirstColumn : 0) | (y == range.top ? CellEntry::kFirstRow : 0);
      List& entries = list(x, y);
      entries.push_back({entry.index, entry.bits | first});
      longest_ = std::max(longest_, entries.size());
    }
  }
}

std::int64_t CellGrid::remove(ItemId item, const CellRange& range) {
  std::int64_t count = 0;
  for (std::int32_t y = range.top; y <= range.bottom; ++y) {
    for (std::int32_t x = range.left; x <= range.right; ++x) {
      List& entries = list(x, y);
      count += static_cast<std::int64_t>(entries.size());
      const auto at = std::find_if(entries.begin(), entries.end(),
                                   [item](const CellEntry& entry) { return entry.index == item.index; });
      assert(at != entries.end());
      *at = entries.back();
      entries.pop_back();
    }
  }
  return count;
}

CellGrid::List& CellGrid::list(std::int32_t x, std::int32_t y) {
  const std::uint64_t key = pack(x, y);
  if (!slots_.empty()) {
    Slot& slot = slots_[probe(key)];
    if (slot.key == key) return slot.entries;
  }
  if (2 * (used_ + 1) > slots_.size()) make_room();
  Slot& slot = slots_[probe(key)];
  slot.key = key;
  ++used_;
  return slot.entries;
}

// A world that wanders would keep every cell that it ever touched. So empty cells go first when they are the
// majority.
void CellGrid::make_room() {
  const auto empty = std::count_if(slots_.begin(), slots_.end(), [](const Slot& slot) {
    return slot.key != kNoKey && slot.entries.empty();
  });
  if (2 * static_cast<std::size_t>(empty) > used_) drop_empty_cells();
  rebuild(std::max(kSmallest, std::bit_ceil(4 * (used_ + 1))));
}

void CellGrid::drop_empty_cells() {
  for (Slot& slot : slots_) {
    if (slot.entries.empty()) slot = {};
  }
  used_ = static_cast<std::size_t>(
      std::count_if(slots_.begin(), slots_.end(), [](const Slot& slot) { return slot.key != kNoKey; }));
  rebuild(std::max(kSmallest, std::bit_ceil(2 * used_)));
}

void CellGrid::rebuild(std::size_t capacity) {
  std::vector<Slot> old = std::exchange(slots_, std::vector<Slot>(capacity));
  for (Slot& slot : old) {
    if (slot.key != kNoKey) slots_[probe(slot.key)] = std::move(slot);
  }
}

}  // namespace talus
