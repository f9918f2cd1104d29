// Fixes of slopes: their halves, their flags and their heights.
#include <algorithm>
#include <cmath>

#include "edit/single_change.h"
#include "fix_parts.h"
#include "level/level_text.h"
#include "lint_parts.h"

namespace talus {
namespace {

// The tile that is drawn beside another one on the sheet; none: the sheet ends there.
std::optional<std::uint8_t> beside(int tile, int by) {
  const int column = tile % kSheetColumns + by;
  if (column < 0 || column >= kSheetColumns) return std::nullopt;
  return static_cast<std::uint8_t>(tile + by);
}

void fix_missing_half(const Level& level, const LintTiles& tiles, const Problem& problem,
                      std::vector<Edit>& out) {
  const Cell cell = *problem.cell;
  for (int i = 1; i < tiles.slope_cells(); ++i) {
    const Cell right{cell.x + i, cell.y};
    if (!level.map.contains(right)) {
      out.push_back(put_tile(level, cell, 0,
                             "Take " + tile_text(problem.tile) + " away from " + cell_text(cell) +
                                 ", where the map cuts it off"));
      return;
    }
    if (!tiles.is_empty(level.map.at(right))) continue;
    const auto half = beside(problem.tile, i);
    if (!half || tiles[*half].blank || tiles[*half].solid || tiles.is_slope(*half)) return;
    out.push_back(put_tile(level, right, *half,
                           "Place " + tile_text(*half) + ", the slope's right half, at " + cell_text(right)));
    return;
  }
}

// The tiles that lie on the sheet around the shape's as its cells do on the map. None where one of them is
// not drawn, or is something to the physics itself.
void fix_undrawn_shape(const Level& level, const LintTiles& tiles, const Problem& problem,
                       std::vector<Edit>& out) {
  const Cell cell = *problem.cell;
  Edit edit;
  for (const Cell at : undrawn_cells(level, tiles, cell)) {
    const int row = problem.tile / kSheetColumns + at.y - cell.y;
    const auto right = beside(problem.tile, at.x - cell.x);
    if (!right || row < 0 || row >= kSheetColumns) return;
    const auto tile = static_cast<std::uint8_t>(*right + (at.y - cell.y) * kSheetColumns);
    if (tiles[tile].blank || !tiles[tile].shapeless) return;
    edit.changes.emplace_back(CellChange{at, level.map.at(at), tile});
  }
  const auto& first = std::get<CellChange>(edit.changes.front());
  const bool is_one = edit.changes.size() == 1;
  edit.label = "Place " + (is_one ? tile_text(first.after) : std::to_string(edit.changes.size()) + " tiles") +
               ", the rest of " + tile_text(problem.tile) + "'s shape, at " + cell_text(first.cell) +
               (is_one ? "" : " and on");
  out.push_back(std::move(edit));
}

void fix_overlap(const Level& level, const LintTiles& tiles, const Problem& problem, std::vector<Edit>& out) {
  for (int i = 1; i < tiles.slope_cells(); ++i) {
    const Cell right{problem.cell->x + i, problem.cell->y};
    if (!level.map.contains(right)) return;
    const std::uint8_t tile = level.map.at(right);
    if (!tiles[tile].solid && !tiles.is_slope(tile)) continue;
    const auto half = beside(problem.tile, i);
    if (tiles.is_slope(tile) && half == tile) {
      const TileRole role = tiles[tile].role;
      const int flag = role == TileRole::up_slope ? level.roles.up_slope : level.roles.down_slope;
      const std::uint8_t flags = level.tile_flags(tile);
      out.push_back(single_change(
          "Clear the " + role_label(role) + " flag of " + tile_text(tile) + ", the slope's right half",
          FlagsChange{SheetId::tiles, tile, flags, static_cast<std::uint8_t>(flags & ~(1 << flag))}));
    } else if (half && !tiles[*half].blank && !tiles[*half].solid && !tiles.is_slope(*half)) {
      out.push_back(put_tile(level, right, *half,
                             "Put " + tile_text(*half) + ", the slope's right half, in the place of " +
                                 tile_text(tile) + " at " + cell_text(right)));
    }
    return;
  }
}

void fix_missing_left(const Level& level, const LintTiles& tiles, const Problem& problem,
                      std::vector<Edit>& out) {
  const Cell cell = *problem.cell, left{cell.x - 1, cell.y};
  const int half_of = tiles[static_cast<std::size_t>(problem.tile)].half_of;
  if (level.map.contains(left) && tiles.is_empty(level.map.at(left))) {
    out.push_back(put_tile(level, left, static_cast<std::uint8_t>(half_of),
                           "Place " + tile_text(half_of) + ", the slope's left half, at " + cell_text(left)));
  }
  out.push_back(
      put_tile(level, cell, 0, "Take " + tile_text(problem.tile) + " away from " + cell_text(cell)));
}

void fix_unflagged(const Level& level, const LintTiles& tiles, const Problem& problem,
                   std::vector<Edit>& out) {
  const int like = tiles[static_cast<std::size_t>(problem.tile)].like;
  const auto tile = static_cast<std::uint8_t>(problem.tile);
  const TileRole role = tiles[static_cast<std::size_t>(like)].role;
  const int flag = role == TileRole::up_slope ? level.roles.up_slope : level.roles.down_slope;
  const std::uint8_t flags = level.tile_flags(tile);
  out.push_back(
      single_change("Set flag " + std::to_string(flag) + ", " + role_label(role) + ", of " + tile_text(tile),
                    FlagsChange{SheetId::tiles, tile, flags, static_cast<std::uint8_t>(flags | 1 << flag)}));
}

// What a level is around a cell: small enough to try something on it.
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
  local.map = TileMap(last.x - corner.x + 1, last.y - corner.y + 1);
  for (Cell c = corner; c.y <= last.y; ++c.y) {
    for (c.x = corner.x; c.x <= last.x; ++c.x) local.map.set({c.x - corner.x, c.y - corner.y}, map.at(c));
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
    change_height(true);
    change_height(false);
    keep_the_best();
    return std::move(edits_);
  }

 private:
  const TileShape* shape_at(Cell cell) {
    shape_ = shape_of_tile(level_, level_.map.at(cell));
    return is_line_shape(shape_) && shape_.heights.size() > 1 ? &shape_ : nullptr;
  }
  static double left_end(const TileShape& shape, Cell cell) {
    return end(shape, cell, shape.heights.front());
  }
  static double right_end(const TileShape& shape, Cell cell) {
    return end(shape, cell, shape.heights.back());
  }
  static double end(const TileShape& shape, Cell cell, double height) {
    const bool floor = shape.side == TileShape::Side::floor;
    const double base = (cell.y + (floor ? 1.0 : 0.0)) * kTileSize;
    return floor ? base - weld(height) : base + weld(height);
  }

  // Puts the tile that is drawn beside a slope's on the sheet beside it on the map, where that goes on at the
  // same height, and where nothing is yet.
  void go_on(bool right) {
    const Cell tile = right ? seam_.left_tile : seam_.right_tile;
    const TileShape* shape = shape_at(tile);
    if (shape == nullptr) return;
    const int by = right ? shape->tiles : -1;
    const double y = right ? seam_.left_y : seam_.right_y;
    const auto next = beside(level_.map.at(tile), by);
    if (!next) return;
    for (int dy = -1; dy <= 1; ++dy) {
      const Cell cell{tile.x + by, tile.y + dy};
      if (!level_.map.contains(cell) || !tiles_.is_empty(level_.map.at(cell))) continue;
      const TileShape other = shape_of_tile(level_, *next);
      if (!is_line_shape(other) || other.heights.size() < 2 || (!right && other.tiles != 1)) continue;
      if ((right ? left_end(other, cell) : right_end(other, cell)) != y) continue;
      edits_.push_back(put_tile(
          level_, cell, *next,
          "Place " + tile_text(*next) + ", which goes on at the same height, at " + cell_text(cell)));
      return;
    }
  }

  // Raises or lowers the end of a slope's tile to the other side.
  void change_height(bool left) {
    const Cell at = left ? seam_.left_tile : seam_.right_tile;
    const TileShape* before = shape_at(at);
    if (before == nullptr) return;
    const std::uint8_t tile = level_.map.at(at);
    TileShape after = *before;
    double& height = left ? after.heights.back() : after.heights.front();
    const double now = height;
    const double up = left ? seam_.left_y - seam_.right_y : seam_.right_y - seam_.left_y;
    height += after.side == TileShape::Side::floor ? up : -up;
    const bool is_nothing =
        std::all_of(after.heights.begin(), after.heights.end(), [](double h) { return h == 0; });
    if (is_nothing || problem_of(after)) return;
    edits_.push_back(single_change(std::string(height > now ? "Raise" : "Lower") + " the " +
                                       (left ? "right" : "left") + " end of " + tile_text(tile) +
                                       "'s slope from " + px_text(now) + " to " + px_text(height) +
                                       " px, wherever the tile is",
                                   TileShapeChange{tile, level_.tile_shapes[tile], after}));
  }

  // What leaves the fewest problems around comes first, and what leaves more than there were not at all.
  void keep_the_best() {
    Cell corner;
    Level local = cut_out(level_, seam_.left, 2 * tiles_.reach(), corner);
    const auto problems = [&] {
      const LintTiles facts(local, {tiles_.seam()});
      std::vector<Problem> found;
      lint_cells(local, facts, {Cell{0, 0}, Cell{local.map.width() - 1, local.map.height() - 1}}, found);
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

}  // namespace

void fix_slope(const Level& level, const LintTiles& tiles, const Problem& problem, std::vector<Edit>& out) {
  const bool is_flagged = problem.tile >= 0 && tiles.is_slope(static_cast<std::size_t>(problem.tile));
  if (problem.code == "slope-half-missing" && is_flagged) fix_missing_half(level, tiles, problem, out);
  if (problem.code == "slope-half-missing" && !is_flagged) fix_undrawn_shape(level, tiles, problem, out);
  if (problem.code == "slope-left-missing") fix_missing_left(level, tiles, problem, out);
  if (problem.code == "slope-overlap") fix_overlap(level, tiles, problem, out);
  if (problem.code == "slope-unflagged") fix_unflagged(level, tiles, problem, out);
}

void fix_seam(const Level& level, const LintTiles& tiles, const Problem& problem, std::vector<Edit>& out) {
  for (const Seam& seam : seams_in(level, tiles, {*problem.cell, *problem.cell})) {
    if (seam.floor != (problem.code == "seam")) continue;
    for (Edit& edit : SeamFixer(level, tiles, seam).fixes()) out.push_back(std::move(edit));
    return;
  }
}

void fix_steepness(const Level& level, const Problem& problem, std::vector<Edit>& out) {
  const auto tile = static_cast<std::uint8_t>(problem.tile);
  TileShape shape = shape_of_tile(level, tile);
  const double steepest = level.tuning.exact.steepest;
  const double width = shape.tiles * kTileSize / static_cast<double>(shape.heights.size() - 1);
  double rise = 0;
  for (std::size_t i = 1; i < shape.heights.size(); ++i)
    rise = std::max(rise, std::abs(shape.heights[i] - shape.heights[i - 1]));
  if (shape.kind == TileShape::Kind::slope) {
    const bool rises = shape.heights[0] < shape.heights[1];
    const double low = std::min(shape.heights[0], shape.heights[1]);
    double& high = shape.heights[rises ? 1 : 0];
    const std::string from = px_text(high);
    high = low + width * steepest;
    out.push_back(single_change("Lower the " + std::string(rises ? "right" : "left") + " end of " +
                                    tile_text(tile) + "'s slope from " + from + " to " + px_text(high) +
                                    " px, wherever the tile is",
                                TileShapeChange{tile, level.tile_shapes[tile], shape}));
  }
  Tuning tuning = level.tuning;
  tuning.exact.steepest = std::ceil(rise / width);
  out.push_back(single_change("Let floors rise by " + px_text(tuning.exact.steepest) +
                                  " px for each px, in the whole level (steepest floor, in Tuning)",
                              TuningChange{level.tuning, tuning}));
}

}  // namespace talus
