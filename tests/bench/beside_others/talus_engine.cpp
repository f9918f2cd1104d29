// Bodies that meet, with 1, 2 and 4 sub-steps.
#include <talus/level/level.h>
#include <talus/sim/solver.h>
#include "engines.h"

namespace talus::beside {
namespace {

constexpr TileNumber kSolid = 1;

void set_tuning(Tuning& tuning, const World& world, int substeps) {
  tuning.solver = SolverKind::exact;
  tuning.shared.bodies = static_cast<double>(BodyPairs::meet);
  tuning.shared.fall_blend = tuning.shared.drift_blend = 0;
  tuning.shared.floor_bounce = tuning.shared.wall_bounce = world.material.bounce;
  tuning.exact.gravity = world.gravity;
  tuning.exact.rebound = 1;
  tuning.exact.substeps = substeps;
}

BodyKind kind_of(const World& world, const Body& body) {
  if (body.is_round) return world.material == kDisc ? BodyKind::disc : BodyKind::marble;
  return world.material == kCrate ? BodyKind::crate : BodyKind::ball;
}

Level level_of(const World& world, int substeps) {
  Level level;
  set_tuning(level.tuning, world, substeps);
  level.sheet(SheetId::tiles).flags[kSolid] = 1;
  level.map = TileMap(static_cast<int>(world.width / kCell), static_cast<int>(world.height / kCell));
  for (const Rect& wall : world.walls) {
    const Cell first = level.map.cell_at(wall.position());
    const Cell end = level.map.cell_at({wall.right(), wall.bottom()});
    for (Cell c = first; c.y < end.y; ++c.y)
      for (c.x = first.x; c.x < end.x; ++c.x) level.map.set(c, kSolid);
  }
  for (const Incline& incline : world.inclines)
    level.curves.push_back({"", {Segment{incline.from, incline.to}, Curve::Faces::up}, ""});
  for (const HalfCircle& half : world.half_circles) {
    const double left = half.center.x - half.radius, right = half.center.x + half.radius;
    level.curves.push_back(
        {"", {Arc{half.center, half.radius, left, right, half.is_hill}, Curve::Faces::up}, ""});
  }
  for (const Body& body : world.bodies) {
    Spawn spawn;
    spawn.position = body.at.position();
    spawn.size = {body.at.w, body.at.h};
    spawn.velocity = body.velocity;
    spawn.kind = kind_of(world, body);
    spawn.foot = Foot::box;
    level.spawns.push_back(spawn);
  }
  return level;
}

class TalusEngine : public Engine {
 public:
  TalusEngine(const World& world, int substeps)
      : scene_(std::make_shared<const Scene>(compile_scene(level_of(world, substeps)))),
        solver_(make_solver(scene_)),
        state_(initial_state(*scene_)) {}
  void step() override { solver_->step(state_, {}); }
  Rect box(std::size_t index) const override { return state_.bodies[index].box; }
  Vec2 velocity(std::size_t index) const override { return state_.bodies[index].velocity; }
  double spin(std::size_t index) const override { return state_.bodies[index].spin; }

 private:
  std::shared_ptr<const Scene> scene_;
  std::unique_ptr<Solver> solver_;
  State state_;
};

}  // namespace

std::vector<Contestant> talus_engines() {
  std::vector<Contestant> engines;
  for (const int substeps : {1, 2, kBestSubsteps})
    engines.push_back({"Talus " + std::to_string(substeps), [substeps](const World& world) {
                         return std::make_unique<TalusEngine>(world, substeps);
                       }});
  return engines;
}

}  // namespace talus::beside
