// Finds floors and ceilings that jump where two tiles meet, so that they stop bodies, and edges inside the
// ground.
#include <algorithm>
#include <cmath>

#include "../level_text.h"
#include "collision/tile_outlines.h"
#include "fix_parts.h"
#include "rule_group.h"
#include "seam_finder.h"

namespace talus {
namespace {

LintFix fix_floor, fix_ceiling;

constexpr LintRule kFloorSeam{
    .code = "seam",
    .label = "floor that jumps",
    .by_hand =
        "Place tiles side by side whose floors end at one height, or lay the slope again from end to end.",
    .fix = fix_floor,
    .has_seam = true};
constexpr LintRule kCeilingSeam{
    .code = "seam-ceiling",
    .label = "ceiling that jumps",
    .by_hand = "Place tiles side by side whose ceilings end at one height, or change one in the Shape tab.",
    .fix = fix_ceiling,
    .has_seam = true};
constexpr LintRule kInteriorEdge{
    .code = "interior-edge",
    .label = "edge inside the ground",
    .by_hand = "Fill the cell with a full tile, or make the opening high enough for a body."};

void check_seams(const LintContext& context, std::array<Cell, 2> area, std::vector<Problem>& out) {
  const auto [seams, cracks] = find_seams(context.level, context.tiles, area);
  for (const Seam& seam : seams) {
    report(out, seam.floor ? kFloorSeam : kCeilingSeam,
           std::string(seam.floor ? "floor" : "ceiling") + " jumps " +
               px_text(std::abs(seam.left_y - seam.right_y)) + " px between " + cell_text(seam.left) +
               " and " + cell_text(seam.right),
           seam.left);
  }
  for (const Crack& crack : cracks) {
    report(out, kInteriorEdge,
           "the ground above " + cell_text(crack.cell) + " stays open by " + px_text(crack.gap) +
               " px, too little for a body: edges inside it can catch what comes along",
           crack.cell);
  }
}

// Returns the part of the level around a cell, small enough to try fixes on. corner: gets the cell of its top
// left.
Level cut_out(const Level& level, Cell cell, int reach, Cell& corner) {
  const TileMap& map = level.map;
  corner = {std::max(cell.x - reach, 0), std::max(cell.y - reach, 0)};
  const Cell last{std::min(cell.x + reach, map.width() - 1), std::min(cell.y + reach, map.height() - 1)};
  Level local;
  local.sheets = level.sheets;
  local.roles = level.roles;
  local.tile_shapes = level.tile_shapes;
  local.flag_shapes = level.flag_shapes;
  local.tuning = level.tuning;
  local.map = TileMap(last.x - corner.x + 1, last.y - corner.y + 1, map.tile_size());
  for (Cell c = corner; c.y <= last.y; ++c.y) {
    for (c.x = corner.x; c.x <= last.x; ++c.x)
      local.map.set({c.x - corner.x, c.y - corner.y}, map.tile_at(c));
  }
  return local;
}

class SeamFixer {
 public:
  SeamFixer(const Level& level, const LintTiles& tiles, const Seam& seam)
      : level_(level), tiles_(tiles), seam_(seam) {}

  std::vector<Edit> fixes() {
    go_on(true);
    go_on(false);
    // Whole px first: a part of a px is more likely the mistake.
    const bool left_first = is_whole(seam_.right_y) || !is_whole(seam_.left_y);
    change_height(left_first);
    change_height(!left_first);
    keep_the_best();
    return std::move(edits_);
  }

 private:
  const TileShape* shape_at(Cell cell) {
    shape_ = shape_of_tile(level_, level_.map.tile_at(cell));
    return is_line_shape(shape_) && shape_.heights.size() > 1 ? &shape_ : nullptr;
  }
  double left_end(const TileShape& shape, Cell cell) const { return end(shape, cell, shape.heights.front()); }
  double right_end(const TileShape& shape, Cell cell) const { return end(shape, cell, shape.heights.back()); }
  double end(const TileShape& shape, Cell cell, double height) const {
    const bool floor = shape.side == TileShape::Side::floor;
    const double base = level_.map.y_of(floor ? cell.y + 1 : cell.y);
    return floor ? base - weld(height) : base + weld(height);
  }

  static bool is_whole(double y) { return y == std::floor(y); }

  // Adds the fix that puts the slope's next tile on the sheet beside it on the map, if that tile continues at
  // the same height and the cell is empty.
  void go_on(bool right) {
    const Cell tile = right ? seam_.left_tile : seam_.right_tile;
    const TileShape* shape = shape_at(tile);
    if (shape == nullptr) return;
    const int by = right ? shape->tiles : -1;
    const double y = right ? seam_.left_y : seam_.right_y;
    const auto next = beside(level_, level_.map.tile_at(tile), by);
    if (!next) return;
    for (int dy = -1; dy <= 1; ++dy) {
      const Cell cell{tile.x + by, tile.y + dy};
      if (!level_.map.contains(cell) || !tiles_.is_empty(level_.map.tile_at(cell))) continue;
      const TileShape other = shape_of_tile(level_, *next);
      if (!is_line_shape(other) || other.heights.size() < 2 || (!right && other.tiles != 1)) continue;
      if ((right ? left_end(other, cell) : right_end(other, cell)) != y) continue;
      edits_.push_back(put_tile(
          level_, cell, *next,
          "Place " + tile_text(*next) + ", which goes on at the same height, at " + cell_text(cell)));
      return;
    }
  }

  // Moves the pixels of each column of a tile with its line; not in true colour, nor of a slope that reaches
  // over several tiles, nor if nothing would be seen.
  void move_pixels(TileNumber tile, const TileShape& before, const TileShape& after, Edit& edit) const {
    const Sheet& sheet = level_.sheet(SheetId::tiles);
    const TileSize size = level_.map.tile_size();
    const auto is_high = [&](const TileShape& shape) {
      return *std::max_element(shape.heights.begin(), shape.heights.end()) > size.height;
    };
    if (sheet.picture != nullptr || before.tiles != 1 || is_high(before) || is_high(after)) return;
    const TileImage& old = sheet.images[tile];
    const bool is_floor = before.side == TileShape::Side::floor;
    TileImage moved{};
    for (int x = 0; x < kCartTileSize; ++x) {
      const auto row_of = [&](const TileShape& shape) {
        const double height = height_of_line(shape, (x + 0.5) * size.width / kCartTileSize, size);
        return static_cast<int>(std::lround(height * kCartTileSize / size.height));
      };
      // Of the old picture; its last row goes on behind it.
      const auto color_at = [&](int y) -> std::uint8_t {
        if (y >= 0 && y < kCartTileSize) return old[y * kCartTileSize + x];
        return is_floor == (y > 0) ? old[(is_floor ? kCartTileSize - 1 : 0) * kCartTileSize + x] : 0;
      };
      const int grown = row_of(after) - row_of(before);
      for (int y = 0; y < kCartTileSize; ++y)
        moved[y * kCartTileSize + x] = color_at(is_floor ? y + grown : y - grown);
    }
    if (moved == TileImage{}) return;
    for (int pixel = 0; pixel < kCartTileSize * kCartTileSize; ++pixel)
      if (old[pixel] != moved[pixel])
        edit.changes.emplace_back(PixelChange{SheetId::tiles, tile, pixel, old[pixel], moved[pixel]});
  }

  // Adds the fix that raises or lowers the end of a slope's tile to the other side.
  void change_height(bool left) {
    const Cell at = left ? seam_.left_tile : seam_.right_tile;
    const TileShape* before = shape_at(at);
    if (before == nullptr) return;
    const TileNumber tile = level_.map.tile_at(at);
    TileShape after = *before;
    double& height = left ? after.heights.back() : after.heights.front();
    const double now = height;
    const double up = left ? seam_.left_y - seam_.right_y : seam_.right_y - seam_.left_y;
    height += after.side == TileShape::Side::floor ? up : -up;
    const bool is_nothing =
        std::all_of(after.heights.begin(), after.heights.end(), [](double h) { return h == 0; });
    if (is_nothing || problem_of(after, level_.map.tile_size())) return;
    edits_.push_back(single_change(std::string(height > now ? "Raise" : "Lower") + " the " +
                                       (left ? "right" : "left") + " end of " + tile_text(tile) +
                                       "'s slope from " + px_text(now) + " to " + px_text(height) +
                                       " px, in every cell with that tile",
                                   TileShapeChange{tile, level_.tile_shapes[tile], after}));
    move_pixels(tile, *before, after, edits_.back());
  }

  // Sorts the fixes by the number of problems that they leave around. Fixes that leave more problems than
  // before are dropped.
  void keep_the_best() {
    Cell corner;
    Level local = cut_out(level_, seam_.left, 2 * tiles_.reach(), corner);
    const auto problems = [&] {
      const LintTiles facts(local, {tiles_.seam()});
      std::vector<Problem> found;
      check_area({local, facts}, {Cell{0, 0}, Cell{local.map.width() - 1, local.map.height() - 1}}, found);
      return found.size();
    };
    const std::size_t now = problems();
    std::vector<std::pair<std::size_t, Edit>> rated;
    for (Edit& edit : edits_) {
      Edit there = edit;
      if (auto* cell = std::get_if<CellChange>(&there.changes.front()))
        cell->cell = {cell->cell.x - corner.x, cell->cell.y - corner.y};
      apply_edit(local, there);
      const std::size_t then = problems();
      revert_edit(local, there);
      if (then < now) rated.emplace_back(then, std::move(edit));
    }
    std::stable_sort(rated.begin(), rated.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    edits_.clear();
    for (auto& [left, edit] : rated) edits_.push_back(std::move(edit));
  }

  const Level& level_;
  const LintTiles& tiles_;
  const Seam seam_;
  TileShape shape_;
  std::vector<Edit> edits_;
};

void fix_seam(const LintContext& context, Cell cell, bool floor, std::vector<Edit>& out) {
  for (const Seam& seam : find_seams(context.level, context.tiles, {cell, cell}).seams) {
    if (seam.floor != floor) continue;
    for (Edit& edit : SeamFixer(context.level, context.tiles, seam).fixes()) out.push_back(std::move(edit));
    return;
  }
}
void fix_floor(const LintContext& context, const Problem& problem, std::vector<Edit>& out) {
  fix_seam(context, *problem.cell, true, out);
}
void fix_ceiling(const LintContext& context, const Problem& problem, std::vector<Edit>& out) {
  fix_seam(context, *problem.cell, false, out);
}

}  // namespace

const RuleGroup& seam_rules() {
  static constexpr const LintRule* kRules[] = {&kFloorSeam, &kCeilingSeam, &kInteriorEdge};
  static constexpr RuleGroup kGroup{.rules = kRules, .check_area = check_seams};
  return kGroup;
}

}  // namespace talus
