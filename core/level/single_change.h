// An edit of one place of a level.
#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <vector>

#include "edit.h"

namespace talus {

// Returns an edit with this change, or an empty one if the place holds the new value already.
template <class MadeChange>
Edit single_change(std::string label, MadeChange change) {
  Edit edit{std::move(label), {}};
  if (!(change.before == change.after)) edit.changes.emplace_back(std::move(change));
  return edit;
}

// The same for one body. index: of Level::spawns (asserted).
inline Edit change_spawn(const Level& level, int index, Spawn spawn, std::string label) {
  assert(index >= 0 && static_cast<std::size_t>(index) < level.spawns.size());
  std::vector<Spawn> spawns = level.spawns;
  spawns[static_cast<std::size_t>(index)] = std::move(spawn);
  return single_change(std::move(label), SpawnsChange{level.spawns, std::move(spawns)});
}

}  // namespace talus
