// The broad phase: a hash from the cells of an endless grid to the items in them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <talus/collision/world.h>

namespace talus {

// A block of cells, both ends included; empty when right < left or bottom < top.
struct CellRange {
  std::int32_t left = 0;
  std::int32_t top = 0;
  std::int32_t right = -1;
  std::int32_t bottom = -1;

  bool empty() const { return right < left || bottom < top; }
  bool covers(const CellRange& o) const {
    return left <= o.left && o.right <= right && top <= o.top && o.bottom <= bottom;
  }
  bool meets(const CellRange& o) const {
    return !empty() && !o.empty() && left <= o.right && o.left <= right && top <= o.bottom && o.top <= bottom;
  }
  std::int64_t count() const {
    return empty() ? 0 : (std::int64_t{right} - left + 1) * (std::int64_t{bottom} - top + 1);
  }
  friend bool operator==(const CellRange&, const CellRange&) = default;
};

inline constexpr std::uint32_t kMaxGeneration = (1u << 27) - 1;

// An item in the list of a cell. It holds all that a filter needs, so that an ignored candidate costs no
// other memory. It is packed, since a list is read far more often than changed.
struct CellEntry {
  static constexpr int kGroupShift = 27;
  // this cell is in the first column of the item's cells
  static constexpr std::uint32_t kFirstColumn = 1u << 30;
  static constexpr std::uint32_t kFirstRow = 1u << 31;  // the same for rows

  std::uint32_t index;
  std::uint32_t bits;  // generation, group, kFirstColumn, kFirstRow

  static CellEntry of(ItemId item, int group) {
    return {item.index, item.generation | static_cast<std::uint32_t>(group) << kGroupShift};
  }
  ItemId id() const { return {index, bits & kMaxGeneration}; }
  std::size_t group() const { return bits >> kGroupShift & 7; }
};
static_assert(World::kGroupCount == 8, "a group fits three bits of a CellEntry");

// Open addressing with linear probing over packed coordinates. When the last item leaves a cell, the cell
// keeps its list, and the list its memory. So items that move over the same ground allocate nothing.
class CellGrid {
 public:
  using List = std::vector<CellEntry>;

  // The items of a cell; null if no item was ever in it. Valid until the next change.
  const List* find(std::int32_t x, std::int32_t y) const {
    if (slots_.empty()) return nullptr;
    const Slot& slot = slots_[probe(pack(x, y))];
    return slot.key == kNoKey ? nullptr : &slot.entries;
  }

  void insert(CellEntry entry, const CellRange& range);
  // Returns how many items there were in these cells, one in several cells counting in each.
  std::int64_t remove(ItemId item, const CellRange& range);

  std::size_t cell_count() const noexcept { return used_; }
  // The length of the longest list so far.
  std::size_t longest_list() const noexcept { return longest_; }
  void drop_empty_cells();

 private:
  struct Slot {
    std::uint64_t key = kNoKey;
    List entries;
  };
  static constexpr std::uint64_t kNoKey = 0x7fffffff7fffffff;  // beyond World::kMaxCell

  static std::uint64_t pack(std::int32_t x, std::int32_t y) {
    return std::uint64_t{static_cast<std::uint32_t>(x)} << 32 | static_cast<std::uint32_t>(y);
  }
  // The slot where the key is, or would go. The upper bits of Fibonacci hashing are the well-mixed ones.
  std::size_t probe(std::uint64_t key) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = static_cast<std::size_t>(key * 0x9e3779b97f4a7c15u >> 32) & mask;
    while (slots_[at].key != key && slots_[at].key != kNoKey) at = (at + 1) & mask;
    return at;
  }
  List& list(std::int32_t x, std::int32_t y);
  void make_room();
  void rebuild(std::size_t capacity);

  std::vector<Slot> slots_;  // the size is a power of two; at most half of the slots are in use
  std::size_t used_ = 0;
  std::size_t longest_ = 0;
};

}  // namespace talus
