#include "random_levels.h"

#include <cmath>
#include <memory>

namespace talus {
namespace {

constexpr int kColumns = 24, kRows = 14;

class LevelMaker {
 public:
  explicit LevelMaker(Dice& dice) : dice_(dice), tile_(any_tile_size(dice)) {
    level_.map = TileMap(kColumns, kRows, tile_);
    level_.tuning = new_tuning(tile_);
    level_.tile_shapes = {{}, {.kind = TileShape::Kind::solid}};
  }

  Level make() {
    add_floor();
    for (int i = dice_.up_to(3); i > 0; --i) add_platform();
    if (dice_.one_in(3)) add_tunnel();
    for (int i = dice_.up_to(12); i > 0; --i) add_shape();
    for (int i = dice_.up_to(2); i > 0; --i) add_curve();
    if (dice_.one_in(4)) add_layer();
    add_bodies();
    finish();
    return std::move(level_);
  }

 private:
  TileNumber number_of(const TileShape& shape) {
    const auto known = std::find(level_.tile_shapes.begin() + 1, level_.tile_shapes.end(), shape);
    const auto number = static_cast<TileNumber>(known - level_.tile_shapes.begin());
    if (known == level_.tile_shapes.end()) level_.tile_shapes.push_back(shape);
    return number;
  }
  void put(int column, int row, const TileShape& shape) {
    if (row >= 0 && row < kRows) level_.map.set({column, row}, number_of(shape));
  }
  // Dice are thrown one after the other: compilers differ in the order of arguments.
  void add_shape() {
    const TileShape shape = any_shape();
    const int row = dice_.up_to(kRows - 2), column = dice_.up_to(kColumns - 1);
    put(column, row, shape);
  }
  TileShape slope(double left, double right, bool one_way, TileShape::Side side = TileShape::Side::floor) {
    if (left == tile_.height && right == tile_.height)
      return {.kind = TileShape::Kind::solid, .side = TileShape::Side::floor, .one_way = one_way};
    return {.kind = TileShape::Kind::slope, .side = side, .one_way = one_way, .heights = {left, right}};
  }
  TileShape any_shape() {
    const double h = tile_.height, w = tile_.width;
    const bool one_way = dice_.one_in(3);
    const auto side = dice_.one_in(3) ? TileShape::Side::ceiling : TileShape::Side::floor;
    switch (dice_.up_to(4)) {
      case 0:
        return {.kind = TileShape::Kind::solid, .side = side, .one_way = one_way};
      case 1: {
        const double right = h * 0.25 + dice_.step(0, 0.75, 4) * h, left = dice_.step(0, 1, 4) * h;
        return slope(left, right, one_way, side);
      }
      case 2: {
        TileShape shape{.kind = TileShape::Kind::profile, .side = side, .one_way = one_way};
        for (int i = 0; i <= 4; ++i) shape.heights.push_back(dice_.step(0, h, 2) + 0.5);
        return shape;
      }
      case 3: {
        TileShape shape{.kind = TileShape::Kind::polygon, .side = side, .one_way = one_way};
        shape.points = {{0, h * dice_.step(0.25, 1, 4)},
                        {w / 2, dice_.step(0, h / 4, 4)},
                        {w, h * dice_.step(0.25, 1, 4)},
                        {w, h + 1},
                        {0, h + 1}};
        return shape;
      }
      default:
        return slope(h, h, false);
    }
  }

  // Goes on at the same height, up or down by a slope within a cell, over slopes of two cells, or by a step.
  void add_floor() {
    const int quarter = tile_.height / 4;
    int height = 4 * tile_.height;  // px above the bottom of the map
    for (int column = 0; column < kColumns; ++column) {
      const int left = height;
      const int kind = dice_.up_to(9);
      const int sign = kind > 5 || dice_.one_in(2) ? 1 : -1;
      if (kind < 5) height += sign * quarter * (1 << dice_.up_to(2));
      if (kind == 5) height += sign * tile_.height * (1 + dice_.up_to(1));
      const bool is_step = kind == 5;
      height = std::clamp(height / quarter * quarter, tile_.height, (kRows - 5) * tile_.height);
      add_column(column, is_step ? height : left, height, dice_.one_in(4));
    }
  }
  void add_column(int column, int left, int right, bool one_way) {
    const int h = tile_.height, base = std::min(left, right) / h * h;
    if (std::max(left, right) > base + h) {
      add_column(column, std::max(left, right), std::max(left, right), false);
      return;
    }
    const int row = kRows - 1 - base / h;
    const bool is_flat = left == base && right == base;
    if (!is_flat) put(column, row, slope(left - base, right - base, one_way));
    if (is_flat && one_way) put(column, row + 1, slope(h, h, true));
    for (int below = row + (is_flat && one_way ? 2 : 1); below < kRows; ++below)
      if (!one_way) put(column, below, slope(h, h, false));
  }
  void add_platform() {
    const int row = 1 + dice_.up_to(kRows - 4), first = dice_.up_to(kColumns - 2);
    const TileShape shape = any_shape();
    for (int column = first; column < std::min(kColumns, first + 1 + dice_.up_to(5)); ++column)
      put(column, row, dice_.one_in(3) ? any_shape() : shape);
  }
  // A ceiling just as high above the floor as the body is.
  void add_tunnel() {
    const int first = 4 + dice_.up_to(8), row = kRows - 8;
    for (int column = first; column < first + 6; ++column) {
      put(column, row, slope(tile_.height, tile_.height, false));
      put(column, row + 1, {});
      for (int below = row + 2; below < kRows; ++below)
        put(column, below, slope(tile_.height, tile_.height, false));
    }
    if (first > 0) put(first - 1, row + 1, {});
  }
  void add_curve() {
    const double width = level_.map.px_width(), height = level_.map.px_height();
    const double x0 = dice_.step(0, width * 0.6, 1), x1 = x0 + dice_.step(tile_.width, width * 0.4, 1);
    const double y = dice_.step(height * 0.2, height * 0.7, 1), rise = dice_.step(-1, 1, 4) * tile_.height;
    Curve curve;
    switch (dice_.up_to(3)) {
      case 0:
        curve.form = Segment{{x0, y}, {x1, y + rise}};
        break;
      case 1:
        curve.form = Arc{{(x0 + x1) / 2, y + (x1 - x0)}, (x1 - x0), x0, x1, true};
        break;
      case 2:
        curve.form = Parabola{{x0, y}, {x1, y + rise}, y + tile_.height};
        break;
      default:
        curve.form = Sine{x0, x1, y, tile_.height / 2.0, (x1 - x0) / 2, x0};
    }
    if (!problem_of(curve, level_.map)) level_.curves.push_back({"", curve, ""});
  }
  void add_layer() {
    MapCells cells(level_.map.cells().size());
    level_.layers.list.push_back({.name = "more", .is_ground = true});
    for (int i = 0; i < 8; ++i) {
      const auto at = static_cast<std::size_t>(dice_.up_to(kColumns * kRows - 1));
      cells.set(at, {number_of(any_shape()), TileTurn::none});
    }
    level_.layers.list.back().cells = std::make_shared<const MapCells>(std::move(cells));
  }

  void add_bodies() {
    const Vec2 usual = new_body_size(BodyKind::player, tile_);
    for (int i = 0; i < 2; ++i) {
      Spawn spawn;
      spawn.kind = i == 0 ? BodyKind::player : dice_.one_in(2) ? BodyKind::player : BodyKind::ball;
      spawn.size = i == 0 && dice_.one_in(2)
                       ? usual
                       : Vec2{dice_.step(0.5, 1.75, 4) * usual.x, dice_.step(0.5, 2, 4) * usual.y};
      spawn.foot = dice_.one_in(2) ? Foot::box : Foot::centre;
      spawn.velocity.x = spawn.kind == BodyKind::ball ? dice_.in(0.5, 4) : 0;
      spawn.position = {dice_.in(0, level_.map.px_width() - 64), 0};
      level_.spawns.push_back(spawn);
    }
    level_.tuning.player.surface_speed = dice_.one_in(4) ? 1 : 0;
    if (dice_.one_in(4)) level_.tuning.exact.steepest = 1;
  }
  // The sheet and what it keeps by tile fit the shapes.
  void finish() {
    std::vector<TileShape> shapes = std::move(level_.tile_shapes);
    level_.tile_shapes.assign(kCartTiles, {});
    std::move(shapes.begin(), shapes.end(), level_.tile_shapes.begin());
  }

  Dice& dice_;
  TileSize tile_;
  Level level_;
};

}  // namespace

Level random_level(Dice& dice) { return LevelMaker(dice).make(); }

}  // namespace talus
