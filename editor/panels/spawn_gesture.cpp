// Placing and moving bodies.
#include "spawn_gesture.h"

#include <cmath>

#include "edit/spawn_tools.h"

namespace talus {
namespace {

// Another one like the chosen body; a player when none is chosen.
Spawn next_spawn(const Session& session, Vec2 at) {
  Spawn spawn;
  spawn.kind = BodyKind::player;
  if (const int like = chosen_spawn(session); like >= 0) {
    const Spawn& chosen = session.level().spawns[static_cast<std::size_t>(like)];
    spawn.kind = chosen.kind;
    spawn.foot = chosen.foot;
    spawn.size = chosen.size;
  }
  spawn.position = {std::floor(at.x / kTileSize) * kTileSize, std::floor(at.y / kTileSize) * kTileSize};
  return spawn;
}

bool is_on(const TileMap& map, Vec2 at) {
  return map.contains(
      {static_cast<int>(std::floor(at.x / kTileSize)), static_cast<int>(std::floor(at.y / kTileSize))});
}

}  // namespace

int chosen_spawn(const Session& session) {
  const Body* body = session.state().find(session.choices().body);
  if (body == nullptr || body->origin.spawn >= static_cast<int>(session.level().spawns.size())) return -1;
  return body->origin.spawn;
}

void SpawnGesture::update(const Session& session, Actions& actions, Vec2 at, bool pressed, bool down) {
  const Level& level = session.level();
  if (pressed && is_on(level.map, at)) {
    moved_ = spawn_at(level, at);
    stroke_ = session.next_stroke();
    if (moved_ >= 0) {
      grip_ = at - level.spawns[static_cast<std::size_t>(moved_)].position;
      actions.push_back(action::SelectSpawn{moved_});
    } else {
      const Spawn spawn = next_spawn(session, at);
      moved_ = static_cast<int>(level.spawns.size());
      grip_ = at - spawn.position;
      actions.push_back(action::EditLevel{add_spawn(level, spawn), stroke_});
      actions.push_back(action::SelectSpawn{moved_});
      return;
    }
  }
  if (!down || moved_ >= static_cast<int>(level.spawns.size())) moved_ = -1;  // Undo may have taken it away
  if (moved_ < 0 || !is_on(level.map, at)) return;
  Spawn spawn = level.spawns[static_cast<std::size_t>(moved_)];
  const Vec2 to{std::round(at.x - grip_.x), std::round(at.y - grip_.y)};
  // A hand that does not move leaves a place between pixels as it is.
  if (std::abs(to.x - spawn.position.x) < 1 && std::abs(to.y - spawn.position.y) < 1) return;
  spawn.position = to;
  actions.push_back(action::EditLevel{change_spawn(level, moved_, spawn, "Move a body"), stroke_});
}

}  // namespace talus
