// BodyGrid: the broad phase between bodies. It finds the bodies near a box.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <talus/sim/state.h>
#include "../collision/cell_grid.h"

namespace talus {

// Keeps each body, by its index in the state, in the cells that its box meets.
class BodyGrid {
 public:
  // Called before the bodies are placed. If they are fewer than before, those that are gone would stay in it.
  void begin(std::size_t count) {
    if (count < placed_.size()) clear();
  }

  // Takes the current boxes; cheap for bodies that have not moved.
  void synchronise(const std::vector<Body>& bodies) {
    begin(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) place(static_cast<std::uint32_t>(i), bodies[i].box);
  }

  // Returns the work that it took: the cells, and the entries that it passed in them.
  std::int64_t place(std::uint32_t index, const Rect& box) {
    if (index >= placed_.size()) placed_.resize(index + 1);
    const CellRange range = cells_of(box);
    CellRange& old = placed_[index];
    if (range == old) return 0;
    const std::int64_t work = leave(index, old) + enter(index, range);
    old = range;
    return work;
  }

  // Finds the bodies in the cells that the box meets, but for one, in order, each once. Every cell and body
  // that it tests is taken from `left`. Returns false, and no bodies, if there is not enough left.
  bool near(const Rect& box, std::uint32_t but, std::int64_t& left, std::vector<std::uint32_t>& found) const {
    found.clear();
    left = look(cells_of(box), left, found);
    if (left < 0) {
      left = 0;
      found.clear();
      return false;
    }
    std::erase(found, but);
    if (found.size() > 1) std::sort(found.begin(), found.end());
    return true;
  }

 private:
  static constexpr double kSide = 16;  // px, of a cell: twice the article's ball
  // Limit for one body in the grid. Larger bodies are in a list, as thousands of them would fill millions of
  // cells.
  static constexpr std::int64_t kMaxCells = 64;
  // Bodies whose places are compared, or that are passed in a list, in the time of one unit of work.
  static constexpr std::int64_t kPlacesPerWork = 8;

  static std::int64_t work_of_places(std::size_t count) {
    return static_cast<std::int64_t>(count) / kPlacesPerWork;
  }

  std::int64_t enter(std::uint32_t index, const CellRange& range) {
    if (range.count() <= kMaxCells) {
      grid_.insert(CellEntry::of(ItemId{index, 1}, 0), range);
      return range.count();
    }
    large_.push_back(index);
    return 1;
  }

  std::int64_t leave(std::uint32_t index, const CellRange& range) {
    if (range.empty()) return 0;
    if (range.count() <= kMaxCells) return grid_.remove(ItemId{index, 1}, range) / kPlacesPerWork;
    const std::size_t passed = large_.size();
    large_.erase(std::find(large_.begin(), large_.end(), index));
    return work_of_places(passed);
  }

  // Returns what is left; less than 0: it ended before it had found all bodies.
  std::int64_t look(const CellRange& range, std::int64_t left, std::vector<std::uint32_t>& found) const {
    // A long motion may sweep more cells than there are bodies.
    if (range.count() > static_cast<std::int64_t>(64 + 4 * placed_.size())) {
      left -= work_of_places(placed_.size());
      if (left < 0) return left;
      for (std::uint32_t i = 0; i < placed_.size(); ++i) {
        if (placed_[i].meets(range)) found.push_back(i);
      }
      return left - static_cast<std::int64_t>(found.size());
    }
    left -= range.count() + work_of_places(large_.size());
    if (left < 0) return left;
    for (const std::uint32_t i : large_) {
      if (placed_[i].meets(range)) found.push_back(i);
    }
    left -= static_cast<std::int64_t>(found.size());
    for (std::int32_t y = range.top; y <= range.bottom; ++y) {
      for (std::int32_t x = range.left; x <= range.right; ++x) {
        const CellGrid::List* list = grid_.find(x, y);
        if (list == nullptr) continue;
        left -= static_cast<std::int64_t>(list->size());
        if (left < 0) return left;
        // Each in the first of the cells that it shares with the range.
        const std::uint32_t first =
            (x == range.left ? 0 : CellEntry::kFirstColumn) | (y == range.top ? 0 : CellEntry::kFirstRow);
        for (const CellEntry& entry : *list) {
          if ((entry.bits & first) == first) found.push_back(entry.index);
        }
      }
    }
    return left;
  }

  void clear() {
    grid_ = CellGrid();
    placed_.clear();
    large_.clear();
  }
  static CellRange cells_of(const Rect& box) {
    // Rounds down; std::floor would be a call.
    const auto cell = [](double at) {
      const double cells = at * (1 / kSide);
      const auto whole = static_cast<std::int32_t>(cells);
      return cells < whole ? whole - 1 : whole;
    };
    return {cell(box.x), cell(box.y), cell(box.x + box.w), cell(box.y + box.h)};
  }

  CellGrid grid_;
  std::vector<CellRange> placed_;     // by index
  std::vector<std::uint32_t> large_;  // indices of those in no cell, in no order
};

}  // namespace talus
