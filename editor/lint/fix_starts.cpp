// Fixes of where bodies start.
#include <algorithm>
#include <cmath>

#include "collision/ground_queries.h"
#include "edit/spawn_tools.h"
#include "fix_parts.h"
#include "level/level_text.h"
#include "level/local_ground.h"

namespace talus {
namespace {

constexpr int kMostUp = 16;    // cells
constexpr int kMostAway = 16;  // cells

std::string position_text(Vec2 at) { return px_text(at.x) + ", " + px_text(at.y) + " px"; }

bool is_on_map(const Level& level, const Rect& box) {
  return box.x >= 0 && box.y >= 0 && box.right() <= level.map.width() * kTileSize &&
         box.bottom() <= level.map.height() * kTileSize;
}

// The nearest place free of the ground and on the map, of those at corners of cells.
std::optional<Vec2> nearest_free_corner(const Level& level, const Rect& box, const LocalGround& ground,
                                        Foot foot) {
  std::optional<Vec2> nearest;
  double least = 0;
  for (int y = -kMostAway; y <= kMostAway; ++y) {
    for (int x = -kMostAway; x <= kMostAway; ++x) {
      const Rect there{(std::floor(box.x / kTileSize) + x) * kTileSize,
                       (std::floor(box.y / kTileSize) + y) * kTileSize, box.w, box.h};
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

// The nearest place straight above in which the body stands, or hangs, free of the ground; else the shortest
// way out of it that stays on the map; else the nearest free one.
std::optional<Vec2> free_place(const Level& level, const Spawn& spawn) {
  const Rect box{spawn.position.x, spawn.position.y, spawn.size.x, spawn.size.y};
  const LocalGround ground = ground_around(level, box, std::max(kMostUp, kMostAway) + 1);
  const Foot foot = spawn.used_foot();
  for (int i = 0; i <= kMostUp; ++i) {
    Rect up = box;
    up.y = (std::floor(box.bottom() / kTileSize) - i) * kTileSize - box.h;
    const Rect local = ground.to_local(up);
    if (up.y >= box.y || !is_on_map(level, up) || overlaps_ground(ground.terrain, local, foot)) continue;
    if (const auto floor = floor_below(ground.terrain, local, box.y - up.y, foot))
      up.y = floor->y - box.h + ground.corner.y;
    return up.position();
  }
  if (const auto out = way_out(ground.terrain, ground.to_local(box), foot)) {
    const Vec2 there = box.position() + *out;
    if (is_on_map(level, {there.x, there.y, box.w, box.h})) return there;
  }
  return nearest_free_corner(level, box, ground, foot);
}

void move_spawn(const Level& level, int index, Vec2 to, std::vector<Edit>& out) {
  Spawn spawn = level.spawns[static_cast<std::size_t>(index)];
  if (spawn.position == to) return;
  const double up = spawn.position.y - to.y;
  const bool straight = spawn.position.x == to.x && up > 0;
  spawn.position = to;
  out.push_back(change_spawn(level, index, spawn,
                             "Move " + spawn_name(level, index) +
                                 (straight ? " up by " + px_text(up) + " px" : "") + " to " +
                                 position_text(to)));
}

void move_inside(const Level& level, int index, std::vector<Edit>& out) {
  const Spawn& spawn = level.spawns[static_cast<std::size_t>(index)];
  const auto inside = [](double at, double size, int cells) {
    return std::max(0.0, std::min(at, cells * kTileSize - size));
  };
  move_spawn(level, index,
             {inside(spawn.position.x, spawn.size.x, level.map.width()),
              inside(spawn.position.y, spawn.size.y, level.map.height())},
             out);
}

// Moves a ball tile up to the next empty cell that is in no slope.
void move_ball(const Level& level, const LintTiles& tiles, Cell cell, std::vector<Edit>& out) {
  for (Cell up{cell.x, cell.y - 1}; level.map.contains(up) && up.y >= cell.y - kMostUp; --up.y) {
    if (!tiles.is_empty(level.map.at(up))) continue;
    // Where it covers a slope's right half, that comes in its place.
    const Cell left{cell.x - 1, cell.y};
    const auto half = static_cast<std::uint8_t>(level.map.contains(left) ? level.map.at(left) + 1 : 0);
    const bool is_half = half != 0 && tiles[half].half_of == half - 1;
    Edit edit = put_tile(level, cell, is_half ? half : 0,
                         "Move the ball of " + cell_text(cell) + " up to " + cell_text(up) +
                             (is_half ? ", and put tile " + std::to_string(half) + " in its place" : ""));
    edit.changes.push_back(CellChange{up, level.map.at(up), level.map.at(cell)});
    out.push_back(std::move(edit));
    return;
  }
}

}  // namespace

void fix_start(const Level& level, const LintTiles& tiles, const Problem& problem, std::vector<Edit>& out) {
  if (problem.object < 0) return move_ball(level, tiles, *problem.cell, out);
  if (problem.code == "spawn-outside") return move_inside(level, problem.object, out);
  const Spawn& spawn = level.spawns[static_cast<std::size_t>(problem.object)];
  if (const auto place = free_place(level, spawn)) move_spawn(level, problem.object, *place, out);
}

}  // namespace talus
