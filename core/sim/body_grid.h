// BodyGrid: the broad phase between bodies. It finds the bodies near a box.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <talus/sim/state.h>
#include "../collision/cell_grid.h"

namespace talus {

// Keeps each body, by its index in the state, in the cells that its box meets.
class BodyGrid {
 public:
  // Takes the current boxes; cheap for bodies that have not moved.
  void synchronise(const std::vector<Body>& bodies) {
    if (bodies.size() < placed_.size()) clear();
    for (std::size_t i = 0; i < bodies.size(); ++i) place(static_cast<std::uint32_t>(i), bodies[i].box);
  }

  void place(std::uint32_t index, const Rect& box) {
    if (index >= placed_.size()) placed_.resize(index + 1);
    const CellRange range = cells_of(box);
    CellRange& old = placed_[index];
    if (range == old) return;
    if (!old.empty()) grid_.remove(ItemId{index, 1}, old);
    grid_.insert(CellEntry::of(ItemId{index, 1}, 0), range);
    old = range;
  }

  // Finds the bodies in the cells that the box meets, in order, each once. Returns false, and no bodies, if
  // there are more than `most`; a body counts once for each of its cells.
  bool near(const Rect& box, std::int64_t most, std::vector<std::uint32_t>& found) const {
    found.clear();
    const CellRange range = cells_of(box);
    // A long way may sweep more cells than there are bodies.
    if (range.count() > static_cast<std::int64_t>(64 + 4 * placed_.size())) {
      for (std::uint32_t i = 0; i < placed_.size(); ++i) {
        if (placed_[i].meets(range)) found.push_back(i);
      }
      if (static_cast<std::int64_t>(found.size()) <= most) return true;
      found.clear();
      return false;
    }
    std::int64_t count = 0;
    for (std::int32_t y = range.top; y <= range.bottom; ++y) {
      for (std::int32_t x = range.left; x <= range.right; ++x) {
        const CellGrid::List* list = grid_.find(x, y);
        if (list == nullptr) continue;
        count += static_cast<std::int64_t>(list->size());
        if (count > most) {
          found.clear();
          return false;
        }
        for (const CellEntry& entry : *list) found.push_back(entry.index);
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return true;
  }

 private:
  static constexpr double kSide = 16;  // px, of a cell: twice the article's ball

  void clear() {
    grid_ = CellGrid();
    placed_.clear();
  }
  static CellRange cells_of(const Rect& box) {
    const auto cell = [](double at) { return static_cast<std::int32_t>(std::floor(at / kSide)); };
    return {cell(box.x), cell(box.y), cell(box.x + box.w), cell(box.y + box.h)};
  }

  CellGrid grid_;
  std::vector<CellRange> placed_;  // by index
};

}  // namespace talus
