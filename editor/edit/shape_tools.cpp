// Tools for the shapes of the ground.
#include "shape_tools.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
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

// Its slopes and a full tile; empty without a slope.
std::vector<TileNumber> floors_of_sheet(const Level& level) {
  std::vector<TileNumber> floors;
  std::optional<TileNumber> full;
  for (int i = 0; i < level.tile_count(); ++i) {
    const auto tile = static_cast<TileNumber>(i);
    const TileShape shape = shape_of_tile(level, tile);
    if (has_heights(shape) && shape.side == TileShape::Side::floor && !shape.one_way) floors.push_back(tile);
    if (!full && is_full(shape)) full = tile;
  }
  if (full && !floors.empty()) floors.push_back(*full);
  return floors;
}

// Drawn tiles look like the ground that they belong to, unless most of its pixels are clear.
void take_colors_of_ground(const Level& level, SlopeTilesOptions& options) {
  const auto& images = level.sheet(SheetId::tiles).images;
  const auto take = [](std::uint8_t& color, std::span<const std::uint8_t> pixels) {
    if (const std::uint8_t main = main_color(pixels); main != 0) color = main;
  };
  if (const TileNumber top = level.auto_tiles.of(GroundPart::top))
    take(options.line_color, std::span(images[top]).first(kCartTileSize));
  if (options.below) take(options.ground_color, images[*options.below]);
}

constexpr int kMostRowsDown = 64;

// The tile to fill the ground with that the level suggests.
std::optional<TileNumber> tile_for_inside(const Level& level, Vec2 a, Vec2 b) {
  const TileNumber inside = level.auto_tiles.of(GroundPart::inside);
  if (inside != 0 && is_full(shape_of_tile(level, inside))) return inside;
  for (const Vec2 end : {a.y > b.y ? a : b, a.y > b.y ? b : a}) {
    const Cell under = level.map.cell_at(end);
    for (Cell cell = under; cell.y < under.y + kMostRowsDown; ++cell.y) {
      for (cell.x = under.x; cell.x >= under.x - 1; --cell.x) {  // it may be at the border of two columns
        if (!level.map.contains(cell)) continue;
        const MapCell tile = level.map.at(cell);
        if (tile.turn == TileTurn::none && is_full(shape_of_tile(level, tile.tile))) return tile.tile;
      }
    }
  }
  return std::nullopt;
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
  options.line_color = line_color;
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
  if (fills && !options.below) options.below = tile_for_inside(level, a, b);
  const bool can_draw = level.sheet(SheetId::tiles).picture == nullptr;
  if (can_draw) take_colors_of_ground(level, options);
  if (!has_slope) set = can_draw ? std::vector<TileNumber>() : floors_of_sheet(level);
  options.set = set;
  return slope_tiles(level, a, b, options).map([&](const SlopeTiles& tiles) {
    Edit edit = put_slope_tiles(level, tiles, within);
    if (fills) fit_ground(level, edit, within);
    keep_bodies_out(level, edit);
    return edit;
  });
}

}  // namespace talus
