// Tools for the bodies placed by hand.
#include "spawn_tools.h"

#include <cassert>
#include <utility>

#include "level/level_text.h"
#include "level_settings.h"

namespace talus {

Edit add_spawn(const Level& level, Spawn spawn) {
  std::vector<Spawn> spawns = level.spawns;
  spawns.push_back(std::move(spawn));
  return set_spawns(level, std::move(spawns), "Place a body");
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
