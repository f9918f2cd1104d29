// LintCache: the problems of an edited level. It checks what has changed again, a part at a time.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <talus/collision/function_ref.h>
#include "../ground_names.h"
#include "lint.h"

namespace talus {

class LintTiles;

// The map is cut into square blocks. After a change of a cell, only the cell and its surroundings are checked
// again. After a change of a tile or of the options, all blocks are.
class LintCache {
 public:
  LintCache();
  ~LintCache();

  void note_cell(Cell cell);          // call it when the cell has another tile
  void note_map() { map_ = true; }    // call it when the size of the map or any cell may have changed
  void note_rest() { rest_ = true; }  // call it when anything but the map may have changed

  // Checks what has changed and one of the blocks that are left, and more of them while `go_on` returns true.
  // Returns true when nothing is left. level: the same one each time, except for the noted changes. names: of
  // its tiles.
  bool advance(const Level& level, const LintOptions& options, FunctionRef<bool()> go_on,
               const GroundNames& names = {});
  void finish(const Level& level, const LintOptions& options, const GroundNames& names = {}) {
    advance(
        level, options, [] { return true; }, names);
  }
  bool is_done() const { return !map_ && !rest_ && cells_.empty() && next_ == blocks_.size(); }
  double progress() const;  // the share of the blocks that are checked, 0 to 1

  // The problems in the order of lint(). Blocks that are not checked yet have their problems of the last
  // check.
  const std::vector<Problem>& problems() const { return problems_; }

 private:
  struct Block {
    std::vector<Problem> problems;  // at most kMaxProblems
    std::size_t left_out = 0;       // problems beyond kMaxProblems
    Severity worst_left_out = Severity::warning;
    std::vector<TileNumber> tiles;  // that are in the block, ascending
    bool is_known = false;
  };

  void begin(const Level& level, const LintOptions& options, const GroundNames& names);
  void look_at_cells(const Level& level);
  void look_at_block(const Level& level, std::size_t number);
  void note_tiles(const Level& level, const std::array<Cell, 2>& area, Block& block);
  void put(Block& block, std::vector<Problem> found);
  std::optional<Cell> find(const Level& level, TileNumber tile);
  void list(const Level& level);
  std::array<Cell, 2> area_of(std::size_t block) const;
  std::size_t block_at(Cell cell) const {
    return static_cast<std::size_t>(cell.y / side_ * across_ + cell.x / side_);
  }

  std::vector<Cell> cells_;        // noted cells
  bool map_ = true, rest_ = true;  // noted changes
  std::unique_ptr<const LintTiles> tiles_;
  std::vector<std::vector<Problem>> tile_problems_;  // of each tile, without a cell
  std::vector<std::uint64_t> seen_;                  // by tile, a bit each; used while a block is looked at
  int width_ = 0, height_ = 0;                       // size of the map, cells
  int side_ = 1;                                     // side of a block, cells
  int across_ = 1;                                   // blocks in a row
  std::vector<Block> blocks_;                        // row by row
  std::size_t next_ = 0;                             // all blocks before it are checked
  std::vector<Problem> problems_;
};

}  // namespace talus
