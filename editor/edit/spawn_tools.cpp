// Tools for the bodies placed by hand.
#include "spawn_tools.h"

#include <cassert>
#include <utility>

#include "collision/ground_queries.h"
#include "level/level_text.h"
#include "level_settings.h"

namespace talus {
namespace {

constexpr int kMaxPlaces = 4096;  // that are tried for a new player

}  // namespace

Edit add_spawn(const Level& level, Spawn spawn) {
  std::vector<Spawn> spawns = level.spawns;
  spawns.push_back(std::move(spawn));
  return set_spawns(level, std::move(spawns), "Place a body");
}

Spawn player_near(const Level& level, const Terrain* ground, Vec2 place) {
  Spawn spawn;
  spawn.kind = BodyKind::player;
  spawn.size = new_body_size(spawn.kind, level.map.tile_size());
  const Cell from = level.map.cell_at(place);
  spawn.position = level.map.corner_of(from);
  if (ground == nullptr) return spawn;
  int places = 0;
  for (int i = 0; i < 2 * level.map.width(); ++i) {
    const int column = from.x + (i % 2 == 0 ? i / 2 : -(i + 1) / 2);
    // From inside of the ground it goes up to the first free place.
    for (int row = from.y; level.map.contains({column, row}) && ++places <= kMaxPlaces; --row) {
      const Vec2 corner = level.map.corner_of({column, row});
      const Rect box{corner.x, corner.y, spawn.size.x, spawn.size.y};
      if (overlaps_ground(*ground, box, spawn.used_foot())) continue;
      CastBudget budget{kMaxQueryWork};
      const auto floor =
          floor_below(*ground, box, level.map.px_height() - box.bottom(), spawn.used_foot(), &budget);
      if (!floor) break;
      spawn.position = {box.x, floor->y - box.h};
      return spawn;
    }
  }
  return spawn;
}

Edit remove_spawn(const Level& level, int index) {
  assert(index >= 0 && static_cast<std::size_t>(index) < level.spawns.size());
  std::vector<Spawn> spawns = level.spawns;
  spawns.erase(spawns.begin() + index);
  return set_spawns(level, std::move(spawns), "Remove a body");
}

Edit duplicate_spawn(const Level& level, int index) {
  assert(index >= 0 && static_cast<std::size_t>(index) < level.spawns.size());
  Spawn copy = level.spawns[static_cast<std::size_t>(index)];
  const int tile = level.map.tile_size().width;
  const bool fits = copy.position.x + copy.size.x + tile <= level.map.px_width();
  copy.position.x += fits ? tile : -tile;
  Edit edit = add_spawn(level, std::move(copy));
  edit.label = "Duplicate a body";
  return edit;
}

std::string title_of_spawn(const Level& level, int index) {
  assert(index >= 0 && static_cast<std::size_t>(index) < level.spawns.size());
  const std::string& name = level.spawns[static_cast<std::size_t>(index)].name;
  return name.empty() ? kind_and_number(level, index) : name;
}

int spawn_at(const Level& level, Vec2 point) {
  int found = -1;
  for (std::size_t i = 0; i < level.spawns.size(); ++i) {
    const Vec2 corner = level.spawns[i].position, size = level.spawns[i].size;
    if (point.x >= corner.x && point.x < corner.x + size.x && point.y >= corner.y &&
        point.y < corner.y + size.y)
      found = static_cast<int>(i);
  }
  return found;
}

}  // namespace talus
