// Decides which parts of a level are checked again, and makes the list of problems.
#include "lint_cache.h"

#include <algorithm>
#include <bit>

#include <tuple>

#include "rule_group.h"

namespace talus {
namespace {

constexpr LintRule kMore{.code = "more",
                         .label = "problems that are not listed",
                         .by_hand = "Mend some of the listed problems: the list goes on then."};

// A block full of slopes takes a fraction of a ms. Large maps have larger blocks, as each block may hold
// kMaxProblems.
constexpr int kLeastSide = 32;
constexpr int kMaxBlocks = 1024;
constexpr std::size_t kMaxCellsAlone =
    64;  // of which each is looked at with its surroundings; else blocks are

int blocks_along(int cells, int side) { return (cells + side - 1) / side; }

bool holds(const std::array<Cell, 2>& area, Cell c) {
  return c.x >= area[0].x && c.x <= area[1].x && c.y >= area[0].y && c.y <= area[1].y;
}

bool is_before(const Problem& a, const Problem& b) {  // by row, column and rule
  const Cell none = {-1, -1};
  const Cell p = a.cell.value_or(none), q = b.cell.value_or(none);
  return std::tie(p.y, p.x, a.rule->code) < std::tie(q.y, q.x, b.rule->code);
}

std::optional<Cell> find_in(const TileMap& map, TileNumber tile, const std::array<Cell, 2>& area) {
  for (Cell c = area[0]; c.y <= area[1].y; ++c.y) {
    for (c.x = area[0].x; c.x <= area[1].x; ++c.x) {
      if (map.tile_at(c) == tile) return c;
    }
  }
  return std::nullopt;
}

}  // namespace

LintCache::LintCache() = default;
LintCache::~LintCache() = default;

void LintCache::note_cell(Cell cell) {
  if (!map_) cells_.push_back(cell);
}

double LintCache::progress() const {
  if (is_done()) return 1;
  if (map_ || rest_) return 0;  // not known yet
  return static_cast<double>(next_) / static_cast<double>(blocks_.size());
}

bool LintCache::advance(const Level& level, const LintOptions& options, FunctionRef<bool()> go_on,
                        const GroundNames& names) {
  if (is_done()) return true;
  begin(level, options, names);
  look_at_cells(level);
  for (bool more = true; next_ < blocks_.size() && more; ++next_) {
    if (blocks_[next_].is_known) continue;
    look_at_block(level, next_);
    more = go_on();
  }
  list(level);
  return is_done();
}

// Marks the blocks that have to be checked again.
void LintCache::begin(const Level& level, const LintOptions& options, const GroundNames& names) {
  if (!map_ && !rest_) return;
  const bool resized = width_ != level.map.width() || height_ != level.map.height();
  auto tiles = std::make_unique<const LintTiles>(level, options, names);
  const bool others = tiles_ == nullptr || !(*tiles == *tiles_);
  tiles_ = std::move(tiles);
  tile_problems_.resize(tiles_->count());
  seen_.assign((tiles_->count() + 63) / 64, 0);
  for (int tile = 0; tile < level.tile_count(); ++tile) {
    std::vector<Problem>& found = tile_problems_[static_cast<std::size_t>(tile)];
    found.clear();
    check_tile({level, *tiles_}, tile, found);
  }
  if (resized) {
    width_ = level.map.width(), height_ = level.map.height();
    for (side_ = kLeastSide; blocks_along(width_, side_) * blocks_along(height_, side_) > kMaxBlocks;)
      side_ *= 2;
    across_ = blocks_along(width_, side_);
    blocks_.assign(static_cast<std::size_t>(across_ * blocks_along(height_, side_)), {});
  }
  if (map_ || others) {
    for (Block& block : blocks_) block.is_known = false;
    cells_.clear();
    next_ = 0;
  }
  map_ = rest_ = false;
}

std::array<Cell, 2> LintCache::area_of(std::size_t block) const {
  const int number = static_cast<int>(block);
  const int x = number % across_ * side_, y = number / across_ * side_;
  return {Cell{x, y}, Cell{std::min(x + side_, width_) - 1, std::min(y + side_, height_) - 1}};
}

void LintCache::look_at_cells(const Level& level) {
  const int reach = tiles_->reach();
  for (const Cell cell : cells_) {
    const std::array<Cell, 2> around = {
        Cell{std::max(cell.x - reach, 0), std::max(cell.y - reach, 0)},
        Cell{std::min(cell.x + reach, width_ - 1), std::min(cell.y + reach, height_ - 1)}};
    const std::size_t first = block_at(around[0]), last = block_at(around[1]);
    const std::size_t beside = block_at({around[1].x, around[0].y}) - first;
    for (std::size_t number = first; number <= last; ++number) {
      if ((number - first) % static_cast<std::size_t>(across_) > beside) continue;
      Block& block = blocks_[number];
      if (!block.is_known) continue;
      if (block.left_out > 0 || cells_.size() > kMaxCellsAlone) {
        block.is_known = false;
        next_ = std::min(next_, number);
        continue;
      }
      std::array<Cell, 2> area = area_of(number);
      area = {Cell{std::max(around[0].x, area[0].x), std::max(around[0].y, area[0].y)},
              Cell{std::min(around[1].x, area[1].x), std::min(around[1].y, area[1].y)}};
      std::vector<Problem> found = std::move(block.problems);
      std::erase_if(found, [&](const Problem& problem) { return holds(area, *problem.cell); });
      check_area({level, *tiles_}, area, found);
      put(block, std::move(found));
    }
    // A tile that is gone from the block stays noted: list() checks whether it is still there.
    if (!level.map.contains(cell)) continue;
    std::vector<TileNumber>& noted = blocks_[block_at(cell)].tiles;
    const TileNumber tile = level.map.tile_at(cell);
    const auto place = std::lower_bound(noted.begin(), noted.end(), tile);
    if (place == noted.end() || *place != tile) noted.insert(place, tile);
  }
  cells_.clear();
}

void LintCache::look_at_block(const Level& level, std::size_t number) {
  Block& block = blocks_[number];
  const std::array<Cell, 2> area = area_of(number);
  std::vector<Problem> found;
  check_area({level, *tiles_}, area, found);
  put(block, std::move(found));
  note_tiles(level, area, block);
  block.is_known = true;
}

void LintCache::note_tiles(const Level& level, const std::array<Cell, 2>& area, Block& block) {
  for (Cell c = area[0]; c.y <= area[1].y; ++c.y) {
    for (c.x = area[0].x; c.x <= area[1].x; ++c.x) {
      const TileNumber tile = level.map.tile_at(c);
      seen_[tile / 64] |= std::uint64_t{1} << tile % 64;
    }
  }
  block.tiles.clear();
  for (std::size_t word = 0; word < seen_.size(); ++word) {
    for (; seen_[word] != 0; seen_[word] &= seen_[word] - 1)
      block.tiles.push_back(static_cast<TileNumber>(64 * word + std::countr_zero(seen_[word])));
  }
}

void LintCache::put(Block& block, std::vector<Problem> found) {
  std::stable_sort(found.begin(), found.end(), is_before);
  block.left_out = 0;
  block.worst_left_out = Severity::warning;
  for (; found.size() > kMaxProblems; found.pop_back(), ++block.left_out)
    block.worst_left_out = std::max(block.worst_left_out, found.back().severity);
  block.problems = std::move(found);
}

// Returns the first cell with a tile; empty if there is none. The tiles that blocks have noted may be out of
// date.
std::optional<Cell> LintCache::find(const Level& level, TileNumber tile) {
  std::optional<Cell> first;
  for (std::size_t number = 0; number < blocks_.size(); ++number) {
    const bool begins_row = number % static_cast<std::size_t>(across_) == 0;
    if (begins_row && first) return first;
    std::vector<TileNumber>& tiles = blocks_[number].tiles;
    const auto noted = std::lower_bound(tiles.begin(), tiles.end(), tile);
    if (noted == tiles.end() || *noted != tile) continue;
    if (const auto found = find_in(level.map, tile, area_of(number))) {
      if (!first || found->y < first->y) first = found;
    } else {
      tiles.erase(noted);
    }
  }
  return first;
}

void LintCache::list(const Level& level) {
  bool has_balls = next_ < blocks_.size();  // true until all blocks are checked, as the rest may have balls
  problems_.clear();
  std::size_t left_out = 0;
  Severity worst = Severity::warning;
  const auto leave_out = [&](Severity severity, std::size_t count) {
    left_out += count;
    if (count > 0) worst = std::max(worst, severity);
  };
  for (std::size_t tile = 0; tile < tiles_->count(); ++tile) {
    const bool is_ball = (*tiles_)[tile].role == TileRole::ball && !has_balls;
    if (!is_ball && tile_problems_[tile].empty()) continue;
    if (!is_ball && problems_.size() >= kMaxProblems) {  // looking for cells takes long
      for (const Problem& problem : tile_problems_[tile]) leave_out(problem.severity, 1);
      continue;
    }
    const std::optional<Cell> first = find(level, static_cast<TileNumber>(tile));
    if (!first) continue;
    has_balls = has_balls || is_ball;
    for (Problem problem : tile_problems_[tile]) {
      problem.cell = first;
      problems_.push_back(std::move(problem));
    }
  }
  check_level({level, *tiles_, has_balls}, problems_);
  // While there is room, all problems of the blocks in a row are listed. Those of the next row come later.
  std::size_t listed = 0, row_begins_at = 0;
  for (std::size_t number = 0; number < blocks_.size(); ++number) {
    const Block& block = blocks_[number];
    if (number % static_cast<std::size_t>(across_) == 0) row_begins_at = listed;
    for (const Problem& problem : block.problems) {
      if (row_begins_at < kMaxProblems) {
        problems_.push_back(problem);
        ++listed;
      } else {
        leave_out(problem.severity, 1);
      }
    }
    leave_out(block.worst_left_out, block.left_out);
  }
  std::stable_sort(problems_.begin(), problems_.end(), is_before);
  for (; problems_.size() > kMaxProblems; problems_.pop_back()) leave_out(problems_.back().severity, 1);
  if (left_out > 0) {
    problems_.insert(problems_.begin(),
                     {&kMore, worst, std::to_string(left_out) + " more problems are not listed", {}, -1, -1});
  }
}

}  // namespace talus
