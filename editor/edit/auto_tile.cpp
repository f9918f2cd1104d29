// Painting ground and choosing its tiles. The proposal is in auto_tile_proposal.cpp.
#include "auto_tile.h"

#include <cassert>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "collision/tile_outlines.h"
#include "level/single_change.h"
#include "raster.h"

namespace talus {
namespace {

// Distance of the furthest cell that matters for a tile: the half of a slope at the end of its tread.
constexpr int kReachX = 3, kReachY = 1;

TileNumber first_of(const AutoTiles& set, std::initializer_list<GroundPart> parts) {
  for (const GroundPart part : parts)
    if (set.of(part) != 0) return set.of(part);
  return 0;
}

// The surroundings of a cell, seen from the left for dx = 1, or mirrored for dx = -1.
class Surroundings {
 public:
  Surroundings(FunctionRef<bool(Cell)> is_ground, Cell at, int dx)
      : is_ground_(is_ground), at_(at), dx_(dx) {}
  bool ground(int x, int y) const { return is_ground_({at_.x + dx_ * x, at_.y + y}); }
  // Whether the tread of cell x begins there, one step above the ground before it.
  bool rises(int x) const {
    return ground(x, 0) && ground(x, 1) && !ground(x, -1) && !ground(x - 1, 0) && ground(x - 1, 1);
  }
  bool falls(int x) const {
    return ground(x, 0) && ground(x, 1) && !ground(x, -1) && !ground(x + 1, 0) && ground(x + 1, 1);
  }
  // Whether the cells x and x + 1 have room for a slope of two tiles, with a slope down at the other end.
  bool has_long_slope(int x) const {
    return rises(x) && ground(x + 1, 0) && ground(x + 1, 1) && !ground(x + 1, -1) && !falls(x + 1) &&
           !falls(x + 2);
  }

 private:
  FunctionRef<bool(Cell)> is_ground_;
  Cell at_;
  int dx_;
};

// The parts of a slope in order: the tile at its foot, the one behind, and a single tile for the whole step.
struct SlopeParts {
  GroundPart foot, head, whole;
};
constexpr SlopeParts kUp = {GroundPart::slope_up_left, GroundPart::slope_up_right, GroundPart::slope_up};
constexpr SlopeParts kDown = {GroundPart::slope_down_right, GroundPart::slope_down_left,
                              GroundPart::slope_down};

// The slope's tile at cell 0; 0 if the cell is no slope.
TileNumber slope_tile(const AutoTiles& set, const Surroundings& around, const SlopeParts& parts) {
  const bool is_long = set.of(parts.foot) != 0 && set.of(parts.head) != 0;
  if (is_long && around.has_long_slope(-1)) return set.of(parts.head);
  if (!around.rises(0) || around.falls(0)) return 0;
  return is_long && around.has_long_slope(0) ? set.of(parts.foot) : set.of(parts.whole);
}

// Updates the ground around painted cells.
class GroundPatch {
 public:
  GroundPatch(const Level& level, CellRect painted, Within within)
      : map_(level.map),
        within_(within),
        set_(level.auto_tiles),
        area_{painted.x - 2 * kReachX, painted.y - 2 * kReachY, painted.w + 4 * kReachX,
              painted.h + 4 * kReachY},
        cells_(static_cast<std::size_t>(area_.w) * static_cast<std::size_t>(area_.h)) {
    std::vector<bool> is_ground(static_cast<std::size_t>(level.tile_count()));
    for (const TileNumber tile : set_.tiles) is_ground[tile] = tile != 0;
    for (int y = area_.y; y < area_.y + area_.h; ++y) {
      for (int x = area_.x; x < area_.x + area_.w; ++x)
        at({x, y}).ground = !map_.contains({x, y}) || is_ground[map_.tile_at({x, y})];
    }
  }

  void change(Cell cell, GroundChange change) {
    if (!map_.contains(cell) || (within_ && !within_->contains(cell))) return;
    PatchCell& painted = at(cell);
    painted.removed = change == GroundChange::remove && painted.ground;
    painted.ground = change == GroundChange::add;
    for (int y = cell.y - kReachY; y <= cell.y + kReachY; ++y) {
      for (int x = cell.x - kReachX; x <= cell.x + kReachX; ++x) at({x, y}).stale = true;
    }
  }

  Edit finish(std::string label) {
    CellPainter painter(map_, within_);
    const auto is_ground = [this](Cell cell) { return at(cell).ground; };
    for (int y = area_.y + kReachY; y < area_.y + area_.h - kReachY; ++y) {
      for (int x = area_.x + kReachX; x < area_.x + area_.w - kReachX; ++x) {
        const PatchCell& cell = at({x, y});
        if (cell.removed) painter.paint({x, y}, 0);
        if (cell.stale && cell.ground && map_.contains({x, y}))
          painter.paint({x, y}, ground_tile(set_, is_ground, {x, y}));
      }
    }
    return painter.finish(std::move(label));
  }

 private:
  struct PatchCell {
    bool ground = false, removed = false, stale = false;
  };
  PatchCell& at(Cell cell) {
    assert(area_.contains(cell));
    return cells_[static_cast<std::size_t>(cell.y - area_.y) * static_cast<std::size_t>(area_.w) +
                  static_cast<std::size_t>(cell.x - area_.x)];
  }

  const TileMap& map_;
  Within within_;
  const AutoTiles& set_;
  CellRect area_;
  std::vector<PatchCell> cells_;
};

// The cells that are on the map, if there are tiles for them.
std::optional<CellRect> paintable_part(const Level& level, const CellRect& cells) {
  if (level.auto_tiles.of(GroundPart::inside) == 0) return std::nullopt;
  return shared(cells, {0, 0, level.map.width(), level.map.height()});
}

std::string label_of(GroundChange change) {
  return change == GroundChange::add ? "Paint ground" : "Remove ground";
}

}  // namespace

TileNumber ground_tile(const AutoTiles& set, FunctionRef<bool(Cell)> is_ground, Cell cell) {
  using enum GroundPart;
  assert(set.of(inside) != 0);
  const Surroundings around(is_ground, cell, 1), mirrored(is_ground, cell, -1);
  if (const TileNumber tile = slope_tile(set, around, kUp)) return tile;
  if (const TileNumber tile = slope_tile(set, mirrored, kDown)) return tile;
  const bool open_left = !around.ground(-1, 0), open_right = !around.ground(1, 0);
  const bool on_left = open_left && !open_right, on_right = open_right && !open_left;
  if (!around.ground(0, -1)) {
    if (on_left) return first_of(set, {top_left, top, left, inside});
    if (on_right) return first_of(set, {top_right, top, right, inside});
    return first_of(set, {top, inside});
  }
  if (!around.ground(0, 1)) {
    if (on_left) return first_of(set, {bottom_left, bottom, left, inside});
    if (on_right) return first_of(set, {bottom_right, bottom, right, inside});
    return first_of(set, {bottom, inside});
  }
  if (on_left) return first_of(set, {left, inside});
  if (on_right) return first_of(set, {right, inside});
  return set.of(inside);
}

Edit paint_ground(const Level& level, Cell from, Cell to, GroundChange change, Within within) {
  const auto part = paintable_part(level, spanned(from, to));
  if (!part) return {label_of(change), {}};
  GroundPatch patch(level, *part, within);
  for_each_on_line(from, to, [&](Cell cell) { patch.change(cell, change); });
  return patch.finish(label_of(change));
}

Edit fill_ground(const Level& level, CellRect cells, GroundChange change, Within within) {
  const auto part = paintable_part(level, cells);
  if (!part) return {label_of(change), {}};
  GroundPatch patch(level, *part, within);
  for (int y = part->y; y < part->y + part->h; ++y) {
    for (int x = part->x; x < part->x + part->w; ++x) patch.change({x, y}, change);
  }
  return patch.finish(label_of(change));
}

namespace {

// The cells that an edit leaves, and the edit itself, in which single cells can be changed.
class EditedCells {
 public:
  EditedCells(const Level& level, Edit& edit) : level_(level), edit_(edit) {
    for (std::size_t i = 0; i < edit.changes.size(); ++i)
      if (const auto* put = std::get_if<CellChange>(&edit.changes[i])) index_[{put->cell.x, put->cell.y}] = i;
  }
  // Those that are changed, and those beside them.
  std::set<std::pair<int, int>> near_changes() const {
    std::set<std::pair<int, int>> cells;
    for (const auto& [at, index] : index_)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          if (level_.map.contains({at.first + dx, at.second + dy}))
            cells.insert({at.first + dx, at.second + dy});
    return cells;
  }
  MapCell at(Cell cell) const {
    const auto found = index_.find({cell.x, cell.y});
    return found == index_.end() ? level_.map.at(cell)
                                 : std::get<CellChange>(edit_.changes[found->second]).after;
  }
  bool is_ground(Cell cell) const {
    if (!level_.map.contains(cell)) return true;
    const TileNumber tile = at(cell).tile;
    const bool is_put = index_.count({cell.x, cell.y}) != 0;  // its shape may be a part of the edit
    return tile != 0 && (is_put || shape_of_tile(level_, tile).kind != TileShape::Kind::none);
  }
  void put(Cell cell, TileNumber tile) {
    const auto [found, is_new] = index_.try_emplace({cell.x, cell.y}, edit_.changes.size());
    if (is_new) {
      edit_.changes.emplace_back(CellChange{cell, level_.map.at(cell), tile});
    } else {
      std::get<CellChange>(edit_.changes[found->second]).after = tile;
    }
  }

 private:
  const Level& level_;
  Edit& edit_;
  std::map<std::pair<int, int>, std::size_t> index_;  // of the change of a cell
};

}  // namespace

void fit_ground(const Level& level, Edit& edit, Within within) {
  using enum GroundPart;
  AutoTiles set = level.auto_tiles;
  for (TileNumber& tile : set.tiles)
    if (!is_full(shape_of_tile(level, tile))) tile = 0;
  if (set.of(inside) == 0) return;
  EditedCells cells(level, edit);
  const auto is_ground = [&](Cell cell) { return cells.is_ground(cell); };
  for (const auto& [x, y] : cells.near_changes()) {
    const Cell cell{x, y};
    const MapCell before = cells.at(cell);
    if (!set.has(before.tile) || before.turn != TileTurn::none || (within && !within->contains(cell)))
      continue;
    const TileNumber fits = ground_tile(set, is_ground, cell);
    if (fits != before.tile) cells.put(cell, fits);
  }
  std::erase_if(edit.changes, [](const Change& change) {
    const auto* put = std::get_if<CellChange>(&change);
    return put != nullptr && put->before == put->after;
  });
}

Edit set_auto_tiles(const Level& level, const AutoTiles& tiles) {
  return single_change("Set ground tiles", AutoTilesChange{level.auto_tiles, tiles});
}

}  // namespace talus
