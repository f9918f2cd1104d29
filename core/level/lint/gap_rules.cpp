// Finds gaps that lead somewhere but are too small for a player.
#include <cmath>

#include "../level_text.h"
#include "rule_group.h"

namespace talus {
namespace {

constexpr LintRule kGap{
    .code = "gap-too-small",
    .label = "gap too small for a player",
    .by_hand = "Take tiles away until the player fits, or close the gap with full tiles."};

// Looks at the map as it is, or with rows and columns exchanged: then the code for the height of tunnels also
// checks the width of shafts.
class GapFinder {
 public:
  // size: of the player across the gaps, px.
  GapFinder(const Level& level, const LintTiles& tiles, bool turned, double size, std::vector<Problem>& out)
      : level_(level),
        tiles_(tiles),
        turned_(turned),
        size_(size),
        tile_(turned ? level.map.tile_size().width : level.map.tile_size().height),
        needed_(static_cast<int>(std::ceil(size / tile_))),
        out_(out) {}

  // cell: on the map, with x and y exchanged if `turned`.
  void check(Cell cell) {
    if (!is_clear(cell) || !is_full({cell.x, cell.y - 1})) return;
    const int cells = clear_below(cell);
    if (cells >= needed_ || !is_full({cell.x, cell.y + cells})) return;
    const int bottom = cell.y + cells - 1;
    if (!is_wide({cell.x - 1, bottom})) return;
    for (int x = cell.x + 1; x <= cell.x + LintTiles::kLongestGap; ++x) {
      if (!is_clear({x, bottom})) return;  // it leads nowhere
      if (is_wide({x, bottom})) break;
    }
    add(cell, cells);
  }

 private:
  Cell on_map(Cell c) const { return turned_ ? Cell{c.y, c.x} : c; }
  bool is_full(Cell c) const {
    return level_.map.contains(on_map(c)) && tiles_[level_.map.tile_at(on_map(c))].solid;
  }
  bool is_clear(Cell c) const {
    const Cell at = on_map(c);
    if (!level_.map.contains(at)) return at.y < 0 && at.x >= 0 && at.x < level_.map.width();  // the sky
    const LintTiles::Tile& tile = tiles_[level_.map.tile_at(at)];
    return !tile.solid && !tile.line;
  }
  // Counts the clear cells from this one down, up to the number that a player needs.
  int clear_below(Cell c) const {
    int cells = 0;
    while (cells < needed_ && is_clear({c.x, c.y + cells})) ++cells;
    return cells;
  }
  // Whether a player fits into the gap at this clear cell.
  bool is_wide(Cell c) const {
    if (!is_clear(c)) return false;
    int cells = clear_below(c);
    for (int y = c.y - 1; cells < needed_ && is_clear({c.x, y}); --y) ++cells;
    return cells >= needed_;
  }

  void add(Cell cell, int cells) {
    const Cell at = on_map(cell);
    report(out_, kGap,
           "the gap at " + cell_text(at) + " is " + std::to_string(cells * tile_) + " px " +
               (turned_ ? "wide, and a player is " : "high, and a player is ") + px_text(size_) + " px",
           at);
  }

  const Level& level_;
  const LintTiles& tiles_;
  const bool turned_;
  const double size_;
  const int tile_;    // px, of a cell across the gaps
  const int needed_;  // cells
  std::vector<Problem>& out_;
};

void check_gaps(const LintContext& context, std::array<Cell, 2> area, std::vector<Problem>& out) {
  const auto& [level, tiles, has_balls] = context;
  if (!tiles.player()) return;
  const auto [width, height] = *tiles.player();
  GapFinder tunnels(level, tiles, false, height, out), shafts(level, tiles, true, width, out);
  for (Cell c = area[0]; c.y <= area[1].y; ++c.y) {
    for (c.x = area[0].x; c.x <= area[1].x; ++c.x) {
      if (height > level.map.tile_size().height) tunnels.check(c);
      if (width > level.map.tile_size().width) shafts.check({c.y, c.x});
    }
  }
}

}  // namespace

const RuleGroup& gap_rules() {
  static constexpr const LintRule* kRules[] = {&kGap};
  static constexpr RuleGroup kGroup{.rules = kRules, .check_area = check_gaps};
  return kGroup;
}

}  // namespace talus
