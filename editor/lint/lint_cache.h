// LintCache: the problems of a level that is being edited. Looks again at what has changed, a part at a time.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <talus/collision/function_ref.h>
#include "lint.h"

namespace talus {

class LintTiles;

// The map is cut into square blocks. A changed cell is looked at again with its surroundings alone; a change
// of a tile, or of what counts, has all blocks looked at again.
class LintCache {
 public:
  LintCache();
  ~LintCache();

  void note_cell(Cell cell);          // has another tile now
  void note_map() { map_ = true; }    // so may any cell, and the map another size
  void note_rest() { rest_ = true; }  // anything but the map may be another

  // Looks at what has changed, and at the blocks that are left: at one, and at more while `go_on` says so.
  // True when nothing is left. level: the same one each time, but for the noted changes.
  bool advance(const Level& level, const LintOptions& options, FunctionRef<bool()> go_on);
  void finish(const Level& level, const LintOptions& options) {
    advance(level, options, [] { return true; });
  }
  bool is_done() const { return !map_ && !rest_ && cells_.empty() && next_ == blocks_.size(); }
  double progress() const;  // the part of the blocks that are known, 0 to 1

  // By row, then column, then rule, as lint() gives them. Of blocks still to be looked at, what was found
  // before.
  const std::vector<Problem>& problems() const { return problems_; }

 private:
  struct Block {
    std::vector<Problem> problems;  // at most kMaxProblems
    std::size_t left_out = 0;       // over that
    Severity worst_left_out = Severity::warning;
    std::bitset<kTileCount> tiles;  // that are in it
    bool is_known = false;
  };

  void begin(const Level& level, const LintOptions& options);
  void look_at_cells(const Level& level);
  void look_at_block(const Level& level, std::size_t number);
  void put(Block& block, std::vector<Problem> found);
  std::optional<Cell> find(const Level& level, std::size_t tile);
  void list(const Level& level);
  std::array<Cell, 2> area_of(std::size_t block) const;
  std::size_t block_at(Cell cell) const {
    return static_cast<std::size_t>(cell.y / side_ * across_ + cell.x / side_);
  }

  std::vector<Cell> cells_;        // noted
  bool map_ = true, rest_ = true;  // noted
  std::unique_ptr<const LintTiles> tiles_;
  std::array<std::vector<Problem>, kTileCount> tile_problems_;  // without a cell
  int width_ = 0, height_ = 0;                                  // cells, of the map
  int side_ = 1;                                                // cells, of a block
  int across_ = 1;                                              // blocks beside one another
  std::vector<Block> blocks_;                                   // row by row
  std::size_t next_ = 0;                                        // no block before it is unknown
  std::vector<Problem> problems_;
};

}  // namespace talus
