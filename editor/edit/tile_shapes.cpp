// Fits lines to columns of pixels, and copies blocks of tiles.
#include "tile_shapes.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include <talus/collision/shape_forms.h>
#include "level/picture_tiles.h"
#include "level/tile_color.h"
#include "polygon_tools.h"

namespace talus {
namespace {

using Kind = TileShape::Kind;
using Side = TileShape::Side;

bool has_line(const TileShape& shape) { return has_heights(shape); }

// The height of a shape's line at a fraction of its width, 0..1.
double height_at(const TileShape& shape, double part) {
  const double at = part * static_cast<double>(shape.heights.size() - 1);
  const auto left = std::min(static_cast<std::size_t>(at), shape.heights.size() - 2);
  return std::lerp(shape.heights[left], shape.heights[left + 1], at - static_cast<double>(left));
}

std::vector<double> heights_of_columns(const TileShape& shape, int tiles, TileSize tile) {
  std::vector<double> heights;
  const int columns = tiles * tile.width;
  for (int i = 0; i <= columns; ++i) heights.push_back(height_at(shape, static_cast<double>(i) / columns));
  return heights;
}

// The opaque pixels of the pictures of some tiles side by side, column by column: of a sheet in true colour
// those that are at least half opaque, else those of the images that are not colour 0. Heights are in parts
// of a tile, kCartTileSize of them, whatever its size is.
struct Columns {
  std::vector<double> from_bottom, from_top;  // how far the opaque pixels reach; 0: the column is clear
  double pixel = 1;                           // height of a pixel
  int opaque = 0;

  Columns(const Level& level, int tile, int tiles) {
    const Sheet& sheet = level.sheet(SheetId::tiles);
    const bool is_true_color = sheet.picture != nullptr;
    const TileSize size = is_true_color ? level.map.tile_size() : TileSize{kCartTileSize, kCartTileSize};
    pixel = 1.0 * kCartTileSize / size.height;
    for (int i = 0; i < tiles; ++i) {
      const std::vector<std::uint8_t> rgba =
          is_true_color ? shown_rgba(level, tile + i) : std::vector<std::uint8_t>();
      const TileImage& image = sheet.images[tile + i];
      add(size, [&](int at) { return is_true_color ? rgba[4 * at + 3] >= kHalfOpaque : image[at] != 0; });
    }
  }

 private:
  template <class IsOpaque>
  void add(TileSize size, IsOpaque is_opaque) {
    for (int x = 0; x < size.width; ++x) {
      int top = 0, bottom = 0;
      for (int y = 0; y < size.height; ++y) {
        if (!is_opaque(y * size.width + x)) continue;
        ++opaque;
        top = y + 1;
        if (bottom == 0) bottom = size.height - y;
      }
      from_top.push_back(top * pixel);
      from_bottom.push_back(bottom * pixel);
    }
  }
};

double sum(const std::vector<double>& numbers) {
  double total = 0;
  for (const double number : numbers) total += number;
  return total;
}

// Rates how simple a height is: 0 for whole tiles, then halves and quarters of them, and so on.
int plainness(double height) {
  int level = 0;
  for (double step = kCartTileSize; std::fmod(height, step) != 0; step /= 2) ++level;
  return level;
}

struct Line {
  double left, right;
};

// How far a column's topmost edge may be above the line in the middle of the column, in pixels.
struct Tolerance {
  double least, most;
};
constexpr Tolerance kNear{-0.5, 0.5};
constexpr Tolerance kThroughPixels{0, 1};  // in stairs, the line runs through the last pixels
constexpr Tolerance kBeyondPixels{-1, 0};  // or through the first clear ones

// The plainest line whose ends are multiples of `step` parts of a tile and that keeps the tolerance at all
// columns; of equally plain ones, the nearest.
std::optional<Line> fit_line(const std::vector<double>& columns, double step, Tolerance tolerance) {
  constexpr double kRounding = 1e-9;
  const double count = static_cast<double>(columns.size());
  std::optional<Line> best;
  std::pair<int, double> best_score;
  const auto try_line = [&](Line line) {
    double squares = 0;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const double error =
          columns[i] - std::lerp(line.left, line.right, (static_cast<double>(i) + 0.5) / count);
      if (error < tolerance.least - kRounding || error > tolerance.most + kRounding) return;
      squares += error * error;
    }
    const std::pair score(plainness(line.left) + plainness(line.right), squares);
    if (best && best_score <= score) return;
    best = line;
    best_score = score;
  };
  for (double left = 0; left <= kCartTileSize; left += step)
    for (double right = 0; right <= kCartTileSize; right += step) try_line({left, right});
  return best;
}

std::optional<Line> fit_line(const std::vector<double>& columns, double pixel) {
  const double first = columns.front();
  const bool is_level = std::all_of(columns.begin(), columns.end(), [&](double h) { return h == first; });
  if (is_level) return Line{first, first};
  for (double step = 1; step >= 0.25; step /= 2) {
    for (const Tolerance& tolerance : {kNear, kThroughPixels, kBeyondPixels})
      if (const auto line = fit_line(columns, step, {tolerance.least * pixel, tolerance.most * pixel}))
        return line;
  }
  return std::nullopt;
}

// Heights at the column lines: the mean of the two columns beside it.
std::vector<double> profile_of(const std::vector<double>& columns) {
  std::vector<double> heights = {columns.front()};
  for (std::size_t i = 1; i < columns.size(); ++i) heights.push_back((columns[i - 1] + columns[i]) / 2.0);
  heights.push_back(columns.back());
  return heights;
}

void add_shape_change(const Level& level, int tile, const TileShape& shape, Edit& edit) {
  const TileShape& before = level.tile_shapes[tile];
  if (before != shape) edit.changes.emplace_back(TileShapeChange{tile, before, shape});
}

bool is_on_sheet(const Level& level, const CellRect& tiles) {
  return SpriteArea{SheetId::tiles, tiles}.lies_in_sheet(level);
}

bool flips_columns(ShapeTurn turn) { return turn == ShapeTurn::mirrored || turn == ShapeTurn::half_turn; }
bool flips_rows(ShapeTurn turn) { return turn == ShapeTurn::upside_down || turn == ShapeTurn::half_turn; }

std::vector<int> numbers_of(const Level& level, const CellRect& tiles) {  // on the sheet
  const SheetLayout sheet = level.sheet(SheetId::tiles).layout();
  std::vector<int> numbers;
  for (int y = tiles.y; y < tiles.y + tiles.h; ++y)
    for (int x = tiles.x; x < tiles.x + tiles.w; ++x) numbers.push_back(sheet.tile_at({x, y}));
  return numbers;
}

// Neither drawn nor shaped.
bool is_unused(const Level& level, int tile) {
  return is_blank(level, static_cast<TileNumber>(tile)) &&
         shape_of_tile(level, static_cast<TileNumber>(tile)).kind == Kind::none;
}

// Changes another shape in the same way as `before` changed to `after`.
TileShape with_change(TileShape shape, const TileShape& before, const TileShape& after, TileSize tile) {
  if (shape.kind == Kind::none) return shape;
  if (shape == before) return after;
  if (after.conveyor != before.conveyor) shape.conveyor = after.conveyor;
  if (shape.kind == Kind::group) return shape;
  if (after.one_way != before.one_way) shape.one_way = after.one_way;
  if (shape.kind == Kind::solid) return shape;
  if (after.side != before.side) shape.side = after.side;
  if (!has_line(shape)) return shape;
  if (after.tiles != before.tiles) shape = with_width(std::move(shape), after.tiles, tile);
  const std::size_t count = after.heights.size();
  if (shape.kind != after.kind || shape.heights.size() != count || before.heights.size() != count)
    return shape;
  for (std::size_t i = 0; i < count; ++i)
    if (after.heights[i] != before.heights[i]) shape.heights[i] = after.heights[i];
  return shape;
}

// The tiles of an area, except those that another one of them reaches over.
std::vector<int> changed_together(const Level& level, const SpriteArea& area) {
  const SheetLayout sheet = level.sheet(SheetId::tiles).layout();
  std::vector<int> tiles = numbers_of(level, area.tiles);
  std::erase_if(tiles, [&](int tile) {
    const auto owner = tile_reaching_over(level, tile);
    return owner && sheet.place_of(*owner).x >= area.tiles.x;
  });
  return tiles;
}

std::string label_of_change(const Level& level, const SpriteArea& area) {
  if (area.tiles.w * area.tiles.h == 1)
    return "Change the shape of tile " + std::to_string(area.tile_at(level, 0, 0));
  return "Change the shapes of " + std::to_string(area.tiles.w * area.tiles.h) + " tiles";
}

std::string size_text(const CellRect& tiles) {
  return std::to_string(tiles.w) + "x" + std::to_string(tiles.h);
}

void copy_turned(const Level& level, const CellRect& from, const CellRect& to, ShapeTurn turn, Edit& edit) {
  const TileSize size = painted_size(level, SheetId::tiles);
  const SpriteArea source{SheetId::tiles, from, size}, target{SheetId::tiles, to, size};
  PixelBlock pixels = copy_pixels(level, source, source.canvas());
  if (flips_columns(turn)) pixels = turned(pixels, PixelTurn::flip_horizontal);
  if (flips_rows(turn)) pixels = turned(pixels, PixelTurn::flip_vertical);
  Edit painted = put_pixels(level, target, pixels, {0, 0}, edit.label);
  std::move(painted.changes.begin(), painted.changes.end(), std::back_inserter(edit.changes));
}

// All but its conveyor.
TileShape form_with_kind(TileShape shape, TileShape::Kind kind, TileSize tile) {
  if (kind == Kind::solid) return {.kind = Kind::solid, .one_way = shape.one_way};
  if (kind == Kind::polygon)
    return as_polygon(shape.kind == Kind::none ? TileShape{.kind = Kind::solid} : shape, tile);
  if (has_parts(shape)) shape = profile_along(shape, tile);
  const bool is_flat = shape.kind == Kind::solid && kind == Kind::profile;
  const double full = tile.height;
  if (!has_line(shape))
    shape = {.side = shape.side, .one_way = shape.one_way, .heights = {is_flat ? full : 0.0, full}};
  if (kind == Kind::profile) shape.heights = heights_of_columns(shape, shape.tiles, tile);
  if (kind == Kind::slope) shape.heights = {shape.heights.front(), shape.heights.back()};
  shape.kind = kind;
  return shape;
}

}  // namespace

TileShape with_kind(TileShape shape, TileShape::Kind kind, TileSize tile) {
  assert(kind != Kind::group || shape.kind == kind);
  if (kind == shape.kind) return shape;
  if (kind == Kind::none) return {};
  const double conveyor = shape.conveyor;
  TileShape made = form_with_kind(std::move(shape), kind, tile);
  made.conveyor = conveyor;
  return made;
}

TileShape with_width(TileShape shape, int tiles, TileSize tile) {
  assert(tiles >= 1 && tiles <= kMaxShapeTiles);
  if (shape.kind == Kind::profile) shape.heights = heights_of_columns(shape, tiles, tile);
  if (has_line(shape)) shape.tiles = tiles;
  return shape;
}

TileShape turned(TileShape shape, ShapeTurn turn, TileSize tile) {
  if (flips_columns(turn)) shape = mirrored(std::move(shape), tile, ShapeMirror::left_right);
  if (flips_rows(turn)) shape = mirrored(std::move(shape), tile, ShapeMirror::up_down);
  return shape;
}

CellRect tiles_of_shape(const Level& level, int tile, const TileShape& shape) {
  const Cell place = level.sheet(SheetId::tiles).layout().place_of(tile);
  CellRect tiles{place.x, place.y, 1, 1};
  if (!has_line(shape)) return tiles;
  tiles.w = shape.tiles;
  const double highest = *std::max_element(shape.heights.begin(), shape.heights.end());
  tiles.h = std::max(1, static_cast<int>(std::ceil(highest / level.map.tile_size().height)));
  if (shape.side == Side::floor) tiles.y -= tiles.h - 1;
  return tiles;
}

std::optional<int> tile_reaching_over(const Level& level, int tile) {
  const auto shape_of = [&](int number) { return shape_of_tile(level, static_cast<TileNumber>(number)); };
  if (shape_of(tile).kind != Kind::none) return std::nullopt;
  const int column = level.sheet(SheetId::tiles).layout().place_of(tile).x;
  const int first = std::max(tile - column, tile - kMaxShapeTiles + 1);
  for (int left = tile - 1; left >= first; --left) {
    const TileShape shape = shape_of(left);
    if (has_line(shape) && shape.tiles > tile - left) return left;
  }
  return std::nullopt;
}

std::optional<TileShape> suggest_shape(const Level& level, int tile, int tiles) {
  assert(tile >= 0 && tile < level.tile_count() && tiles >= 1 && tiles <= kMaxShapeTiles);
  const SheetLayout sheet = level.sheet(SheetId::tiles).layout();
  tiles = std::min({tiles, sheet.columns - sheet.place_of(tile).x, sheet.count - tile});
  const Columns columns(level, tile, tiles);
  if (columns.opaque == 0) return std::nullopt;
  const TileShape now = shape_of_tile(level, static_cast<TileNumber>(tile));
  const bool hangs =
      now.one_way ? now.side == Side::ceiling : sum(columns.from_top) < sum(columns.from_bottom);
  TileShape shape;
  shape.one_way = now.one_way;
  shape.conveyor = now.conveyor;
  shape.side = hangs ? Side::ceiling : Side::floor;
  const std::vector<double>& heights = hangs ? columns.from_top : columns.from_bottom;
  if (std::all_of(heights.begin(), heights.end(), [](double height) { return height == kCartTileSize; }))
    return TileShape{.kind = Kind::solid, .one_way = shape.one_way, .conveyor = shape.conveyor};
  shape.tiles = tiles;
  if (const auto line = fit_line(heights, columns.pixel)) {
    shape.kind = Kind::slope;
    shape.heights = {line->left, line->right};
  } else {
    shape.kind = Kind::profile;
    shape.heights = profile_of(heights);
  }
  for (double& height : shape.heights) height *= level.map.tile_size().height / 1.0 / kCartTileSize;
  return shape;
}

Edit suggest_shapes(const Level& level, const SpriteArea& area) {
  assert(area.sheet == SheetId::tiles);
  Edit edit{"Suggest shapes from pixels", {}};
  for (int y = 0; y < area.tiles.h; ++y) {
    for (int x = 0; x < area.tiles.w; ++x) {
      const int tile = area.tile_at(level, x, y);
      if (const auto shape = suggest_shape(level, tile)) add_shape_change(level, tile, *shape, edit);
    }
  }
  return edit;
}

Edit change_shapes(const Level& level, const SpriteArea& area, const TileShape& shape) {
  assert(area.sheet == SheetId::tiles);
  Edit edit{label_of_change(level, area), {}};
  const int first = area.tile_at(level, 0, 0);
  const TileShape before = shape_of_tile(level, static_cast<TileNumber>(first));
  add_shape_change(level, first, shape, edit);
  for (const int tile : changed_together(level, area)) {
    const TileShape other = shape_of_tile(level, static_cast<TileNumber>(tile));
    const TileShape changed = with_change(other, before, shape, level.map.tile_size());
    if (tile != first && changed != other) add_shape_change(level, tile, changed, edit);
  }
  return edit;
}

Edit change_kinds(const Level& level, const SpriteArea& area, Kind kind) {
  assert(area.sheet == SheetId::tiles);
  Edit edit{label_of_change(level, area), {}};
  for (const int tile : changed_together(level, area))
    add_shape_change(
        level, tile,
        with_kind(shape_of_tile(level, static_cast<TileNumber>(tile)), kind, level.map.tile_size()), edit);
  return edit;
}

Edit give_shape(const Level& level, const SpriteArea& area, const TileShape& shape) {
  assert(area.sheet == SheetId::tiles);
  Edit edit{"Give tiles a shape", {}};
  for (int y = 0; y < area.tiles.h; ++y)
    for (int x = 0; x < area.tiles.w; ++x) add_shape_change(level, area.tile_at(level, x, y), shape, edit);
  return edit;
}

tl::expected<Edit, std::string> copy_turned(const Level& level, int tile, int target, ShapeTurn turn) {
  assert(tile >= 0 && tile < level.tile_count() && target >= 0 && target < level.tile_count());
  const TileShape shape = shape_of_tile(level, static_cast<TileNumber>(tile));
  const TileShape image = turned(shape, turn, level.map.tile_size());
  const CellRect from = tiles_of_shape(level, tile, shape), to = tiles_of_shape(level, target, image);
  if (!is_on_sheet(level, from))
    return tl::unexpected("tile " + std::to_string(tile) + " has a shape over " + size_text(from) +
                          " tiles, which reaches beyond the sheet");
  if (!is_on_sheet(level, to))
    return tl::unexpected("a copy over " + size_text(to) + " tiles has no room at tile " +
                          std::to_string(target));
  if (from != to && shared(from, to))
    return tl::unexpected("a copy at tile " + std::to_string(target) +
                          " would lie over part of its original");
  constexpr std::array<const char*, 4> kLabels = {"Copy a tile", "Mirror a tile", "Turn a tile upside down",
                                                  "Turn a tile by 180 degrees"};
  Edit edit{kLabels[static_cast<std::size_t>(turn)], {}};
  copy_turned(level, from, to, turn, edit);
  add_shape_change(level, target, image, edit);
  return edit;
}

std::optional<int> free_target(const Level& level, int tile, ShapeTurn turn) {
  const TileShape image =
      turned(shape_of_tile(level, static_cast<TileNumber>(tile)), turn, level.map.tile_size());
  const auto is_free = [&](int number) { return number != 0 && number != tile && is_unused(level, number); };
  for (int target = 1; target < level.tile_count(); ++target) {
    const CellRect tiles = tiles_of_shape(level, target, image);
    if (!is_on_sheet(level, tiles)) continue;
    const std::vector<int> numbers = numbers_of(level, tiles);
    if (std::all_of(numbers.begin(), numbers.end(), is_free)) return target;
  }
  return std::nullopt;
}

std::vector<int> tiles_replaced(const Level& level, int tile, int target, ShapeTurn turn) {
  if (target == tile || !copy_turned(level, tile, target, turn)) return {};
  const TileShape image =
      turned(shape_of_tile(level, static_cast<TileNumber>(tile)), turn, level.map.tile_size());
  std::vector<int> replaced = numbers_of(level, tiles_of_shape(level, target, image));
  std::erase_if(replaced, [&](int number) { return is_unused(level, number); });
  return replaced;
}

}  // namespace talus
