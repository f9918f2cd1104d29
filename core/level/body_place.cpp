#include "body_place.h"

#include <algorithm>

#include "collision/ground_queries.h"
#include "local_ground.h"

namespace talus {
namespace {

constexpr int kMaxAway = 16;  // cells

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
  for (int y = -kMaxAway; y <= kMaxAway; ++y) {
    for (int x = -kMaxAway; x <= kMaxAway; ++x) {
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

// box: in the level.
bool is_in_ground(const Level& level, const LocalGround& ground, const Rect& box, Foot foot) {
  const Rect here = ground.to_local(box);
  if (overlaps_ground(ground.terrain, here, foot)) return true;
  if (!overlaps_ground(ground.terrain, here)) return false;
  // The corners of a body on its centre may be in the ground beside a slope on which its middle stands.
  const Rect middle{here.x + here.w / 2, here.y, 0, here.h};
  return !floor_below(ground.terrain, middle, here.w / 2 * level.tuning.exact.steepest + 1);
}

}  // namespace

bool starts_in_ground(const Level& level, const Spawn& spawn) {
  return is_in_ground(level, ground_around(level, box_of(spawn), kMaxShapeTiles), box_of(spawn),
                      spawn.used_foot());
}

std::optional<Vec2> free_place(const Level& level, const Spawn& spawn) {
  const Rect box = box_of(spawn);
  const LocalGround ground = ground_around(level, box, std::max(kMaxCellsUp, kMaxAway) + 1);
  const Foot foot = spawn.used_foot();
  for (const Foot above : {foot, Foot::box}) {
    const auto y = free_above(ground.terrain, ground.to_local(box), above);
    const Rect up{box.x, y.value_or(0) + ground.corner.y, box.w, box.h};
    if (y && is_on_map(level, up) && !is_in_ground(level, ground, up, foot)) return up.position();
  }
  if (const auto out = way_out(ground.terrain, ground.to_local(box), foot)) {
    const Vec2 there = box.position() + *out;
    if (is_on_map(level, {there.x, there.y, box.w, box.h})) return there;
  }
  return nearest_free_corner(level, box, ground, foot);
}

}  // namespace talus
