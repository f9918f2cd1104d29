// Works column by column, on the cells that were placed so far.
#include "slope_layer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "../collision/tile_outlines.h"

namespace talus {
namespace {

constexpr int kMaxFill = 64;  // rows below a slope in which a fill looks for ground

// The shapes of what cells hold; each is made once.
class CellShapes {
 public:
  explicit CellShapes(const Level& level) : level_(level) {}
  struct Shape {
    TileShape shape;
    TileOutline outline;  // empty if the shape cannot be used
  };
  const Shape& at(Cell cell) {
    const MapCell held = level_.map.at(cell);
    const auto [known, is_new] = known_.try_emplace(held);
    if (is_new) {
      const TileSize size = level_.map.tile_size();
      known->second.shape = shape_of_cell(level_, held);
      const std::array shapes = {known->second.shape};
      if (!problem_of(shapes[0], size)) known->second.outline = TileOutlines(shapes, size)[0];
    }
    return known->second;
  }

 private:
  const Level& level_;
  std::map<MapCell, Shape> known_;
};

// Which cells of an area have a part of the ground in them.
class CoveredCells {
 public:
  CoveredCells(const Level& level, CellRect area)
      : size_(level.map.tile_size()),
        area_(area),
        covered_(static_cast<std::size_t>(area.w) * static_cast<std::size_t>(area.h)) {
    CellShapes shapes(level);
    for (Cell cell{0, area.y - kMaxShapeTiles}; cell.y < area.y + area.h + kMaxShapeTiles; ++cell.y)
      for (cell.x = area.x - kMaxShapeTiles; cell.x < area.x + area.w + kMaxShapeTiles; ++cell.x)
        if (level.map.contains(cell)) cover(cell, shapes.at(cell).outline);
  }
  bool has(Cell cell) const { return area_.contains(cell) && covered_[index(cell)]; }

 private:
  void cover(Cell cell, const TileOutline& outline) {
    for (int i = 0; i < outline.width(); ++i) {
      const int column = outline.first_column + i;
      for (const TileColumn& part : outline.in_column(column)) {
        const int first = static_cast<int>(std::floor(part.highest / size_.height));
        const int end = static_cast<int>(std::ceil(part.lowest / size_.height));
        for (Cell c{cell.x + column, cell.y + first}; c.y < cell.y + end; ++c.y)
          if (area_.contains(c)) covered_[index(c)] = true;
      }
    }
  }
  std::size_t index(Cell cell) const {
    return static_cast<std::size_t>(cell.y - area_.y) * static_cast<std::size_t>(area_.w) +
           static_cast<std::size_t>(cell.x - area_.x);
  }

  TileSize size_;
  CellRect area_;
  std::vector<bool> covered_;
};

// The part of a slope or profile in one of its columns.
TileShape one_column_of(const TileShape& slope, int column, TileSize tile) {
  TileShape part = slope;
  part.tiles = 1;
  part.heights.clear();
  const int step = slope.kind == TileShape::Kind::slope ? tile.width : 1;
  for (int x = 0; x <= tile.width; x += step)
    part.heights.push_back(height_of_line(slope, column * tile.width + x, tile));
  return part;
}

}  // namespace

int SlopeLayer::lowest_row() const {
  int row = 0;
  for (const Cell& cell : owners_) row = std::max(row, cell.y);
  return row;
}

void SlopeLayer::cut() {
  if (floor_.empty() || shape_of_tile(level_, 0).kind != TileShape::Kind::none) return;  // no tile is air
  std::map<int, int> tops;  // by column, the highest row
  for (const auto& [at, tile] : floor_) tops.try_emplace(at.first, at.second);
  int highest = map_.height(), lowest = 0;
  for (const auto& [column, top] : tops) {
    highest = std::min(highest, top);
    lowest = std::max(lowest, top);
  }
  const int first = tops.begin()->first, last = tops.rbegin()->first;
  const CoveredCells ground(level_,
                            {first, highest - kMaxCut - 1, last - first + 1, lowest - highest + kMaxCut + 1});
  for (const auto& [column, top] : tops) {
    int row = top;
    while (row > 0 && top - row <= kMaxCut && ground.has({column, row - 1})) --row;
    if (top - row > kMaxCut || (row == 0 && top > 0)) {
      leave_out(column);
      continue;
    }
    for (; row < top; ++row) place({column, row}, 0);
  }
}

void SlopeLayer::leave_out(int column) {
  constexpr int kNoRow = std::numeric_limits<int>::min();
  floor_.erase(floor_.lower_bound({column, kNoRow}), floor_.lower_bound({column + 1, kNoRow}));
  std::erase_if(owners_, [&](Cell cell) { return cell.x == column; });
}

void SlopeLayer::fill(TileNumber below, bool fills, int last) {
  for (const Cell& cell : owners_) {
    const int end = fills ? std::min(end_of_fill(cell, last), map_.height()) : cell.y + 2;
    for (Cell under{cell.x, cell.y + 1}; under.y < end; ++under.y)
      if (map_.contains(under) && !is_ball_tile(level_, map_.tile_at(under)))
        below_.try_emplace({under.x, under.y}, below);
  }
}

// The row of the first full tile under a cell; the one after `last` if there is none near.
int SlopeLayer::end_of_fill(Cell cell, int last) const {
  const int bottom = std::min(map_.height(), std::max(last, cell.y) + kMaxFill);
  for (Cell under{cell.x, cell.y + 1}; under.y < bottom && map_.contains(under); ++under.y)
    if (is_full(shape_of_cell(level_, map_.at(under)))) return under.y;
  return last + 1;
}

bool SlopeLayer::has_new_floor_in(int column) const {
  const auto from = floor_.lower_bound({column, std::numeric_limits<int>::min()});
  return from != floor_.end() && from->first.first == column;
}

// Whether a part of an old slope is gone: its own cell, or some of its floor.
bool SlopeLayer::replaces(Cell cell, const TileShape& slope) const {
  if (floor_.contains({cell.x, cell.y}) || below_.contains({cell.x, cell.y})) return true;
  const auto [from, to] = cells_touched_by(slope, cell, map_.tile_size());  // and those beside
  for (int x = from.x + 1; x < to.x; ++x)
    for (int y = from.y + 1; y < to.y; ++y)
      if (floor_.contains({x, y})) return true;
  return false;
}

std::vector<SlopeLayer::Rest> SlopeLayer::rests() const {
  std::vector<Rest> rests;
  if (floor_.empty()) return rests;
  CellShapes shapes(level_);
  const int first = floor_.begin()->first.first, last = floor_.rbegin()->first.first;
  for (Cell cell{first - kMaxShapeTiles, 0}; cell.x <= last; ++cell.x) {
    for (cell.y = 0; cell.y < map_.height(); ++cell.y) {
      if (!map_.contains(cell)) continue;
      const TileShape& slope = shapes.at(cell).shape;
      if (!has_heights(slope) || slope.tiles == 1 || shapes.at(cell).outline.columns.empty() ||
          !replaces(cell, slope))
        continue;
      for (int i = 0; i < slope.tiles; ++i) {
        const Cell there{cell.x + i, cell.y};
        if (has_new_floor_in(there.x) || !map_.contains(there)) continue;
        if (i == 0 || shapes.at(there).shape.kind == TileShape::Kind::none)
          rests.push_back({there, one_column_of(slope, i, map_.tile_size())});
      }
    }
  }
  return rests;
}

tl::expected<std::vector<SlopeTiles::Placed>, std::string> SlopeLayer::placed() const {
  Tiles all = floor_;
  all.insert(below_.begin(), below_.end());
  std::vector<SlopeTiles::Placed> placed;
  for (const auto& [at, tile] : all) {
    const Cell cell = {at.first, at.second};
    if (!map_.contains(cell)) return tl::unexpected<std::string>("the slope's tiles would leave the map");
    placed.push_back({cell, tile});
  }
  return placed;
}

}  // namespace talus
