// Collects what the lint knows of the tiles.
#include "lint_tiles.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include <talus/level/ground.h>
#include "../tile_color.h"

namespace talus {
namespace {

constexpr int kOutlineReach = kMaxShapeTiles + 2;  // cells: a slope's own reach, and the neighbours beyond

bool is_partial(std::uint64_t mask) { return mask != 0 && ~mask != 0; }

std::vector<Curve> usable_curves(const Level& level) {
  std::vector<Curve> curves;
  for (const LevelCurve& curve : level.curves) {
    if (!problem_of(curve.curve, level.map)) curves.push_back(curve.curve);
  }
  return curves;
}

// See Tile::to_draw. A cell counts if the ground in it is higher than a px in half of its columns of pixels;
// for a one-way line, if the line goes through it. The picture of a shape one tile wide is the tile itself.
std::vector<Cell> cells_to_draw(const TileShape& shape, TileSize tile) {
  std::vector<Cell> cells;
  if (shape.kind == TileShape::Kind::solid || shape.tiles < 2) return cells;
  for (int column = 0; column < shape.tiles; ++column) {
    std::array<int, kMaxShapeTiles> pixels{};  // by row
    for (int x = 0; x < tile.width; ++x) {
      const double height = height_of_line(shape, column * tile.width + x + 0.5, tile);
      const int rows = static_cast<int>(std::ceil((height - 1) / tile.height));
      const int last = std::clamp(rows, 0, kMaxShapeTiles);
      for (int row = shape.one_way ? std::max(last - 1, 0) : 0; row < last; ++row)
        ++pixels[static_cast<std::size_t>(row)];
    }
    for (int row = 0; row < kMaxShapeTiles; ++row) {
      if ((column == 0 && row == 0) || pixels[static_cast<std::size_t>(row)] < tile.width / 2) continue;
      cells.push_back({column, shape.side == TileShape::Side::floor ? -row : row});
    }
  }
  return cells;
}

}  // namespace

LintTiles::LintTiles(const Level& level, const LintOptions& options, GroundNames names)
    : options_(options),
      names_(std::move(names)),
      tile_(level.map.tile_size()),
      shapes_(usable_shapes(level)),
      tiles_(shapes_.size()),
      masks_(shapes_.size()),
      outlines_(shapes_, tile_),
      sources_(usable_curves(level)),
      curves_(cut_curves(sources_)),
      slope_cells_(static_cast<int>(std::ceil(level.tuning.shared.slope_width / tile_.width))),
      slope_rows_(static_cast<int>(std::ceil(level.tuning.shared.slope_height / tile_.height))) {
  for (std::size_t i = 0; i < count(); ++i) {
    Tile& tile = tiles_[i];
    tile.role = role_of(level.tile_flags(static_cast<TileNumber>(i)), level.roles);
    tile.solid = is_full(shapes_[i]);
    tile.own_shape = level.tile_shapes[i].kind != TileShape::Kind::none;
    tile.line = is_line_shape(shapes_[i]);
    tile.shapeless = tile.role == TileRole::none && shapes_[i].kind == TileShape::Kind::none;
    if (!tile.line) continue;
    // The shape touches these neighbours, but does not cover them.
    const std::array<Cell, 2> touched = cells_touched_by(shapes_[i], {0, 0}, tile_);
    tile.covered = {Cell{touched[0].x + 1, touched[0].y + 1}, Cell{touched[1].x - 1, touched[1].y - 1}};
    tile.to_draw = cells_to_draw(shapes_[i], tile_);
  }
  note_masks(level);
  note_likeness();
  for (const Spawn& spawn : level.spawns) {
    if (!traits_of(spawn.kind).takes_keys) continue;
    const Vec2 least = player_.value_or(spawn.size);
    player_ = Vec2{std::min(least.x, spawn.size.x), std::min(least.y, spawn.size.y)};
  }
}

void LintTiles::note_masks(const Level& level) {
  for (std::size_t i = 0; i < count(); ++i) {
    const auto tile = static_cast<TileNumber>(i);
    masks_[i] = drawn_pixels(level, tile);
    tiles_[i].blank = masks_[i] == 0 && is_blank(level, tile);
  }
  if (slope_cells_ != 2) return;
  const SheetLayout layout = level.sheet(SheetId::tiles).layout();
  for (std::size_t i = 1; i < count(); ++i) {
    const bool beside =
        layout.place_of(static_cast<int>(i)).x != 0 && is_slope(i - 1) && !tiles_[i - 1].own_shape;
    if (beside && tiles_[i].shapeless && is_partial(masks_[i])) tiles_[i].half_of = static_cast<int>(i) - 1;
  }
}

int LintTiles::reach() const {
  int reach = std::max({kOutlineReach, slope_cells_ + 1, slope_rows_ + 1});
  // A gap is checked from one mouth to the other. The player must fit at both.
  if (player_) {
    const double cells = std::max(player_->x / tile_.width, player_->y / tile_.height);
    reach = std::max(reach, 2 * static_cast<int>(std::ceil(cells)) + kLongestGap + 1);
  }
  return reach;
}

// A tile that looks like a slope but is none was probably intended as one.
void LintTiles::note_likeness() {
  has_pictures_ = std::any_of(masks_.begin(), masks_.end(), [](std::uint64_t mask) { return mask != 0; });
  std::unordered_map<std::uint64_t, int> slopes;  // the first slope with each mask
  for (std::size_t i = 0; i < count(); ++i) {
    if (is_slope(i) && !tiles_[i].own_shape) slopes.try_emplace(masks_[i], static_cast<int>(i));
  }
  for (std::size_t i = 0; i < count(); ++i) {
    Tile& tile = tiles_[i];
    if (!tile.shapeless || tile.half_of >= 0 || !is_partial(masks_[i])) continue;
    if (const auto slope = slopes.find(masks_[i]); slope != slopes.end()) tile.like = slope->second;
  }
}

bool operator==(const LintTiles& a, const LintTiles& b) {
  return a.options_ == b.options_ && a.names_ == b.names_ && a.tile_ == b.tile_ && a.shapes_ == b.shapes_ &&
         a.tiles_ == b.tiles_ && a.sources_ == b.sources_ && a.slope_cells_ == b.slope_cells_ &&
         a.slope_rows_ == b.slope_rows_ && a.player_ == b.player_;
}

}  // namespace talus
