// Tools for the shapes of the ground.
#include "shape_tools.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "auto_tile.h"
#include "collision/tile_outlines.h"
#include "level/body_place.h"
#include "level/level_text.h"
#include "level/single_change.h"
#include "level/tile_color.h"

namespace talus {

Edit set_tile_shape(const Level& level, int tile, TileShape shape) {
  assert(tile >= 0 && tile < level.tile_count());
  return single_change("Change the shape of tile " + std::to_string(tile),
                       TileShapeChange{tile, level.tile_shapes[tile], std::move(shape)});
}

Edit set_flag_shape(const Level& level, int flag, TileShape shape) {
  assert(flag >= 0 && flag < kMaxFlags);
  return single_change("Change the shape of flag " + std::to_string(flag),
                       FlagShapeChange{flag, level.flag_shapes[flag], std::move(shape)});
}

Edit set_curves(const Level& level, std::vector<LevelCurve> curves, std::string label) {
  return single_change(std::move(label), CurvesChange{level.curves, std::move(curves)});
}

Edit put_slope_tiles(const Level& level, const SlopeTiles& tiles, Within within) {
  Edit edit{"Lay a slope", {}};
  std::vector<bool> is_shown(static_cast<std::size_t>(level.tile_count()));
  for (const SlopeTiles::Placed& placed : tiles.placed) {
    if (within && !within->contains(placed.cell)) continue;
    is_shown[placed.tile] = true;
    const MapCell before = level.map.at(placed.cell);
    if (before != MapCell(placed.tile))
      edit.changes.emplace_back(CellChange{placed.cell, before, placed.tile});
  }
  for (const SlopeTiles::Drawn& drawn : tiles.drawn) {
    if (!is_shown[drawn.tile]) continue;
    const TileImage& before = level.sheet(SheetId::tiles).images[drawn.tile];
    for (int pixel = 0; pixel < kCartTileSize * kCartTileSize; ++pixel) {
      if (before[pixel] != drawn.image[pixel])
        edit.changes.emplace_back(
            PixelChange{SheetId::tiles, drawn.tile, pixel, before[pixel], drawn.image[pixel]});
    }
    const TileShape& shape = level.tile_shapes[drawn.tile];
    if (shape != drawn.shape) edit.changes.emplace_back(TileShapeChange{drawn.tile, shape, drawn.shape});
  }
  return edit;
}

namespace {

// Its slopes and a full tile that have no flag but those of ground; empty without a slope.
std::vector<TileNumber> floors_of_sheet(const Level& level) {
  FlagSet ground = 0;
  for (const int flag : {level.roles.solid, level.roles.up_slope, level.roles.down_slope})
    if (flag != FlagRoles::kUnused) ground |= flag_bit(flag);
  std::vector<TileNumber> floors;
  std::optional<TileNumber> full;
  for (int i = 0; i < level.tile_count(); ++i) {
    const auto tile = static_cast<TileNumber>(i);
    if ((level.tile_flags(tile) & ~ground) != 0) continue;
    const TileShape shape = shape_of_tile(level, tile);
    if (has_heights(shape) && shape.side == TileShape::Side::floor && !shape.one_way) floors.push_back(tile);
    if (!full && is_full(shape)) full = tile;
  }
  if (full && !floors.empty()) floors.push_back(*full);
  return floors;
}

constexpr int kMaxRowsDown = 64;
constexpr int kMaxEdge = 3;  // rows of pixels of the top of the ground that its slopes have as an edge

// Full tiles of the ground on which an end of a slope stands.
struct GroundTiles {
  TileNumber top = 0;     // the first one downwards
  TileNumber inside = 0;  // the one below that; if there is none, the same
};

// At the lower end, else at the upper one; nothing if there is no ground near.
std::optional<GroundTiles> ground_tiles_at(const Level& level, Vec2 a, Vec2 b) {
  const auto full_at = [&](Cell cell) -> std::optional<TileNumber> {
    if (!level.map.contains(cell)) return std::nullopt;
    const MapCell tile = level.map.at(cell);
    if (tile.turn != TileTurn::none || !is_full(shape_of_tile(level, tile.tile))) return std::nullopt;
    return tile.tile;
  };
  for (const Vec2 end : {a.y > b.y ? a : b, a.y > b.y ? b : a}) {
    const Cell at = level.map.cell_at(end);
    // It may be at the border of two columns: that under the slope comes first.
    const bool is_right_end = end.x == std::max(a.x, b.x) && level.map.x_of(at.x) == end.x;
    const int under = is_right_end ? at.x - 1 : at.x, beside = is_right_end ? at.x : at.x - 1;
    for (int y = at.y; y < at.y + kMaxRowsDown; ++y) {
      for (const int x : {under, beside}) {
        if (const auto top = full_at({x, y})) return GroundTiles{*top, full_at({x, y + 1}).value_or(*top)};
      }
    }
  }
  return std::nullopt;
}

// Drawn tiles look like the ground that they belong to, unless most of its pixels are clear.
void take_look_of_ground(const Level& level, const std::optional<GroundTiles>& near,
                         SlopeTilesOptions& options) {
  const TileNumber inside = level.auto_tiles.of(GroundPart::inside);
  if (options.fills && !options.below) {
    if (inside != 0 && is_full(shape_of_tile(level, inside)))
      options.below = inside;
    else if (near)
      options.below = near->inside;
  }
  const auto& images = level.sheet(SheetId::tiles).images;
  if (options.below)
    if (const std::uint8_t main = main_color(images[*options.below]); main != 0) options.ground_color = main;
  TileNumber top = level.auto_tiles.of(GroundPart::top);
  if (top == 0 && near) top = near->top;
  std::vector<std::uint8_t> edge;
  for (int row = 0; top != 0 && row < kMaxEdge; ++row) {
    const auto pixels =
        std::span(images[top]).subspan(static_cast<std::size_t>(row * kCartTileSize), kCartTileSize);
    const std::uint8_t color = main_color(pixels);
    if (color == 0 || color == options.ground_color) break;
    edge.push_back(color);
  }
  if (!edge.empty() || near) options.edge_colors = std::move(edge);
}

// The top of the ground that the slope covers becomes its inside, in a level without auto-tiles.
void cover_top(const Level& level, const GroundTiles& ground, Within within, Edit& edit) {
  std::map<int, int> lowest;  // changed row, by column
  for (const Change& change : edit.changes) {
    const auto* put = std::get_if<CellChange>(&change);
    if (put == nullptr || put->after == MapCell()) continue;  // what is cut off covers nothing
    int& row = lowest[put->cell.x];
    row = std::max(row, put->cell.y);
  }
  for (const auto& [column, row] : lowest) {
    const Cell under{column, row + 1};
    if (!level.map.contains(under) || (within && !within->contains(under))) continue;
    const MapCell before = level.map.at(under);
    if (before == MapCell(ground.top) && ground.inside != ground.top)
      edit.changes.emplace_back(CellChange{under, before, ground.inside});
  }
}

// The first and last column and row of the cells that the edit changes; nothing if it changes none.
std::optional<std::array<Cell, 2>> changed_cells(const Edit& edit) {
  std::optional<std::array<Cell, 2>> area;
  for (const Change& change : edit.changes) {
    const auto* put = std::get_if<CellChange>(&change);
    if (put == nullptr) continue;
    const auto [first, last] = area.value_or(std::array{put->cell, put->cell});
    area = {Cell{std::min(first.x, put->cell.x), std::min(first.y, put->cell.y)},
            Cell{std::max(last.x, put->cell.x), std::max(last.y, put->cell.y)}};
  }
  return area;
}

// Bodies that the new ground would bury start above it, in the same edit.
void keep_bodies_out(const Level& level, Edit& edit) {
  const auto area = changed_cells(edit);
  if (!area || level.spawns.empty()) return;
  const Vec2 first = level.map.corner_of((*area)[0]);
  const Vec2 end = level.map.corner_of({(*area)[1].x + 1, (*area)[1].y + 1});
  std::optional<Level> after;  // made for the first body that is near
  std::vector<Spawn> spawns = level.spawns;
  for (Spawn& spawn : spawns) {
    const Vec2 from = spawn.position, to = from + spawn.size;
    if (!(from.x < end.x && to.x > first.x && from.y < end.y && to.y > first.y)) continue;
    if (!after) apply_edit(after.emplace(level), edit);
    if (!starts_in_ground(*after, spawn) || starts_in_ground(level, spawn)) continue;
    if (const auto place = free_place(*after, spawn)) spawn.position = *place;
  }
  if (spawns != level.spawns) edit.changes.emplace_back(SpawnsChange{level.spawns, std::move(spawns)});
}

}  // namespace

tl::expected<Edit, std::string> lay_slope(const Level& level, Vec2 a, Vec2 b, const Stamp& stamp,
                                          std::uint8_t line_color, Within within, bool fills) {
  if (a == b) return tl::unexpected<std::string>(kNoLength);
  const double steepest = level.tuning.exact.steepest;
  if (level.tuning.solver == SolverKind::exact && a.x != b.x &&
      std::abs(b.y - a.y) > std::abs(b.x - a.x) * steepest)
    return tl::unexpected("the slope is too steep to stand on: it may rise by " + px_text(steepest) +
                          " px for each px (steepest floor, in Tuning)");
  SlopeTilesOptions options;
  options.edge_colors = {line_color};
  bool has_slope = false;
  std::vector<TileNumber> set;  // of the stamp, without those that are turned
  for (const auto [tile, turn] : stamp.tiles) {
    if (turn != TileTurn::none) continue;
    set.push_back(tile);
    const TileShape shape = shape_of_tile(level, tile);
    if (is_full(shape) && !options.below) options.below = tile;
    has_slope = has_slope || (has_heights(shape) && shape.side == TileShape::Side::floor);
  }
  options.fills = fills;
  const std::optional<GroundTiles> ground = ground_tiles_at(level, a, b);
  take_look_of_ground(level, ground, options);
  const bool can_draw = level.sheet(SheetId::tiles).picture == nullptr;
  if (!has_slope) set = floors_of_sheet(level);
  options.set = set;
  if (!has_slope && can_draw) options.most_off = kSlopeTileGrain / 2;
  auto laid = slope_tiles(level, a, b, options);
  if (!laid && !has_slope && can_draw) {
    options.set = {};
    laid = slope_tiles(level, a, b, options);
  }
  return laid.map([&](const SlopeTiles& tiles) {
    Edit edit = put_slope_tiles(level, tiles, within);
    if (fills) fit_ground(level, edit, within);
    if (fills && ground && level.auto_tiles.of(GroundPart::top) == 0) cover_top(level, *ground, within, edit);
    keep_bodies_out(level, edit);
    return edit;
  });
}

}  // namespace talus
