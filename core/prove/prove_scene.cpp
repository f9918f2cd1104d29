#include "prove_scene.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include <talus/level/ground.h>
#include "level/ground_cells.h"
#include "level/object_ground.h"

namespace talus {
namespace {

constexpr std::array<double, 2> kShares = {1, 0.37};  // of the fastest speed
constexpr double kLeastSpeed = 1;                     // px/frame, of bodies that start at rest

RawGround ground_of_any(const Level& level) {
  if (has_object_ground(level)) return ground_of_any(with_object_tiles(level));
  return RawGround(ground_of(level, ground_cells(level)));
}

bool is_same_kind(const ProveBody& a, const ProveBody& b) {
  return a.kind == b.kind && a.size == b.size && a.foot == b.foot;
}

void add_body(std::vector<ProveBody>& bodies, const ProveBody& body) {
  const auto known = std::find_if(bodies.begin(), bodies.end(),
                                  [&](const ProveBody& other) { return is_same_kind(body, other); });
  if (known == bodies.end()) {
    bodies.push_back(body);
  } else {
    known->speed = std::max(known->speed, body.speed);
  }
}

std::vector<ProveBody> bodies_of(const Scene& scene, TileSize tile) {
  std::vector<ProveBody> bodies;
  const double drift = std::max(kLeastSpeed, std::abs(scene.tuning.shared.drift_speed));
  for (const SceneItem& item : scene.items) {
    if (item.role != TileRole::ball) continue;
    const double speed = std::max(drift, std::abs(item.velocity.x));
    add_body(bodies, {item.kind, {item.box.w, item.box.h}, item.foot, speed});
  }
  if (bodies.empty())
    bodies.push_back(
        {BodyKind::player, new_body_size(BodyKind::player, tile), traits_of(BodyKind::player).foot});
  return bodies;
}

}  // namespace

ProveScene::ProveScene(const Level& level, const ProveOptions& options) : ground_(ground_of_any(level)) {
  assert(!ground_problem(level));
  Scene scene = compile_scene(level);
  scene.features.pairs = false;
  bodies_ = options.bodies.empty() ? bodies_of(scene, level.map.tile_size()) : options.bodies;
  if (bodies_.size() > kMostBodies) {
    left_out_ = bodies_.size() - kMostBodies;
    bodies_.resize(kMostBodies);
  }
  std::erase_if(scene.items, [](const SceneItem& item) { return item.role == TileRole::ball; });
  // The solvers on World know bodies by what they start from: that of every trial is the first spawn.
  scene.items.push_back({.role = TileRole::ball,
                         .box = {0, 0, bodies_[0].size.x, bodies_[0].size.y},
                         .cell = {},
                         .velocity = {},
                         .spawn = 0});
  const double lip = options.lip > 0 ? options.lip : level.map.tile_size().height / 4.0;
  for (const double share : kShares) {
    auto slower = std::make_shared<Scene>(scene);
    slower->tuning.player.run_speed *= share;
    auto judge = std::make_unique<const Judge>(ground_, slower->tuning, lip);
    speeds_.push_back({share, std::move(slower), std::move(judge)});
  }
}

}  // namespace talus
