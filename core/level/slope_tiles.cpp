// Goes column by column, from left to right.
#include "slope_tiles.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "../collision/tile_outlines.h"
#include "tile_color.h"

namespace talus {
namespace {

using Result = tl::expected<SlopeTiles, std::string>;

tl::unexpected<std::string> failure(std::string message) {
  return tl::unexpected<std::string>(std::move(message));
}

// The floor to follow: a line that goes on level beyond its ends, or as the tiles there do.
struct Line {
  Vec2 from, to;                                     // x in whole px, from.x < to.x
  std::optional<TileShape> before = {}, after = {};  // of the cells beyond the ends
  Vec2 before_base = {}, after_base = {};            // px, their corners at the bottom left
  TileSize tile = {};

  double y_at(double x) const {
    if (x <= from.x) return before ? y_of(*before, before_base, x) : from.y;
    if (x >= to.x) return after ? y_of(*after, after_base, x) : to.y;
    return from.y + (to.y - from.y) * ((x - from.x) / (to.x - from.x));
  }
  double grained_y_at(double x) const { return std::round(y_at(x) / kSlopeTileGrain) * kSlopeTileGrain; }
  bool is_straight_over(double x0, double x1) const {
    return (from.y == to.y && !before && !after) || (x0 >= from.x && x1 <= to.x);
  }
  double y_of(const TileShape& shape, Vec2 base, double x) const {
    return base.y - height_of_line(shape, std::clamp(x - base.x, 0.0, 1.0 * tile.width), tile);
  }
};

// Lets the line go on as the floor of the tiles in which it ends, where that floor ends at the line's end.
void join(const Level& level, Line& line) {
  const TileMap& map = level.map;
  line.tile = map.tile_size();
  const auto find = [&](Vec2 end, std::optional<TileShape>& found, Vec2& base) {
    const int column = map.column_at(end.x);
    if (map.x_of(column) == end.x || column >= map.width()) return;  // the tile ends where the line does
    const int first = std::max(map.row_at(end.y) - 1, 0);
    for (Cell c{column, first}; c.y < std::min(first + kMaxShapeTiles + 2, map.height()); ++c.y) {
      const TileShape shape = shape_of_cell(level, map.at(c));
      if (!has_heights(shape) || shape.side != TileShape::Side::floor || shape.tiles != 1) continue;
      if (problem_of(shape, line.tile)) continue;
      base = {map.x_of(c.x), map.y_of(c.y + 1)};
      if (std::abs(line.y_of(shape, base, end.x) - end.y) > kSlopeTileGrain) continue;
      found = shape;
      return;
    }
  };
  find(line.from, line.before, line.before_base);
  find(line.to, line.after, line.after_base);
}

// side: px, of a cell.
int cells_up_to(double px, int side) { return static_cast<int>(std::ceil(px / side)); }

double highest_of(const TileShape& shape, TileSize tile) {
  if (shape.kind == TileShape::Kind::solid) return tile.height;
  return *std::max_element(shape.heights.begin(), shape.heights.end());
}

bool is_floor(const TileShape& shape, TileSize tile) {
  using Kind = TileShape::Kind;
  if (shape.kind == Kind::none || has_parts(shape) || problem_of(shape, tile)) return false;
  return shape.kind == Kind::solid || shape.side == TileShape::Side::floor;
}

constexpr int kMostFill = 64;  // rows below a slope in which a fill looks for ground

// Collects what to place. A cell keeps the first tile that it is given.
class Layer {
 public:
  explicit Layer(const Level& level) : level_(level), map_(level.map) {}

  void place(Cell cell, TileNumber tile) { tiles_.try_emplace({cell.x, cell.y}, tile); }
  // A cell with a part of the floor in it. The tile SlopeTilesOptions::below goes under it.
  void own(Cell cell) { owners_.push_back(cell); }

  // The row of the lowest cell with a part of the floor in it.
  int lowest_row() const {
    int row = 0;
    for (const Cell& cell : owners_) row = std::max(row, cell.y);
    return row;
  }

  // below: goes under each owner, and further down if the ground is filled, but not below `last` in a column
  // without a full tile.
  Result take(std::vector<SlopeTiles::Drawn> drawn, std::optional<TileNumber> below, bool fills, int last) {
    for (const Cell& cell : owners_) {
      if (!below) break;
      const int end = fills ? std::min(end_of_fill(cell, last), map_.height()) : cell.y + 2;
      for (Cell under{cell.x, cell.y + 1}; under.y < end; ++under.y)
        if (map_.contains(under) && !is_ball_tile(level_, map_.tile_at(under))) place(under, *below);
    }
    SlopeTiles result{std::move(drawn), {}};
    for (const auto& [at, tile] : tiles_) {
      const Cell cell = {at.first, at.second};
      if (!map_.contains(cell)) return failure("the slope's tiles would leave the map");
      result.placed.push_back({cell, tile});
    }
    return result;
  }

 private:
  // The row of the first full tile under a cell; the one after `last` if there is none near.
  int end_of_fill(Cell cell, int last) const {
    const int bottom = std::min(map_.height(), std::max(last, cell.y) + kMostFill);
    for (Cell under{cell.x, cell.y + 1}; under.y < bottom && map_.contains(under); ++under.y)
      if (is_full(shape_of_cell(level_, map_.at(under)))) return under.y;
    return last + 1;
  }

  const Level& level_;
  const TileMap& map_;
  std::map<std::pair<int, int>, TileNumber> tiles_;  // by column and row
  std::vector<Cell> owners_;
};

// ---- Drawing ----

class Drawer {
 public:
  Drawer(const Level& level, const Line& line, const SlopeTilesOptions& options)
      : level_(level),
        size_(level.map.tile_size()),
        line_(line),
        options_(options),
        layer_(level),
        used_(static_cast<std::size_t>(level.tile_count())) {
    for (const TileNumber tile : level.map.cells().tiles()) used_[tile] = true;
  }

  Result run() {
    const int end = cells_up_to(line_.to.x, size_.width);
    for (int column = level_.map.column_at(line_.from.x); column < end; ++column) {
      if (auto problem = draw_column(column)) return failure(*std::move(problem));
    }
    std::optional<TileNumber> below = options_.below;
    const int last = layer_.lowest_row() + (below ? 1 : 0);
    if (options_.fills && !below) {
      TileImage full;
      full.fill(options_.ground_color);
      below = tile_with(full, {.kind = TileShape::Kind::solid});
      if (!below) return failure("there is no blank tile to fill the ground with");
    }
    return layer_.take(std::move(drawn_), below, options_.fills, last);
  }

 private:
  std::optional<std::string> draw_column(int column) {
    const double x0 = level_.map.x_of(column), x1 = level_.map.x_of(column + 1);
    double lowest = line_.grained_y_at(x0), highest = lowest;
    for (double x = x0 + 1; x <= x1; ++x) {
      lowest = std::max(lowest, line_.grained_y_at(x));
      highest = std::min(highest, line_.grained_y_at(x));
    }
    int bottom_row = cells_up_to(lowest, size_.height);
    // A level floor on the side of two cells belongs to the lower one.
    if (highest == level_.map.y_of(bottom_row)) ++bottom_row;
    const double bottom = level_.map.y_of(bottom_row);
    const int most = kMaxShapeTiles * size_.height;
    if (bottom - highest > most)
      return "the slope is too steep: the floor of a tile can rise by at most " + std::to_string(most) +
             " px";

    TileShape shape;
    const bool straight = line_.is_straight_over(x0, x1);
    shape.kind = straight ? TileShape::Kind::slope : TileShape::Kind::profile;
    for (double x = x0; x <= x1; x += straight ? size_.width : 1)
      shape.heights.push_back(bottom - line_.grained_y_at(x));

    const Cell owner = {column, bottom_row - 1};
    layer_.own(owner);
    for (int row = owner.y; row == owner.y || level_.map.y_of(row + 1) > highest; --row) {
      const TileImage image = image_of({column, row});
      const auto tile = row == owner.y ? tile_with(with_line(image), shape) : tile_with(image, TileShape());
      if (!tile) return "there are too few blank tiles to draw the slope with";
      if (*tile != 0) layer_.place({column, row}, *tile);
    }
    return {};
  }

  // The part of the ground that a cell shows, on an image that fills the cell.
  TileImage image_of(Cell cell) const {
    const double px_wide = 1.0 * size_.width / kCartTileSize, px_high = 1.0 * size_.height / kCartTileSize;
    TileImage image{};
    // Colour 0 would be no edge.
    const std::uint8_t edge = options_.line_color == 0 ? options_.ground_color : options_.line_color;
    for (int x = 0; x < kCartTileSize; ++x) {
      const double floor =
          line_.y_at(level_.map.x_of(cell.x) + (x + 0.5) * px_wide) - level_.map.y_of(cell.y);
      for (int y = 0; y < kCartTileSize; ++y) {
        if ((y + 0.5) * px_high < floor) continue;
        image[y * kCartTileSize + x] = (y - 0.5) * px_high < floor ? edge : options_.ground_color;
      }
    }
    return image;
  }

  // A floor that is too low for the middle of a pixel is a line of pixels all the same, so that it is seen.
  TileImage with_line(TileImage image) const {
    if (image == TileImage{})
      std::fill(image.end() - kCartTileSize, image.end(),
                options_.line_color == 0 ? options_.ground_color : options_.line_color);
    return image;
  }

  // Whether a tile of the sheet has this shape, and shows it by the same pixels, in any colours.
  bool is_alike(int tile, const TileImage& image, const TileShape& shape) const {
    const Sheet& sheet = level_.sheet(SheetId::tiles);
    const FlagSet flags = sheet.flags[tile];
    const int solid = level_.roles.solid;
    const bool is_plain = flags == 0 || (shape.kind == TileShape::Kind::solid && has_flag(flags, solid) &&
                                         flags == flag_bit(solid));
    if (!is_plain || shape_of_tile(level_, static_cast<TileNumber>(tile)) != shape) return false;
    const std::uint64_t drawn = drawn_pixels(level_, static_cast<TileNumber>(tile));
    for (std::size_t i = 0; i < image.size(); ++i)
      if ((image[i] != 0) != ((drawn >> i & 1) != 0)) return false;
    return true;
  }

  // A tile that already looks like this, or was drawn so, or can be drawn so; nothing if there are no more
  // blank tiles. A blank image without a shape is tile 0.
  std::optional<TileNumber> tile_with(const TileImage& image, const TileShape& shape) {
    if (image == TileImage{} && shape == TileShape()) return 0;
    for (const SlopeTiles::Drawn& drawn : drawn_) {
      if (drawn.image == image && drawn.shape == shape) return drawn.tile;
    }
    const Sheet& sheet = level_.sheet(SheetId::tiles);
    for (int tile = 1; tile < level_.tile_count(); ++tile) {
      if (sheet.images[tile] == image && level_.tile_shapes[tile] == shape && sheet.flags[tile] == 0)
        return static_cast<TileNumber>(tile);
    }
    for (int tile = 1; tile < level_.tile_count(); ++tile)
      if (is_alike(tile, image, shape)) return static_cast<TileNumber>(tile);
    for (int tile = 1; tile < level_.tile_count(); ++tile) {
      const bool blank = is_blank(level_, static_cast<TileNumber>(tile)) &&
                         level_.tile_shapes[tile] == TileShape() && sheet.flags[tile] == 0 && !used_[tile];
      if (!blank) continue;
      used_[tile] = true;
      drawn_.push_back({static_cast<TileNumber>(tile), image, shape});
      return static_cast<TileNumber>(tile);
    }
    return {};
  }

  const Level& level_;
  TileSize size_;  // of the map's cells
  const Line& line_;
  const SlopeTilesOptions& options_;
  Layer layer_;
  std::vector<bool> used_;  // by tile: whether it is on the map, or drawn
  std::vector<SlopeTiles::Drawn> drawn_;
};

// ---- Choosing from a set ----

class Chooser {
 public:
  Chooser(const Level& level, const Line& line, const SlopeTilesOptions& options)
      : level_(level), size_(level.map.tile_size()), line_(line), options_(options), layer_(level) {
    for (const TileNumber tile : options.set) {
      TileShape shape = shape_of_tile(level, tile);
      if (is_floor(shape, size_)) candidates_.push_back({tile, std::move(shape)});
    }
  }

  Result run() {
    if (candidates_.empty()) return failure("the set has no tile with a floor");
    int column = level_.map.column_at(line_.from.x);
    std::optional<double> floor;  // px, at the end of the last tile
    while (column < cells_up_to(line_.to.x, size_.width)) {
      const std::optional<Choice> best = choose(column, floor);
      if (!best) return failure("the set has no tile that begins where the tile before it ends");
      if (best->off > size_.height)
        return failure("the tiles of the set would leave the line by more than a tile");
      lay(*best, column);
      column += best->candidate->shape.tiles;
      floor = best->end;
    }
    return layer_.take({}, options_.below, options_.fills, layer_.lowest_row() + 1);
  }

 private:
  struct Candidate {
    TileNumber tile;
    TileShape shape;
  };
  struct Choice {
    const Candidate* candidate = nullptr;
    int bottom_row = 0;  // the first row below its cell
    double off = 0;      // px, largest distance of its floor from the line
    double end = 0;      // px, its floor at its right side
  };

  // The tile, and its row, that stays nearest to the line; of equally near ones, the first of the set.
  std::optional<Choice> choose(int column, std::optional<double> floor) const {
    std::optional<Choice> best;
    for (const Candidate& candidate : candidates_) {
      const double begin = height_of_line(candidate.shape, 0, size_);
      const double wanted = floor.value_or(line_.y_at(level_.map.x_of(column))) + begin;
      const double row = std::round(wanted / size_.height);
      if (floor && row * size_.height != wanted) continue;
      const Choice choice = judged(candidate, column, static_cast<int>(row));
      if (!best || choice.off < best->off) best = choice;
    }
    return best;
  }

  Choice judged(const Candidate& candidate, int column, int bottom_row) const {
    const int width = candidate.shape.tiles * size_.width;
    const double bottom = level_.map.y_of(bottom_row);
    Choice choice{&candidate, bottom_row, 0, bottom - height_of_line(candidate.shape, width, size_)};
    for (int x = 0; x <= width; ++x) {
      const double y = bottom - height_of_line(candidate.shape, x, size_);
      choice.off = std::max(choice.off, std::abs(y - line_.y_at(level_.map.x_of(column) + x)));
    }
    return choice;
  }

  void lay(const Choice& choice, int column) {
    const TileShape& shape = choice.candidate->shape;
    const SheetLayout sheet = level_.sheet(SheetId::tiles).layout();
    const Cell place = sheet.place_of(choice.candidate->tile);
    for (int i = 0; i < shape.tiles; ++i) {
      const Cell owner = {column + i, choice.bottom_row - 1};
      layer_.own(owner);
      for (int up = 0; up < cells_up_to(highest_of(shape, size_), size_.height); ++up) {
        const Cell part = {place.x + i, place.y - up};
        const bool is_own = i == 0 && up == 0;
        if (is_own || (sheet.contains(part) && is_mere_picture(sheet.tile_at(part))))
          layer_.place({owner.x, owner.y - up}, static_cast<TileNumber>(sheet.tile_at(part)));
      }
    }
  }

  bool is_mere_picture(int tile) const {
    return !is_blank(level_, static_cast<TileNumber>(tile)) &&
           shape_of_tile(level_, static_cast<TileNumber>(tile)).kind == TileShape::Kind::none;
  }

  const Level& level_;
  TileSize size_;  // of the map's cells
  const Line& line_;
  const SlopeTilesOptions& options_;
  Layer layer_;
  std::vector<Candidate> candidates_;
};

}  // namespace

tl::expected<SlopeTiles, std::string> slope_tiles(const Level& level, Vec2 a, Vec2 b,
                                                  const SlopeTilesOptions& options) {
  const double width = level.map.px_width(), height = level.map.px_height();
  for (const Vec2& p : {a, b}) {
    if (!(p.x >= 0 && p.y >= 0 && p.x <= width && p.y <= height))
      return failure("an end of the slope is not on the map");
  }
  Line line{{std::round(a.x), weld(a.y)}, {std::round(b.x), weld(b.y)}};
  if (line.from.x > line.to.x) std::swap(line.from, line.to);
  if (line.from.x == line.to.x) return failure("the slope is vertical");
  if (options.set.empty() && level.sheet(SheetId::tiles).picture != nullptr)
    return failure(
        "the tiles are in true colour, so no slope can be drawn on them: choose tiles with slopes");
  if (options.set.empty()) join(level, line);
  return options.set.empty() ? Drawer(level, line, options).run() : Chooser(level, line, options).run();
}

}  // namespace talus
