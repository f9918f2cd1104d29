// Looks at the places that a fix changes, first with the fix and then without it.
#include "fix_trial.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <tuple>

#include "ground_faults.h"
#include "rule_group.h"

namespace talus {

const RuleGroup& spawn_rules();  // at the end of spawn_rules.cpp

namespace {

using Area = std::array<Cell, 2>;  // the first and the last cell

constexpr int kBlock = 16;                          // side of the blocks that the lint looks at, cells
constexpr std::size_t kMaxBlocks = 128;             // that the lint looks at for a fix: some ms
constexpr std::size_t kMaxPlaces = 256;             // whose outline is compared for a fix
constexpr int kColumnsBeside = 3, kRowsBeside = 2;  // cells around a place whose outline is compared
// Of a map all of whose tiles are looked at again, as the rules of solvers do.
constexpr std::size_t kMaxCellsToCount = std::size_t{1} << 20;

Area clipped(const TileMap& map, Area area) {
  return {Cell{std::max(area[0].x, 0), std::max(area[0].y, 0)},
          Cell{std::min(area[1].x, map.width() - 1), std::min(area[1].y, map.height() - 1)}};
}

// What a fix changes.
struct Changed {
  std::set<int> tiles;      // whose facts change
  std::vector<Cell> cells;  // of the map, whose ground may change
  bool is_all = false;      // whether it is more than tiles, cells and bodies: all tiles may change
};

Changed changed_by(const Edit& edit) {
  Changed changed;
  for (const Change& change : edit.changes) {
    if (const auto* cell = std::get_if<CellChange>(&change))
      changed.cells.push_back(cell->cell);
    else if (const auto* shape = std::get_if<TileShapeChange>(&change))
      changed.tiles.insert(shape->tile);
    else if (const auto* flags = std::get_if<FlagsChange>(&change))
      changed.tiles.insert(flags->tile);
    else if (const auto* pixel = std::get_if<PixelChange>(&change))
      changed.tiles.insert(pixel->tile);
    else if (!std::holds_alternative<SpawnsChange>(change))
      changed.is_all = true;
  }
  return changed;
}

// Adds the cells with tiles that have another shape then. Returns false if there are too many.
bool add_cells_of_tiles(const TileMap& map, const LintTiles& before, const LintTiles& after,
                        Changed& changed) {
  std::vector<bool> is_other(before.count());
  bool any = false;
  for (const int tile : changed.tiles)
    any |= is_other[static_cast<std::size_t>(tile)] = before.shape(tile) != after.shape(tile);
  if (!any) return true;
  for (Cell c{0, 0}; c.y < map.height(); ++c.y) {
    for (c.x = 0; c.x < map.width(); ++c.x) {
      if (!is_other[map.tile_at(c)]) continue;
      if (changed.cells.size() == kMaxPlaces) return false;
      changed.cells.push_back(c);
    }
  }
  return true;
}

class Trial {
 public:
  Trial(Level& level, const LintTiles& tiles, const Edit& edit)
      : level_(level), before_(tiles), edit_(edit) {}

  bool is_good(const LintOptions& options) {
    Changed changed = changed_by(edit_);
    apply_edit(level_, edit_);
    std::unique_ptr<const LintTiles> other;
    if (changed.is_all || !changed.tiles.empty()) other = std::make_unique<LintTiles>(level_, options);
    const LintTiles& after = other ? *other : before_;
    const bool is_seen = note_places(after, changed);
    Findings now;
    if (is_seen) now = findings(after, changed);
    const GroundFaults faults(level_, after, outlines_);
    revert_edit(level_, edit_);
    return is_seen && is_less(now, findings(before_, changed)) &&
           !faults.has_more_than({level_, before_, outlines_});
  }

 private:
  // How many problems of a rule there are at a cell, of a tile (in a row of its own), or of the level.
  using Findings = std::map<std::tuple<const LintRule*, int, int>, int>;
  static constexpr int kTileRow = -1, kLevelRow = -2;

  // Notes where the outline and the problems may change. Returns false if there are too many places.
  bool note_places(const LintTiles& after, Changed& changed) {
    const TileMap& map = level_.map;
    if (!add_cells_of_tiles(map, before_, after, changed)) return false;
    if (changed.cells.size() > kMaxPlaces) return false;
    const int reach = std::max(before_.reach(), after.reach());
    for (const Cell cell : changed.cells) {
      note_outline(after, cell);
      const Area around =
          clipped(map, {Cell{cell.x - reach, cell.y - reach}, Cell{cell.x + reach, cell.y + reach}});
      for (int y = around[0].y / kBlock; y <= around[1].y / kBlock; ++y)
        for (int x = around[0].x / kBlock; x <= around[1].x / kBlock; ++x) blocks_.insert({y, x});
    }
    return blocks_.size() <= kMaxBlocks;
  }

  // Notes the cells whose outline depends on the tile that is in a cell before or after the fix.
  void note_outline(const LintTiles& after, Cell cell) {
    Area area{cell, cell};
    const auto add = [&](const TileOutline& outline) {
      if (!outline.line) return;
      area[0] = {std::min(area[0].x, cell.x + outline.touched[0].x),
                 std::min(area[0].y, cell.y + outline.touched[0].y)};
      area[1] = {std::max(area[1].x, cell.x + outline.touched[1].x),
                 std::max(area[1].y, cell.y + outline.touched[1].y)};
    };
    add(after.outlines()[level_.map.tile_at(cell)]);  // the level has the fix
    add(before_.outlines()[level_.map.tile_at(cell)]);
    for (const Change& change : edit_.changes) {
      const auto* put = std::get_if<CellChange>(&change);
      if (put != nullptr && put->cell == cell) add(before_.outlines()[put->before.tile]);
    }
    outlines_.push_back(clipped(level_.map, {Cell{area[0].x - kColumnsBeside, area[0].y - kRowsBeside},
                                             Cell{area[1].x + kColumnsBeside, area[1].y + kRowsBeside}}));
  }

  Findings findings(const LintTiles& tiles, const Changed& changed) const {
    const LintContext context{level_, tiles};
    Findings all;
    std::vector<Problem> found;
    const auto note = [&](auto place_of) {
      for (const Problem& problem : found) {
        const Cell place = place_of(problem);
        ++all[{problem.rule, place.x, place.y}];
      }
      found.clear();
    };
    for (const auto& [y, x] : blocks_) {
      check_area(context,
                 clipped(level_.map,
                         {Cell{x * kBlock, y * kBlock}, Cell{(x + 1) * kBlock - 1, (y + 1) * kBlock - 1}}),
                 found);
    }
    note([](const Problem& problem) { return *problem.cell; });
    for (int tile = 0; tile < level_.tile_count(); ++tile)
      if (changed.is_all || changed.tiles.contains(tile)) check_tile(context, tile, found);
    note([](const Problem& problem) { return Cell{problem.tile, kTileRow}; });
    // A body that moves takes its other problems with it, so that the level's have no place here.
    if (!changed.is_all && !changed.cells.empty() && level_.map.cells().size() > kMaxCellsToCount)
      spawn_rules().check_level(context, found);
    else
      check_level(context, found);
    note([](const Problem&) { return Cell{0, kLevelRow}; });
    return all;
  }

  static bool is_less(const Findings& now, const Findings& before) {
    int fewer = 0;
    for (const auto& [place, count] : before) fewer += count;
    for (const auto& [place, count] : now) {
      const auto known = before.find(place);
      if (known == before.end() || count > known->second) return false;
      fewer -= count;
    }
    return fewer > 0;
  }

  Level& level_;
  const LintTiles& before_;
  const Edit& edit_;
  std::set<std::pair<int, int>> blocks_;  // by row and column, whose cells may have other problems
  std::vector<Area> outlines_;            // whose outline may change
};

}  // namespace

bool is_good_fix(Level& level, const LintTiles& tiles, const LintOptions& options, const Edit& edit) {
  return Trial(level, tiles, edit).is_good(options);
}

}  // namespace talus
