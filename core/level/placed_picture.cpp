#include <talus/level/placed_picture.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace talus {
namespace {

Vec2 rotated(Vec2 v, double degrees) {
  if (degrees == 0) return v;
  constexpr double kHalfTurn = 180;
  const double angle = degrees * std::numbers::pi / kHalfTurn;
  const double cos = std::cos(angle), sin = std::sin(angle);
  return {v.x * cos - v.y * sin, v.x * sin + v.y * cos};
}

// Of the top left corner of its box from its position, before it is rotated.
Vec2 corner_of(const MapObject& object) {
  if (object.form != MapObject::Form::tile) return {};
  return {-object.anchor.x * object.size.x, -object.anchor.y * object.size.y};
}

}  // namespace

PlacedPicture placed(const PicturePart& part, Vec2 corner, Vec2 size) {
  Vec2 scale{size.x / part.width, size.y / part.height};
  if (part.keeps_ratio) scale.x = scale.y = std::min(scale.x, scale.y);
  Vec2 centre = corner + size * 0.5 + Vec2{part.shift_x * scale.x, part.shift_y * scale.y};
  Vec2 right{part.width * scale.x, 0}, down{0, part.height * scale.y};
  if (part.swaps_axes) {
    const double up = (size.y - size.x) / 2;
    centre = centre + Vec2{up, up};
    std::swap(right.x, right.y);
    std::swap(down.x, down.y);
  }
  if (part.mirrors_x) right.x = -right.x, down.x = -down.x;
  if (part.mirrors_y) right.y = -right.y, down.y = -down.y;
  return {part, centre - (right + down) * 0.5, right, down};
}

PlacedPicture placed(const LargeTile& tile, Cell cell, TileSize size, TileTurn turn) {
  PicturePart part = tile.part;
  const TileTurn both = after_turn(turn_of(part.swaps_axes, part.mirrors_x, part.mirrors_y), turn);
  part.swaps_axes = has_flip(both, TileTurn::diagonal);
  part.mirrors_x = has_flip(both, TileTurn::left_right);
  part.mirrors_y = has_flip(both, TileTurn::up_down);
  const Vec2 low{1.0 * cell.x * size.width, (1.0 + cell.y) * size.height};
  return placed(part, {low.x, low.y - tile.size.height}, {1.0 * tile.size.width, 1.0 * tile.size.height});
}

void put_upright(const MapObject& object, MapObject& plain) {
  const Rect box = bounds_of(placed(object.picture, corner_of(object), object.size));
  plain.position = object.position + rotated({box.x, box.bottom()}, object.rotation);
  plain.size = {box.w, box.h};
}

Vec2 top_left_of(const MapObject& object) {
  return object.position + rotated(corner_of(object), object.rotation);
}

PlacedPicture placed(const MapObject& object) {
  const Vec2 from_anchor = corner_of(object);
  PlacedPicture made = placed(object.picture, from_anchor, object.size);
  made.corner = object.position + rotated(made.corner, object.rotation);
  made.right = rotated(made.right, object.rotation);
  made.down = rotated(made.down, object.rotation);
  return made;
}

Rect bounds_of(const PlacedPicture& shown) {
  const auto least = [](double a, double b) { return std::min(0.0, a) + std::min(0.0, b); };
  const double x = shown.corner.x + least(shown.right.x, shown.down.x);
  const double y = shown.corner.y + least(shown.right.y, shown.down.y);
  return {x, y, std::abs(shown.right.x) + std::abs(shown.down.x),
          std::abs(shown.right.y) + std::abs(shown.down.y)};
}

std::vector<std::size_t> drawn_pictures(const ObjectLayer& layer) {
  std::vector<std::size_t> drawn;
  for (std::size_t i = 0; i < layer.objects.size(); ++i) {
    const MapObject& object = layer.objects[i];
    const bool has_area = object.size.x > 0 && object.size.y > 0;
    if (object.visible && object.picture.picture != nullptr && has_area) drawn.push_back(i);
  }
  if (layer.by_y) {
    std::stable_sort(drawn.begin(), drawn.end(), [&](std::size_t a, std::size_t b) {
      return layer.objects[a].position.y < layer.objects[b].position.y;
    });
  }
  return drawn;
}

std::vector<LayerInOrder> layers_in_order(const Level& level) {
  return layers_in_order(level.layers.count(), level.objects);
}

std::vector<LayerInOrder> layers_in_order(int tile_layers, const std::vector<ObjectLayer>& others) {
  std::vector<int> order(others.size());
  std::iota(order.begin(), order.end(), 0);
  const auto place_of = [&](int layer) { return others[static_cast<std::size_t>(layer)].place; };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return place_of(a) < place_of(b); });
  std::vector<LayerInOrder> all;
  auto next = order.begin();
  for (int tiles = 0; tiles < tile_layers; ++tiles) {
    for (; next != order.end() && place_of(*next) <= tiles; ++next) all.push_back({false, *next});
    all.push_back({true, tiles});
  }
  for (; next != order.end(); ++next) all.push_back({false, *next});
  return all;
}

CellReach reach_of(const LargeTiles& tiles, TileSize size) {
  CellReach reach;
  const auto widen = [](int& cells, double px, int side) {
    cells = std::max(cells, static_cast<int>(std::ceil(px / side)));
  };
  for (const auto& [number, tile] : tiles) {
    for (const TileTurn turn : {TileTurn::none, TileTurn::diagonal}) {
      const Rect box = bounds_of(placed(tile, {0, 0}, size, turn));
      widen(reach.left, -box.x, size.width);
      widen(reach.right, box.right() - size.width, size.width);
      widen(reach.up, -box.y, size.height);
      widen(reach.down, box.bottom() - size.height, size.height);
    }
  }
  return reach;
}

}  // namespace talus
