#include "lone_body.h"

#include <vector>

namespace talus {

Scene scene_for(const LoneBody& body, Scene scene) {
  std::erase_if(scene.items, [](const SceneItem& item) { return item.role == TileRole::ball; });
  const Spawn& spawn = body.spawn;
  scene.items.push_back({.role = TileRole::ball,
                         .box = {spawn.position.x, spawn.position.y, spawn.size.x, spawn.size.y},
                         .cell = {},
                         .velocity = spawn.velocity,
                         .spawn = kLoneSpawn,
                         .kind = spawn.kind,
                         .foot = spawn.used_foot()});
  const bool takes_keys = traits_of(spawn.kind).takes_keys;
  const bool meets =
      scene.tuning.solver == SolverKind::exact && scene.tuning.shared.pairs() == BodyPairs::meet;
  scene.features = {.pairs = false, .meets = meets && !takes_keys, .players = takes_keys};
  scene.tuning.player.run_speed = body.run_speed;
  return scene;
}

State start_state(const Scene& scene, const LoneBody* alone) {
  State state = initial_state(scene);
  if (alone != nullptr) state.bodies.front().gait.grounded = alone->stands;
  return state;
}

}  // namespace talus
