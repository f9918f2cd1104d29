#include "body_place.h"

#include <algorithm>

#include "collision/ground_queries.h"
#include "local_ground.h"

namespace talus {
namespace {

constexpr int kMostAway = 16;  // cells

Rect box_of(const Spawn& spawn) { return {spawn.position.x, spawn.position.y, spawn.size.x, spawn.size.y}; }

bool is_on_map(const Level& level, const Rect& box) {
  return box.x >= 0 && box.y >= 0 && box.right() <= level.map.px_width() &&
         box.bottom() <= level.map.px_height();
}

// Returns the nearest place on the map that is free of the ground, among the corners of cells.
std::optional<Vec2> nearest_free_corner(const Level& level, const Rect& box, const LocalGround& ground,
                                        Foot foot) {
  std::optional<Vec2> nearest;
  double least = 0;
  const Cell home = level.map.cell_at(box.position());
  for (int y = -kMostAway; y <= kMostAway; ++y) {
    for (int x = -kMostAway; x <= kMostAway; ++x) {
      const Vec2 corner = level.map.corner_of({home.x + x, home.y + y});
      const Rect there{corner.x, corner.y, box.w, box.h};
      const Vec2 way = there.position() - box.position();
      const double squared = way.x * way.x + way.y * way.y;
      if ((nearest && squared >= least) || !is_on_map(level, there)) continue;
      if (overlaps_ground(ground.terrain, ground.to_local(there), foot)) continue;
      nearest = there.position();
      least = squared;
    }
  }
  return nearest;
}

}  // namespace

bool starts_in_ground(const Level& level, const Spawn& spawn) {
  const LocalGround ground = ground_around(level, box_of(spawn), 0);
  return overlaps_ground(ground.terrain, ground.to_local(box_of(spawn)), spawn.used_foot());
}

std::optional<Vec2> free_place(const Level& level, const Spawn& spawn) {
  const Rect box = box_of(spawn);
  const LocalGround ground = ground_around(level, box, std::max(kMostCellsUp, kMostAway) + 1);
  const Foot foot = spawn.used_foot();
  if (const auto y = free_above(ground.terrain, ground.to_local(box), foot)) {
    const Vec2 up{box.x, *y + ground.corner.y};
    if (is_on_map(level, {up.x, up.y, box.w, box.h})) return up;
  }
  if (const auto out = way_out(ground.terrain, ground.to_local(box), foot)) {
    const Vec2 there = box.position() + *out;
    if (is_on_map(level, {there.x, there.y, box.w, box.h})) return there;
  }
  return nearest_free_corner(level, box, ground, foot);
}

}  // namespace talus
