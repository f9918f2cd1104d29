#include "random_walkways.h"

#include <algorithm>
#include <cmath>

namespace talus {
namespace {

class WalkwayMaker {
 public:
  explicit WalkwayMaker(Dice& dice) : dice_(dice), tile_(any_tile_size(dice)) {
    level_.map = TileMap(kColumns, kRows, tile_);
    level_.tuning = new_tuning(tile_);
  }

  Level make() {
    add_body();
    const bool is_corridor = dice_.one_in(2);
    is_of_tiles_ = !is_corridor && dice_.one_in(2);
    draw_floor(is_corridor);
    if (is_of_tiles_)
      put_tiles();
    else
      add_line(floor_, true);
    if (is_corridor) add_line(ceiling(), false);
    return std::move(level_);
  }

 private:
  using Points = std::vector<Vec2>;

  static constexpr int kColumns = 30, kRows = 30;
  static constexpr double kMargin = 5;  // cells at both sides of the map where the floor is level

  void add_body() {
    Spawn body;
    body.kind = BodyKind::player;
    body.foot = dice_.one_in(3) ? Foot::box : Foot::centre;
    body.size = {dice_.step(0.5, 3.5, 4) * tile_.width, dice_.step(0.5, 2, 4) * tile_.height};
    body.size = {2 * std::round(body.size.x / 2), std::round(body.size.y)};
    body.position = {tile_.width * 1.0, kRows * tile_.height / 2.0 - body.size.y};
    level_.spawns.push_back(body);
    PlayerTuning& numbers = level_.tuning.player;
    numbers.run_speed *= dice_.one_in(3) ? dice_.in(0.05, 1) : dice_.in(1, 3);
    numbers.run_gain = numbers.run_loss = numbers.run_speed;
  }

  // Its joints are at whole px; those of tiles at the borders of columns, at quarters of their height.
  void draw_floor(bool only_one_way) {
    const double end = level_.map.px_width(), height = tile_.height;
    const double sign = dice_.one_in(2) ? 1 : -1;
    Vec2 at{kMargin * tile_.width, kRows * height / 2};
    floor_ = {{0, at.y}, at};
    while (at.x < end - kMargin * tile_.width) {
      const double direction = only_one_way ? sign : dice_.one_in(2) ? 1 : -1;
      Vec2 next;
      if (is_of_tiles_) {
        next = {at.x + tile_.width, at.y + direction * height / 4 * dice_.up_to(4)};
        const double row = std::floor(std::min(at.y, next.y) / height);
        if (std::max(at.y, next.y) > (row + 1) * height) next.y = at.y;  // a slope is in one row
      } else {
        const int run = 1 + dice_.up_to(17), rise = dice_.up_to(run);
        const int times = 1 + dice_.up_to(4);
        next = {at.x + times * run, at.y + direction * times * rise};
      }
      const bool is_on_map = next.y > 4 * height && next.y < (kRows - 2) * height;
      if (!is_on_map) next.y = at.y;
      if (next.x > end - kMargin * tile_.width) break;
      floor_.push_back(at = next);
    }
    floor_.push_back({end, at.y});
  }

  // The lowest line under which the body can walk along a floor that only rises, or only falls.
  Points ceiling() const {
    const Spawn& body = level_.spawns.front();
    const double reach = body.foot == Foot::box ? body.size.x : body.size.x / 2;
    const bool rises = floor_.back().y < floor_.front().y;
    Points line = floor_;
    for (Vec2& point : line) point = point - Vec2{rises ? reach : -reach, body.size.y};
    line.front().x = 0;
    line.back().x = level_.map.px_width();
    return line;
  }

  void add_line(const Points& line, bool is_floor) {
    if (dice_.one_in(2)) {
      for (std::size_t i = 1; i < line.size(); ++i)
        if (!(line[i] == line[i - 1])) level_.curves.push_back({"", {Segment{line[i - 1], line[i]}}, ""});
      if (!is_floor)
        for (LevelCurve& curve : level_.curves) curve.curve.faces = Curve::Faces::both;
      return;
    }
    MapObject object;
    object.form = MapObject::Form::polygon;
    object.points = line;
    const double beyond = is_floor ? level_.map.px_height() : 0;
    object.points.push_back({level_.map.px_width(), beyond});
    object.points.push_back({0, beyond});
    level_.objects.push_back({.name = "", .is_ground = true});
    level_.objects.back().objects.push_back(object);
  }

  TileNumber number_of(const TileShape& shape) {
    auto& shapes = level_.tile_shapes;
    const auto known = std::find(shapes.begin() + 1, shapes.begin() + used_, shape);
    if (known == shapes.begin() + used_) shapes[static_cast<std::size_t>(used_++)] = shape;
    return static_cast<TileNumber>(known - shapes.begin());
  }
  void put_tiles() {
    const double height = tile_.height;
    const bool has_hollows = dice_.one_in(2);
    for (int column = 0; column < kColumns; ++column) {
      const double left = floor_at(column * tile_.width), right = floor_at((column + 1) * tile_.width);
      const int row = static_cast<int>(std::floor(std::min(left, right) / height));
      const double bottom = (row + 1) * height;
      const bool is_full = left == right && left == row * height;
      TileShape shape{.kind = is_full ? TileShape::Kind::solid : TileShape::Kind::slope};
      if (!is_full) shape.heights = {bottom - left, bottom - right};
      level_.map.set({column, row}, number_of(shape));
      for (int below = row + 1; below < kRows; ++below)
        if (!has_hollows || dice_.one_in(2))
          level_.map.set({column, below}, number_of({.kind = TileShape::Kind::solid}));
    }
  }
  double floor_at(double x) const {
    const auto after = std::find_if(floor_.begin(), floor_.end(), [x](Vec2 point) { return point.x > x; });
    if (after == floor_.end()) return floor_.back().y;
    const Vec2 from = *(after - 1);
    return from.y + (after->y - from.y) * ((x - from.x) / (after->x - from.x));
  }

  Dice& dice_;
  TileSize tile_;
  Level level_;
  Points floor_;
  bool is_of_tiles_ = false;
  int used_ = 1;  // tile shapes
};

}  // namespace

Level random_walkway(Dice& dice) { return WalkwayMaker(dice).make(); }

}  // namespace talus
