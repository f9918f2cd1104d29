// Tools for the bodies placed by hand.
#include "spawn_tools.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "sprite_tools.h"

namespace talus {

Edit add_spawn(const Level& level, Spawn spawn) {
  std::vector<Spawn> spawns = level.spawns;
  spawns.push_back(std::move(spawn));
  return set_spawns(level, std::move(spawns), "Place a body");
}

Edit change_spawn(const Level& level, int index, Spawn spawn, std::string label) {
  assert(index >= 0 && static_cast<std::size_t>(index) < level.spawns.size());
  std::vector<Spawn> spawns = level.spawns;
  spawns[static_cast<std::size_t>(index)] = std::move(spawn);
  return set_spawns(level, std::move(spawns), std::move(label));
}

Edit remove_spawn(const Level& level, int index) {
  assert(index >= 0 && static_cast<std::size_t>(index) < level.spawns.size());
  std::vector<Spawn> spawns = level.spawns;
  spawns.erase(spawns.begin() + index);
  return set_spawns(level, std::move(spawns), "Remove a body");
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

std::optional<int> followed_spawn(const std::vector<Spawn>& before, const std::vector<Spawn>& after,
                                  int index) {
  const auto size = static_cast<std::ptrdiff_t>(before.size());
  const auto grown = static_cast<std::ptrdiff_t>(after.size()) - size;
  const auto first =
      std::mismatch(before.begin(), before.end(), after.begin(), after.end()).first - before.begin();
  const auto same_at_end =
      std::mismatch(before.rbegin(), before.rend(), after.rbegin(), after.rend()).first - before.rbegin();
  const auto last = std::min(same_at_end, std::min(size, size + grown) - first);  // equal ones count once
  if (index < first || grown == 0) return index;
  if (index >= size - last) return static_cast<int>(index + grown);
  return {};
}

}  // namespace talus
