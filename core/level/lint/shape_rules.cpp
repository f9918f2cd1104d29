// Finds shapes that are invalid, that no picture shows, that are too steep, or that reach over the map's
// edge.
#include <algorithm>
#include <cmath>

#include <talus/collision/shape_forms.h>
#include "../level_text.h"
#include "../slope_tiles.h"
#include "fix_parts.h"
#include "rule_group.h"

namespace talus {
namespace {

LintFix fix_steepness, fix_picture, fix_bad_shape;

constexpr LintRule kTooSteep{.code = "too-steep",
                             .label = "floor too steep",
                             .by_hand = "Lay the slope over more tiles, or allow steeper floors in Tuning.",
                             .fix = fix_steepness};
constexpr LintRule kInvisible{.code = "invisible",
                              .label = "tile without a picture",
                              .by_hand = "Draw the tile, or clear its flags and its shape.",
                              .fix = fix_picture};
constexpr LintRule kLeavesMap{
    .code = "shape-leaves-map",
    .label = "shape over the map's edge",
    .by_hand = "Place the tile farther from the map's edge, or make its shape smaller."};
constexpr LintRule kBadShape{.code = "bad-shape",
                             .label = "shape that cannot be used",
                             .by_hand = "Choose another shape, or none, in the Shape tab.",
                             .severity = Severity::error,
                             .fix = fix_bad_shape};

void check_steepness(const LintContext& context, int tile, std::vector<Problem>& out) {
  const Level& level = context.level;
  const TileShape& shape = context.tiles.shape(tile);
  const bool floor = is_line_shape(shape) && shape.side == TileShape::Side::floor && shape.heights.size() > 1;
  if (!floor || level.tuning.solver != SolverKind::exact) return;
  const double width =
      shape.tiles * level.map.tile_size().width / static_cast<double>(shape.heights.size() - 1);
  double rise = 0;
  for (std::size_t i = 1; i < shape.heights.size(); ++i)
    rise = std::max(rise, std::abs(weld(shape.heights[i]) - weld(shape.heights[i - 1])));
  const double steepest = level.tuning.exact.steepest;
  if (rise <= width * steepest) return;
  report(out, kTooSteep,
         context.tiles.text_of(tile) + " rises " + px_text(rise) + " px in " + px_text(width) +
             " px; more than " + px_text(width * steepest) + " px is not a floor to stand on",
         {}, tile);
}

void check_picture(const LintContext& context, int tile, std::vector<Problem>& out) {
  const LintTiles::Tile& facts = context.tiles[static_cast<std::size_t>(tile)];
  if (facts.shapeless || !facts.blank || !context.tiles.has_pictures()) return;
  const std::string what = facts.role != TileRole::none ? "is " + role_label(facts.role) : "has a shape";
  report(out, kInvisible, context.tiles.text_of(tile) + " " + what + ", but its picture is blank", {}, tile);
}

void check_shape_tile(const LintContext& context, int tile, std::vector<Problem>& out) {
  check_steepness(context, tile, out);
  check_picture(context, tile, out);
}

// Slopes that are made by flags alone are checked by the rules of slopes.
void check_edges(const LintContext& context, std::array<Cell, 2> area, std::vector<Problem>& out) {
  const TileMap& map = context.level.map;
  for (Cell cell = area[0]; cell.y <= area[1].y; ++cell.y) {
    for (cell.x = area[0].x; cell.x <= area[1].x; ++cell.x) {
      const TileNumber tile = map.tile_at(cell);
      const LintTiles::Tile& facts = context.tiles[tile];
      if (!facts.line || (context.tiles.is_slope(tile) && !facts.own_shape)) continue;
      const auto& [first, last] = facts.covered;
      const std::string where = cell.x + last.x >= map.width()    ? "right"
                                : cell.y + first.y < 0            ? "upper"
                                : cell.y + last.y >= map.height() ? "lower"
                                                                  : "";
      if (where.empty()) continue;
      report(out, kLeavesMap,
             context.tiles.text_of(tile) + " at " + cell_text(cell) + " reaches over the map's " + where +
                 " edge, where it stops nothing",
             cell, tile);
    }
  }
}

void check_usable(const LintContext& context, std::vector<Problem>& out) {
  const TileSize size = context.level.map.tile_size();
  for (int flag = 0; flag < kMaxFlags; ++flag) {
    if (const auto problem = problem_of(context.level.flag_shapes[static_cast<std::size_t>(flag)], size))
      report(out, kBadShape, "the shape of flag " + std::to_string(flag) + " " + *problem, {}, -1, flag);
  }
  for (int tile = 0; tile < context.level.tile_count(); ++tile) {
    if (const auto problem = problem_of(context.level.tile_shapes[static_cast<std::size_t>(tile)], size))
      report(out, kBadShape, "the shape of " + context.tiles.text_of(tile) + " " + *problem, {}, tile);
  }
}

// Whether the middle of a pixel of the tile's own image is inside the ground, or inside the ball.
bool is_inside(const TileShape& shape, TileSize tile, int x, int y) {
  constexpr double kMiddle = kCartTileSize / 2.0;
  if (shape.kind == TileShape::Kind::none) return std::hypot(x + 0.5 - kMiddle, y + 0.5 - kMiddle) < kMiddle;
  const double at = (x + 0.5) * tile.width / kCartTileSize, down = (y + 0.5) * tile.height / kCartTileSize;
  if (has_parts(shape)) return is_in_ground(shape, tile, {at, down});
  if (shape.heights.size() < 2) return true;
  const double step = shape.tiles * tile.width / static_cast<double>(shape.heights.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at / step), shape.heights.size() - 2);
  const double part = at / step - static_cast<double>(i);
  const double height = shape.heights[i] + (shape.heights[i + 1] - shape.heights[i]) * part;
  return shape.side == TileShape::Side::floor ? tile.height - down <= height : down <= height;
}

Edit draw_shape(const Level& level, TileNumber tile) {
  const TileShape shape = shape_of_tile(level, tile);
  Edit edit{"Draw " + tile_text(tile) + " as what it is", {}};
  for (int pixel = 0; pixel < kCartTileSize * kCartTileSize; ++pixel) {
    const std::uint8_t before = level.sheet(SheetId::tiles).images[tile][static_cast<std::size_t>(pixel)];
    if (is_inside(shape, level.map.tile_size(), pixel % kCartTileSize, pixel / kCartTileSize))
      edit.changes.push_back(
          PixelChange{SheetId::tiles, tile, pixel, before, SlopeTilesOptions{}.ground_color});
  }
  return edit;
}

Edit remove_shape(const Level& level, TileNumber tile) {
  return single_change("Remove the shape of " + tile_text(tile),
                       TileShapeChange{tile, level.tile_shapes[tile], TileShape()});
}

void fix_steepness(const LintContext& context, const Problem& problem, std::vector<Edit>& out) {
  const Level& level = context.level;
  const auto tile = static_cast<TileNumber>(problem.tile);
  TileShape shape = shape_of_tile(level, tile);
  const double steepest = level.tuning.exact.steepest;
  const double width =
      shape.tiles * level.map.tile_size().width / static_cast<double>(shape.heights.size() - 1);
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
                                    " px, in every cell with that tile",
                                TileShapeChange{tile, level.tile_shapes[tile], shape}));
  }
  Tuning tuning = level.tuning;
  tuning.exact.steepest = std::ceil(rise / width);
  out.push_back(single_change("Let floors rise by " + px_text(tuning.exact.steepest) +
                                  " px for each px, in the whole level (steepest floor, in Tuning)",
                              TuningChange{level.tuning, tuning}));
}

void fix_picture(const LintContext& context, const Problem& problem, std::vector<Edit>& out) {
  const auto tile = static_cast<TileNumber>(problem.tile);
  // In true colour the pixels of images are not seen.
  if (context.level.sheet(SheetId::tiles).picture == nullptr) out.push_back(draw_shape(context.level, tile));
  if (context.level.tile_flags(tile) != 0)
    out.push_back(change_flags(context.level, tile, 0, "Clear all flags of " + tile_text(tile)));
  if (context.level.tile_shapes[tile].kind != TileShape::Kind::none)
    out.push_back(remove_shape(context.level, tile));
}

void fix_bad_shape(const LintContext& context, const Problem& problem, std::vector<Edit>& out) {
  const Level& level = context.level;
  if (problem.tile >= 0) {
    out.push_back(remove_shape(level, static_cast<TileNumber>(problem.tile)));
  } else {
    const TileShape& before = level.flag_shapes[static_cast<std::size_t>(problem.object)];
    out.push_back(single_change("Remove the shape of flag " + std::to_string(problem.object),
                                FlagShapeChange{problem.object, before, TileShape()}));
  }
}

}  // namespace

const RuleGroup& shape_rules() {
  static constexpr const LintRule* kRules[] = {&kTooSteep, &kInvisible, &kLeavesMap, &kBadShape};
  static constexpr RuleGroup kGroup{.rules = kRules,
                                    .check_tile = check_shape_tile,
                                    .check_area = check_edges,
                                    .check_level = check_usable};
  return kGroup;
}

}  // namespace talus
