// Compiles the outline of each area, and sorts its pieces by the way that they face.
#include "ground_faults.h"

#include <algorithm>

#include "../lip.h"
#include "collision/outline_compiler.h"

namespace talus {
namespace {

constexpr double kGrain = 1.5 / kWeldParts;  // px; heights that differ by less are the same

// Returns how far each height is below the highest ones at its left and its right. heights: px, down.
std::vector<double> depths_of(const std::vector<double>& heights) {
  std::vector<double> rims(heights.size());
  double highest = heights.empty() ? 0 : heights.front();
  for (std::size_t i = 0; i < heights.size(); ++i) rims[i] = highest = std::min(highest, heights[i]);
  highest = heights.empty() ? 0 : heights.back();
  for (std::size_t i = heights.size(); i-- > 0;) {
    highest = std::min(highest, heights[i]);
    rims[i] = heights[i] - std::max(rims[i], highest);
  }
  return rims;
}

}  // namespace

GroundFaults::GroundFaults(const Level& level, const LintTiles& tiles,
                           std::span<const std::array<Cell, 2>> areas)
    : lip_(highest_lip(level.map.tile_size())) {
  for (const std::array<Cell, 2>& area : areas) look_at(level, tiles, area);
}

void GroundFaults::look_at(const Level& level, const LintTiles& tiles, const std::array<Cell, 2>& area) {
  const TileMap& map = level.map;
  OutlineCompiler compiler(map.width(), tiles.outlines(), {}, tiles.curves().ends,
                           [&](Cell from, std::span<const TileOutline*> row) {
                             static const TileOutline kNothing;
                             for (const TileOutline*& outline : row) {
                               outline =
                                   map.contains(from) ? &tiles.outlines()[map.tile_at(from)] : &kNothing;
                               ++from.x;
                             }
                           });
  compiler.enter(area);
  const int left = area[0].x * map.tile_size().width, right = (area[1].x + 1) * map.tile_size().width;
  std::vector<double> floors(static_cast<std::size_t>(right - left), map.y_of(area[1].y + 1));
  std::vector<Piece<double>> pieces;
  for (Cell c = area[0]; c.y <= area[1].y; ++c.y)
    for (c.x = area[0].x; c.x <= area[1].x; ++c.x) compiler.compile(c, {}, pieces);
  for (const Piece<double>& piece : pieces) {
    if (piece.is_wall()) {
      walls_[{static_cast<int>(piece.facing), piece.x0}].push_back(
          {std::min(piece.y0, piece.y1), std::max(piece.y0, piece.y1)});
      continue;
    }
    for (int x = std::max(left, static_cast<int>(piece.x0)); x < right && x + 0.5 < piece.x1; ++x) {
      if (x + 0.5 < piece.x0) continue;
      const double y = piece.line_at(x + 0.5);
      double& floor = floors[static_cast<std::size_t>(x - left)];
      if (piece.facing == Facing::up)
        floor = std::min(floor, y);
      else
        ceilings_[x].insert(weld(y));
    }
  }
  for (const Piece<double>& piece : pieces)
    if (piece.facing == Facing::up) note_notch(piece);
  const std::vector<double> depths = depths_of(floors);
  pits_.insert(pits_.end(), depths.begin(), depths.end());
}

void GroundFaults::note_notch(const Piece<double>& floor) {
  if (floor.y0 == floor.y1) return;
  const bool falls = floor.y0 < floor.y1;
  const double x = falls ? floor.x1 : floor.x0, y = falls ? floor.y1 : floor.y0;
  const auto walls = walls_.find({static_cast<int>(falls ? Facing::left : Facing::right), x});
  if (walls == walls_.end()) return;
  const bool is_at_foot = std::any_of(walls->second.begin(), walls->second.end(), [&](const Interval& wall) {
    return wall.from < y - kGrain && wall.to > y - kGrain;
  });
  if (is_at_foot) notches_.insert({x, y});
}

// Joins walls of one side and column that touch.
std::vector<GroundFaults::Interval> GroundFaults::joined(std::vector<Interval> walls) {
  std::sort(walls.begin(), walls.end(), [](const Interval& a, const Interval& b) { return a.from < b.from; });
  std::vector<Interval> all;
  for (const Interval& wall : walls) {
    if (!all.empty() && wall.from <= all.back().to + kGrain)
      all.back().to = std::max(all.back().to, wall.to);
    else
      all.push_back(wall);
  }
  return all;
}

// Whether a wall is more than what was there: it was not, or it is so low now that nobody sees it.
bool GroundFaults::is_worse(const Interval& wall, std::span<const Interval> before) const {
  const bool is_lip = wall.to - wall.from <= lip_;
  return std::none_of(before.begin(), before.end(), [&](const Interval& old) {
    const bool was_lip = old.to - old.from <= lip_;
    return old.from <= wall.from + kGrain && old.to >= wall.to - kGrain && (was_lip || !is_lip);
  });
}

bool GroundFaults::has_more_than(const GroundFaults& before) const {
  for (const auto& [place, walls] : walls_) {
    const auto known = before.walls_.find(place);
    const std::vector<Interval> old =
        known != before.walls_.end() ? joined(known->second) : std::vector<Interval>();
    for (const Interval& wall : joined(walls))
      if (wall.to - wall.from > kGrain && is_worse(wall, old)) return true;
  }
  if (!std::includes(before.notches_.begin(), before.notches_.end(), notches_.begin(), notches_.end()))
    return true;
  for (const auto& [column, ceilings] : ceilings_) {
    const auto known = before.ceilings_.find(column);
    if (known == before.ceilings_.end() || ceilings.size() > known->second.size()) return true;
  }
  for (std::size_t i = 0; i < pits_.size(); ++i)
    if (pits_[i] > before.pits_[i] + kGrain) return true;
  return false;
}

}  // namespace talus
