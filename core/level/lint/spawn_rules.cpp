// Finds bodies that start inside the ground, off the map or too fast, and levels without a body.
#include <algorithm>
#include <cmath>

#include "../body_place.h"
#include "../level_text.h"
#include "../local_ground.h"
#include "collision/ground_queries.h"
#include "fix_parts.h"
#include "rule_group.h"

namespace talus {
namespace {

LintFix fix_inside, fix_outside;

constexpr LintRule kInSolid{.code = "spawn-in-solid",
                            .label = "body inside a tile",
                            .by_hand = "Move the body to a free place, or take the ground there away.",
                            .severity = Severity::error,
                            .fix = fix_inside};
constexpr LintRule kInSlope{.code = "spawn-in-slope",
                            .label = "body inside a slope",
                            .by_hand = "Move the body to a free place, or take the ground there away.",
                            .severity = Severity::error,
                            .fix = fix_inside};
constexpr LintRule kOutside{.code = "spawn-outside",
                            .label = "body off the map",
                            .by_hand = "Move the body onto the map.",
                            .fix = fix_outside};
constexpr LintRule kTooFast{.code = "spawn-too-fast",
                            .label = "body that is too fast",
                            .by_hand = "Give the body a lower speed in the inspector."};
constexpr LintRule kNoBodies{.code = "no-bodies",
                             .label = "nothing to move",
                             .by_hand = "Place a body with the body tool, or paint a ball tile."};

constexpr double kFastest = 4096;  // px/frame; the solvers limit speeds to this after a step

// Returns how many px a body of this size with this top left corner (px) lies below the floor that the
// article computes for a slope flagged in the cell. Returns 0 if it is above the floor, or beside the slope's
// box.
double depth_in_slope(const Level& level, Vec2 corner, Vec2 size, Cell at) {
  const double w = level.tuning.shared.slope_width, h = level.tuning.shared.slope_height;
  const Vec2 slope = level.map.corner_of(at);
  const bool overlaps = corner.x < slope.x + w && corner.x + size.x > slope.x && corner.y < slope.y + h &&
                        corner.y + size.y > slope.y;
  if (!overlaps) return 0;
  const double along = std::clamp(corner.x + size.x / 2 - slope.x, 0.0, w) / w;
  const double drop = level.role_at(at) == TileRole::up_slope ? h * (1 - along) : h * along;
  return std::max(0.0, corner.y - (slope.y - h + drop));
}

class SpawnLinter {
 public:
  SpawnLinter(const LintContext& context, std::vector<Problem>& out)
      : level_(context.level), tiles_(context.tiles), out_(out) {}

  void check(int index) {
    const Spawn& spawn = level_.spawns[static_cast<std::size_t>(index)];
    const Vec2 corner = spawn.position, size = spawn.size;
    const std::string subject =
        spawn_name(level_, index) + " at " + px_text(corner.x) + ", " + px_text(corner.y) + " px";
    const double width = level_.map.px_width(), height = level_.map.px_height();
    const bool inside =
        corner.x >= 0 && corner.y >= 0 && corner.x + size.x <= width && corner.y + size.y <= height;
    // Farther away there are no tiles, and the cell may not fit into an int.
    const bool touches = corner.x > -size.x && corner.y > -size.y && corner.x < width && corner.y < height;
    const std::optional<Cell> cell = nearest_cell(level_.map, corner);
    if (!inside) report(out_, kOutside, subject + " is partly or wholly off the map", cell, -1, index);
    const double speed = std::max(std::abs(spawn.velocity.x), std::abs(spawn.velocity.y));
    if (speed > kFastest)
      report(out_, kTooFast,
             subject + " starts with " + px_text(speed) +
                 " px/frame; after the first step speeds are cut to " + px_text(kFastest) + " px/frame",
             cell, -1, index);
    if (touches && !is_in_solid(index, subject, cell) && !is_in_slope(index, subject, cell))
      check_shapes(index, subject, cell);
  }

 private:
  // Calls visit(cell) for the cells of the map from the one at `first` px to the one before `end` px, until
  // it returns true. Returns whether it did.
  template <class Visit>
  bool any_cell(Vec2 first, Vec2 end, Visit visit) const {
    const TileSize tile = level_.map.tile_size();
    const int x1 = std::min(level_.map.width(), static_cast<int>(std::ceil(end.x / tile.width)));
    const int y1 = std::min(level_.map.height(), static_cast<int>(std::ceil(end.y / tile.height)));
    for (int y = std::max(0, level_.map.row_at(first.y)); y < y1; ++y) {
      for (int x = std::max(0, level_.map.column_at(first.x)); x < x1; ++x) {
        if (visit(Cell{x, y})) return true;
      }
    }
    return false;
  }

  // Reports the first solid tile that the body overlaps. Returns false if there is none, or if only a corner
  // of a body that stands on a slope is in it.
  bool is_in_solid(int index, const std::string& subject, std::optional<Cell> cell) {
    const Spawn& spawn = level_.spawns[static_cast<std::size_t>(index)];
    std::optional<Cell> met;
    any_cell(spawn.position, spawn.position + spawn.size, [&](Cell at) {
      if (tiles_[level_.map.tile_at(at)].solid) met = at;
      return met.has_value();
    });
    if (!met) return false;
    if (level_.tuning.solver == SolverKind::exact && !starts_in_ground(level_, spawn)) return false;
    report(out_, kInSolid, subject + " starts inside the solid tile at " + cell_text(*met), cell, -1, index);
    return true;
  }

  // Reports the first slope below whose floor the body starts, as the article computes that floor. Returns
  // false if there is none.
  bool is_in_slope(int index, const std::string& subject, std::optional<Cell> cell) {
    const Spawn& spawn = level_.spawns[static_cast<std::size_t>(index)];
    const Vec2 reach = {level_.tuning.shared.slope_width, level_.tuning.shared.slope_height};
    return any_cell(spawn.position - reach, spawn.position + spawn.size, [&](Cell at) {
      const TileNumber tile = level_.map.tile_at(at);
      if (!tiles_.is_slope(tile) || tiles_[tile].own_shape) return false;
      const double depth = depth_in_slope(level_, spawn.position, spawn.size, at);
      if (!(depth > 0)) return false;
      report(out_, kInSlope,
             subject + " starts " + px_text(depth) + " px inside the " + role_label(tiles_[tile].role) +
                 " at " + cell_text(at),
             cell, -1, index);
      return true;
    });
  }

  // Reports slopes and profiles that have no flag or role, if the level's solver knows them.
  void check_shapes(int index, const std::string& subject, std::optional<Cell> cell) {
    if (level_.tuning.solver != SolverKind::exact) return;
    const Spawn& spawn = level_.spawns[static_cast<std::size_t>(index)];
    // A circle may touch a slope that the corners of its box are in.
    const bool meets = level_.tuning.shared.pairs() == BodyPairs::meet;
    if (meets && radius_of(spawn.kind, spawn.size) > 0) return;
    const Vec2 reach = level_.map.corner_of({kMaxShapeTiles, kMaxShapeTiles});
    const Vec2 end = spawn.position + spawn.size;
    const bool is_covered = any_cell(spawn.position - reach, end + reach, [&](Cell at) {
      const LintTiles::Tile& tile = tiles_[level_.map.tile_at(at)];
      if (!tile.line || (tiles_.is_slope(level_.map.tile_at(at)) && !tile.own_shape)) return false;
      return any_cell(spawn.position, end, [&](Cell c) {
        return c.x >= at.x + tile.covered[0].x && c.x <= at.x + tile.covered[1].x &&
               c.y >= at.y + tile.covered[0].y && c.y <= at.y + tile.covered[1].y;
      });
    });
    if (!is_covered) return;
    const Rect box{spawn.position.x, spawn.position.y, spawn.size.x, spawn.size.y};
    const LocalGround ground = ground_around(level_, box, 0);
    if (!overlaps_ground(ground.terrain, ground.to_local(box), spawn.used_foot())) return;
    const auto out = way_out(ground.terrain, ground.to_local(box), spawn.used_foot());
    const double depth = out ? std::abs(out->x) + std::abs(out->y) : 0;  // px
    // Rounding by the program that wrote the file; the first step leads out of it.
    if (out && depth <= 1.0 / kWeldParts) return;
    report(out_, kInSlope,
           subject + " starts " + (out ? px_text(depth) + " px " : "") + "inside the shape of a tile", cell,
           -1, index);
  }

  const Level& level_;
  const LintTiles& tiles_;
  std::vector<Problem>& out_;
};

void check_spawns(const LintContext& context, std::vector<Problem>& out) {
  SpawnLinter linter(context, out);
  for (int i = 0; i < static_cast<int>(context.level.spawns.size()); ++i) linter.check(i);
  if (context.has_balls || !context.level.spawns.empty()) return;
  report(out, kNoBodies, "there is no player and no ball, so nothing will move");
}

void check_ball(const LintContext& context, Cell cell, int tile, std::vector<Problem>& out) {
  const LintTiles& tiles = context.tiles;
  const Rect ball = context.level.map.box_of(cell);
  const int left = std::max(0, cell.x - tiles.slope_cells());
  const int up = std::max(0, cell.y - tiles.slope_rows());
  for (Cell at{left, up}; at.y <= cell.y; ++at.y) {
    for (at.x = left; at.x <= cell.x; ++at.x) {
      const TileNumber slope = context.level.map.tile_at(at);
      if (!tiles.is_slope(slope) || tiles[slope].own_shape) continue;
      const double depth = depth_in_slope(context.level, ball.position(), {ball.w, ball.h}, at);
      if (!(depth > 0)) continue;
      report(out, kInSlope,
             "the ball at " + cell_text(cell) + " starts " + px_text(depth) + " px inside the " +
                 role_label(tiles[slope].role) + " at " + cell_text(at),
             cell, tile);
      return;
    }
  }
}

void check_balls(const LintContext& context, std::array<Cell, 2> area, std::vector<Problem>& out) {
  for (Cell cell = area[0]; cell.y <= area[1].y; ++cell.y) {
    for (cell.x = area[0].x; cell.x <= area[1].x; ++cell.x) {
      const TileNumber tile = context.level.map.tile_at(cell);
      if (context.tiles[tile].role == TileRole::ball) check_ball(context, cell, tile, out);
    }
  }
}

std::string position_text(Vec2 at) { return px_text(at.x) + ", " + px_text(at.y) + " px"; }

void move_spawn(const Level& level, int index, Vec2 to, std::vector<Edit>& out) {
  Spawn spawn = level.spawns[static_cast<std::size_t>(index)];
  if (spawn.position == to) return;
  const double up = spawn.position.y - to.y;
  const bool straight = spawn.position.x == to.x && up > 0;
  spawn.position = to;
  out.push_back(change_spawn(level, index, spawn,
                             "Move " + spawn_name(level, index) +
                                 (straight ? " up by " + px_text(up) + " px" : "") + " to " +
                                 position_text(to)));
}

void fix_outside(const LintContext& context, const Problem& problem, std::vector<Edit>& out) {
  const Level& level = context.level;
  const int index = problem.object;
  const Spawn& spawn = level.spawns[static_cast<std::size_t>(index)];
  const auto inside = [](double at, double size, double length) {
    return std::max(0.0, std::min(at, length - size));
  };
  move_spawn(level, index,
             {inside(spawn.position.x, spawn.size.x, level.map.px_width()),
              inside(spawn.position.y, spawn.size.y, level.map.px_height())},
             out);
}

// Moves a ball tile up to the next empty cell outside all slopes.
void move_ball(const LintContext& context, Cell cell, std::vector<Edit>& out) {
  const Level& level = context.level;
  const LintTiles& tiles = context.tiles;
  for (Cell up{cell.x, cell.y - 1}; level.map.contains(up) && up.y >= cell.y - kMaxCellsUp; --up.y) {
    if (!tiles.is_empty(level.map.tile_at(up))) continue;
    // If the ball covers a slope's right half, that half replaces it.
    const Cell left{cell.x - 1, cell.y};
    const auto half = static_cast<std::uint8_t>(level.map.contains(left) ? level.map.tile_at(left) + 1 : 0);
    const bool is_half = half != 0 && tiles[half].half_of == half - 1;
    Edit edit = put_tile(level, cell, is_half ? half : 0,
                         "Move the ball of " + cell_text(cell) + " up to " + cell_text(up) +
                             (is_half ? ", and put tile " + std::to_string(half) + " in its place" : ""));
    edit.changes.push_back(CellChange{up, level.map.tile_at(up), level.map.tile_at(cell)});
    out.push_back(std::move(edit));
    return;
  }
}

void fix_inside(const LintContext& context, const Problem& problem, std::vector<Edit>& out) {
  if (problem.object < 0) return move_ball(context, *problem.cell, out);
  const Spawn& spawn = context.level.spawns[static_cast<std::size_t>(problem.object)];
  if (const auto place = free_place(context.level, spawn))
    move_spawn(context.level, problem.object, *place, out);
}

}  // namespace

const RuleGroup& spawn_rules() {
  static constexpr const LintRule* kRules[] = {&kInSolid, &kInSlope, &kOutside, &kTooFast, &kNoBodies};
  static constexpr RuleGroup kGroup{.rules = kRules, .check_area = check_balls, .check_level = check_spawns};
  return kGroup;
}

}  // namespace talus
