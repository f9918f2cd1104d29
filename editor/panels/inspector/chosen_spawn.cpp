// Finds the spawn of the chosen body.
#include "chosen_spawn.h"

namespace talus {

int chosen_spawn(const Session& session) {
  const Body* body = session.state().find(session.choices().body);
  if (body == nullptr || body->origin.spawn >= static_cast<int>(session.level().spawns.size())) return -1;
  return body->origin.spawn;
}

const Spawn& spawn_of(const Session& session, int index) {
  return session.level().spawns[static_cast<std::size_t>(index)];
}

}  // namespace talus
