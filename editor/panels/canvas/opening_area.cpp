// Looks for a player, for bodies and for ground.
#include "opening_area.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "overlay/visible.h"
#include "tile_drawing.h"

namespace talus {
namespace {

constexpr double kLeastOfScreen = 0.8;  // of a screen's width and height, that are shown at least
constexpr double kNearlyAll = 1.2;      // what is so much larger than a part is shown whole
constexpr double kRoomOfScreen = 0.25;  // of a screen, on each side of a body that a screen goes with
constexpr double kMaxScreens = 2;       // that a view shows of what is spread out

Rect whole_map(const TileMap& map) { return {0, 0, map.px_width(), map.px_height()}; }

// An area of this size about a point, moved onto the map. At most as large as the map.
Rect area_about(Vec2 centre, Vec2 size, const TileMap& map) {
  const Vec2 whole = size_in_pixels(map);
  size = {std::min(size.x, whole.x), std::min(size.y, whole.y)};
  return {std::clamp(centre.x - size.x / 2, 0.0, whole.x - size.x),
          std::clamp(centre.y - size.y / 2, 0.0, whole.y - size.y), size.x, size.y};
}

// With some room around it, and not so small that the place cannot be recognised.
Rect with_room(const Rect& bounds, double room, const TileMap& map) {
  const Vec2 least = size_of_screen(map) * kLeastOfScreen;
  return area_about(bounds.center(),
                    {std::max(bounds.w + 2 * room, least.x), std::max(bounds.h + 2 * room, least.y)}, map);
}

// What is below it is mostly ground, so it stands below the middle, but in the middle third.
Rect area_around_player(const Body& player, const TileMap& map) {
  const Vec2 size = size_of_screen(map);
  return area_about(player.box.center() - Vec2{0, size.y / 8}, size, map);
}

bool is_spread(const Rect& bounds, const TileMap& map) {
  const Vec2 most = size_of_screen(map) * kMaxScreens;
  return bounds.w > most.x || bounds.h > most.y;
}

// The cells of a part of the map in which a layer of ground has a tile, from the first to the last.
std::optional<Rect> tiles_within(const std::vector<LayerCells>& layers, CellSpan part, const TileMap& map) {
  std::optional<Rect> found;
  for (const LayerCells cells : layers) {
    for (int y = part.y0; y < part.y1; ++y) {
      const auto row = cells->tiles().begin() + static_cast<std::ptrdiff_t>(y) * map.width();
      const auto has_tile = [](TileNumber tile) { return tile != 0; };
      const auto first = std::find_if(row + part.x0, row + part.x1, has_tile);
      if (first == row + part.x1) continue;
      const auto last =
          std::find_if(std::reverse_iterator(row + part.x1), std::reverse_iterator(first), has_tile);
      const Rect ends = joined_rect(map.box_of({static_cast<int>(first - row), y}),
                                    map.box_of({static_cast<int>(last.base() - row) - 1, y}));
      found = found ? joined_rect(*found, ends) : ends;
    }
  }
  return found;
}

// By rows of screens.
std::optional<Rect> first_screen_with_tiles(const std::vector<LayerCells>& layers, const TileMap& map) {
  for (int y = 0; y < map.height(); y += kScreenRows) {
    for (int x = 0; x < map.width(); x += kScreenColumns) {
      const CellSpan screen{x, y, std::min(x + kScreenColumns, map.width()),
                            std::min(y + kScreenRows, map.height())};
      if (!tiles_within(layers, screen, map)) continue;
      const Vec2 at = map.corner_of({x, y}), size = size_of_screen(map);
      return area_about(at + size * 0.5, size, map);
    }
  }
  return std::nullopt;
}

Rect area_of_ground(const Level& level) {
  const TileMap& map = level.map;
  const std::vector<LayerCells> layers = ground_layers(level);
  const auto first = first_screen_with_tiles(layers, map);
  if (!first) return area_about({}, size_of_screen(map), map);
  if (is_spread(whole_map(map), map)) return *first;
  return with_room(*tiles_within(layers, {0, 0, map.width(), map.height()}, map), map.tile_size().height,
                   map);
}

// bodies: at least one.
Rect bounds_of(const std::vector<Body>& bodies) {
  Rect bounds = bodies.front().box;
  for (const Body& body : bodies) bounds = joined_rect(bounds, body.box);
  return bounds;
}

// A cart's map has more room than most carts use.
Rect used_part(const Level& level, const State& state) {
  const TileMap& map = level.map;
  if (level.layers.count() != 1 || !level.objects.empty()) return whole_map(map);
  const auto tiles = tiles_within(ground_layers(level), {0, 0, map.width(), map.height()}, map);
  if (state.bodies.empty()) return tiles.value_or(whole_map(map));
  const Rect bodies = bounds_of(state.bodies);
  return tiles ? joined_rect(*tiles, bodies) : bodies;
}

// What of a level without a body that the keys steer is shown first.
OpeningArea area_without_player(const Level& level, const State& state) {
  const TileMap& map = level.map;
  const Rect used = used_part(level, state);
  if (state.bodies.empty()) return {area_of_ground(level), false, used};
  const Rect bounds = bounds_of(state.bodies);
  if (is_spread(bounds, map))
    return {area_about(state.bodies.front().box.center(), size_of_screen(map), map), true, used};
  const Rect area = with_room(bounds, 2.0 * map.tile_size().height, map);
  const bool is_nearly_all = used.w <= kNearlyAll * area.w && used.h <= kNearlyAll * area.h;
  return {is_nearly_all ? used : area, false, used};
}

}  // namespace

Vec2 size_of_screen(const TileMap& map) {
  return {std::min(map.px_width(), map.x_of(kScreenColumns)),
          std::min(map.px_height(), map.y_of(kScreenRows))};
}

const Body* followed_body(const State& state, int chosen) {
  if (const Body* body = state.find(chosen)) return body;
  const auto steered = std::find_if(state.bodies.begin(), state.bodies.end(),
                                    [](const Body& body) { return traits_of(body.kind).takes_keys; });
  return steered != state.bodies.end() ? &*steered : nullptr;
}

Rect screen_with_bodies(const Level& level, const State& state, int chosen) {
  const Vec2 size = size_of_screen(level.map), room = size * kRoomOfScreen;
  Rect seen;
  if (const Body* body = followed_body(state, chosen)) {
    const Rect& b = body->box;
    seen = {b.x - room.x, b.y - room.y, b.w + 2 * room.x, b.h + 2 * room.y};
  } else {
    seen = opening_area(level, state).area;
  }
  // Where the screen begins in one direction.
  const auto begin = [](double from, double length, double screen) {
    return length > screen ? from + (length - screen) / 2 : std::clamp(0.0, from + length - screen, from);
  };
  const Vec2 at{begin(seen.x, seen.w, size.x), begin(seen.y, seen.h, size.y)};
  return area_about(at + size * 0.5, size, level.map);
}

OpeningArea opening_area(const Level& level, const State& state) {
  const TileMap& map = level.map;
  if (const Body* player = followed_body(state, 0))
    return {area_around_player(*player, map), true, whole_map(map)};
  return area_without_player(level, state);
}

}  // namespace talus
