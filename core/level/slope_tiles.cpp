// Goes column by column, from left to right.
#include "slope_tiles.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

#include "../collision/tile_outlines.h"
#include "slope_layer.h"
#include "tile_color.h"

namespace talus {
namespace {

constexpr const char* kNoBlankTiles = "there are too few blank tiles to draw the slope with";

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
    return base.y - height_of_line(shape, std::clamp(x - base.x, 0.0, 1.0 * shape.tiles * tile.width), tile);
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
    for (Cell c{0, first}; c.y < std::min(first + kMaxShapeTiles + 2, map.height()); ++c.y) {
      for (c.x = std::max(column - kMaxShapeTiles + 1, 0); c.x <= column; ++c.x) {
        const TileShape shape = shape_of_cell(level, map.at(c));
        if (!has_heights(shape) || shape.side != TileShape::Side::floor || c.x + shape.tiles <= column)
          continue;
        if (problem_of(shape, line.tile)) continue;
        base = {map.x_of(c.x), map.y_of(c.y + 1)};
        if (std::abs(line.y_of(shape, base, end.x) - end.y) > kSlopeTileGrain) continue;
        found = shape;
        return;
      }
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

// The colour of a pixel of the ground that so many others are above.
std::uint8_t color_at_depth(double depth, const SlopeTilesOptions& options) {
  const auto above = static_cast<std::size_t>(depth);
  const bool is_edge = above < options.edge_colors.size() && options.edge_colors[above] != 0;
  return is_edge ? options.edge_colors[above] : options.ground_color;
}

// The part of the ground along a line that a cell shows, on an image that fills the cell.
TileImage image_of(Cell cell, const Line& line, const SlopeTilesOptions& options) {
  const auto [width, height] = line.tile;
  const double px_wide = 1.0 * width / kCartTileSize, px_high = 1.0 * height / kCartTileSize;
  TileImage image{};
  for (int x = 0; x < kCartTileSize; ++x) {
    const double floor =
        (line.y_at(1.0 * cell.x * width + (x + 0.5) * px_wide) - 1.0 * cell.y * height) / px_high;
    for (int y = 0; y < kCartTileSize; ++y)
      if (y + 0.5 >= floor) image[y * kCartTileSize + x] = color_at_depth(y + 0.5 - floor, options);
  }
  return image;
}

// A floor that is too low for the middle of a pixel is a line of pixels all the same, so that it is seen.
TileImage with_line(TileImage image, const SlopeTilesOptions& options) {
  if (image == TileImage{}) std::fill(image.end() - kCartTileSize, image.end(), color_at_depth(0, options));
  return image;
}

// How many pixels of a tile of the sheet are drawn where those of an image are not, or the other way round.
int pixels_unlike(const Level& level, TileNumber tile, const TileImage& image) {
  std::uint64_t wanted = 0;
  for (std::size_t i = 0; i < image.size(); ++i) wanted |= std::uint64_t{image[i] != 0} << i;
  return std::popcount(wanted ^ drawn_pixels(level, tile));
}

// ---- Tiles with a given look and shape ----

class TileSupply {
 public:
  explicit TileSupply(const Level& level) : level_(level) {}

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
    if (used_.empty()) note_used();
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
  std::vector<SlopeTiles::Drawn> take() { return std::move(drawn_); }

 private:
  // Looks at the whole map, and so only when a tile is to be drawn.
  void note_used() {
    used_.resize(static_cast<std::size_t>(level_.tile_count()));
    for (const TileNumber tile : level_.map.cells().tiles()) used_[tile] = true;
  }
  // Whether a tile of the sheet has this shape, and shows it by the same pixels, in any colours.
  bool is_alike(int tile, const TileImage& image, const TileShape& shape) const {
    const Sheet& sheet = level_.sheet(SheetId::tiles);
    const FlagSet flags = sheet.flags[tile];
    const int solid = level_.roles.solid;
    const bool is_plain = flags == 0 || (shape.kind == TileShape::Kind::solid && has_flag(flags, solid) &&
                                         flags == flag_bit(solid));
    if (!is_plain || shape_of_tile(level_, static_cast<TileNumber>(tile)) != shape) return false;
    return pixels_unlike(level_, static_cast<TileNumber>(tile), image) == 0;
  }

  const Level& level_;
  std::vector<bool> used_;  // by tile: whether it is on the map, or drawn; empty: not known yet
  std::vector<SlopeTiles::Drawn> drawn_;
};

// ---- Drawing ----

class Drawer {
 public:
  Drawer(const Level& level, const Line& line, const SlopeTilesOptions& options, SlopeLayer& layer,
         TileSupply& supply)
      : level_(level),
        size_(level.map.tile_size()),
        line_(line),
        options_(options),
        layer_(layer),
        supply_(supply) {}

  // Returns an error, or nothing.
  std::optional<std::string> run() {
    const int end = cells_up_to(line_.to.x, size_.width);
    for (int column = level_.map.column_at(line_.from.x); column < end; ++column) {
      if (auto problem = draw_column(column)) return problem;
    }
    return {};
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
      const TileImage image = image_of({column, row}, line_, options_);
      const auto tile = row == owner.y ? supply_.tile_with(with_line(image, options_), shape)
                                       : supply_.tile_with(image, TileShape());
      if (!tile) return kNoBlankTiles;
      if (*tile != 0) layer_.place({column, row}, *tile);
    }
    return {};
  }

  const Level& level_;
  TileSize size_;  // of the map's cells
  const Line& line_;
  const SlopeTilesOptions& options_;
  SlopeLayer& layer_;
  TileSupply& supply_;
};

// ---- Choosing from a set ----

class Chooser {
 public:
  Chooser(const Level& level, const Line& line, const SlopeTilesOptions& options, SlopeLayer& layer)
      : level_(level), size_(level.map.tile_size()), line_(line), options_(options), layer_(layer) {
    for (const TileNumber tile : options.set) {
      TileShape shape = shape_of_tile(level, tile);
      if (is_floor(shape, size_)) candidates_.push_back({tile, std::move(shape)});
    }
  }

  // Returns an error, or nothing.
  std::optional<std::string> run() {
    if (candidates_.empty()) return "the set has no tile with a floor";
    int column = level_.map.column_at(line_.from.x);
    std::optional<double> floor;  // px, at the end of the last tile
    while (column < cells_up_to(line_.to.x, size_.width)) {
      const std::optional<Choice> best = choose(column, floor);
      if (!best)
        return floor ? "the set has no tile that goes on where the one before it ends"
                     : "the set has no tile that follows the line";
      if (best->off > options_.most_off.value_or(size_.height))
        return "the tiles of the set would leave the line by more than a tile";
      lay(*best, column);
      column += best->candidate->shape.tiles;
      floor = best->end;
    }
    return {};
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
      if (goes_back(choice, column)) continue;
      if (options_.most_off && !looks_right(choice, column)) continue;
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

  // Whether it falls where the line rises, or rises where it falls.
  bool goes_back(const Choice& choice, int column) const {
    const double left = level_.map.x_of(column), right = left + choice.candidate->shape.tiles * size_.width;
    const double rise = choice.end - height_at_begin(choice), wanted = line_.y_at(right) - line_.y_at(left);
    return left >= line_.from.x && right <= line_.to.x && (wanted == 0 ? rise != 0 : rise * wanted < 0);
  }
  // px, y of its floor at its left side.
  double height_at_begin(const Choice& choice) const {
    return level_.map.y_of(choice.bottom_row) - height_of_line(choice.candidate->shape, 0, size_);
  }

  void lay(const Choice& choice, int column) {
    for (int i = 0; i < choice.candidate->shape.tiles; ++i) layer_.own({column + i, choice.bottom_row - 1});
    for_each_part(choice, column, [&](Cell cell, TileNumber tile) {
      if (tile != 0) layer_.place(cell, tile);
    });
  }

  // Whether its tiles show the line, but for some tufts of grass.
  bool looks_right(const Choice& choice, int column) const {
    bool is_right = true;
    for_each_part(choice, column, [&](Cell cell, TileNumber tile) {
      TileImage image = image_of(cell, line_, options_);
      if (cell.y == choice.bottom_row - 1) image = with_line(image, options_);
      is_right = is_right && pixels_unlike(level_, tile, image) <= kCartTileSize;
    });
    return is_right;
  }

  // Calls see(cell, tile) for its own cell, and for those beside and above it that show a part of it; tile 0:
  // the sheet has no picture of that part.
  template <typename See>
  void for_each_part(const Choice& choice, int column, See see) const {
    const TileShape& shape = choice.candidate->shape;
    const SheetLayout sheet = level_.sheet(SheetId::tiles).layout();
    const Cell place = sheet.place_of(choice.candidate->tile);
    for (int i = 0; i < shape.tiles; ++i) {
      for (int up = 0; up < cells_up_to(highest_of(shape, size_), size_.height); ++up) {
        const Cell part = {place.x + i, place.y - up};
        const bool is_own = i == 0 && up == 0;
        const bool is_seen = is_own || (sheet.contains(part) && is_mere_picture(sheet.tile_at(part)));
        see(Cell{column + i, choice.bottom_row - 1 - up},
            static_cast<TileNumber>(is_seen ? sheet.tile_at(part) : 0));
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
  SlopeLayer& layer_;
  std::vector<Candidate> candidates_;
};

// Cuts the old ground off above the slope, and fills it below. Returns an error, or nothing.
std::optional<std::string> fit_to_ground(const Level& level, const SlopeTilesOptions& options,
                                         SlopeLayer& layer, TileSupply& supply) {
  if (options.fills) layer.cut();
  if (layer.is_empty()) return "the line is deep inside of the ground";
  std::optional<TileNumber> below = options.below;
  const bool is_drawn = options.set.empty();
  const int last = layer.lowest_row() + (below || !is_drawn ? 1 : 0);
  if (options.fills && !below && is_drawn) {
    TileImage full;
    full.fill(options.ground_color);
    below = supply.tile_with(full, {.kind = TileShape::Kind::solid});
    if (!below) return "there is no blank tile to fill the ground with";
  }
  if (below) layer.fill(*below, options.fills, last);
  if (!options.fills) return {};
  const bool can_draw = level.sheet(SheetId::tiles).picture == nullptr;
  for (const SlopeLayer::Rest& rest : layer.rests()) {
    if (!can_draw) return "an end is in the middle of a slope of several tiles: let it be at an end of that";
    const auto tile =
        supply.tile_with(level.sheet(SheetId::tiles).images[level.map.tile_at(rest.cell)], rest.shape);
    if (!tile) return kNoBlankTiles;
    layer.place(rest.cell, *tile);
  }
  return {};
}

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
  join(level, line);
  SlopeLayer layer(level);
  TileSupply supply(level);
  auto problem = options.set.empty() ? Drawer(level, line, options, layer, supply).run()
                                     : Chooser(level, line, options, layer).run();
  if (!problem) problem = fit_to_ground(level, options, layer, supply);
  if (problem) return failure(*std::move(problem));
  return layer.placed().map([&](std::vector<SlopeTiles::Placed> placed) {
    return SlopeTiles{supply.take(), std::move(placed)};
  });
}

}  // namespace talus
