// Prints a hash of the states of many random levels in all three solvers, and of bodies that meet. Built with
// several compilers, flags and processors by ./run, it must always print the same.

#include <cinttypes>
#include <cstdio>

#include <talus/level/level.h>
#include <talus/sim/solver.h>

namespace talus {
namespace {

// A linear congruential generator (Knuth's MMIX constants): the same numbers everywhere.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) { up_to(1); }
  int up_to(int last) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<int>((state_ >> 33) % (static_cast<std::uint64_t>(last) + 1));
  }
  double in(double lo, double hi) { return lo + (hi - lo) * (up_to(1'000'000) / 1'000'000.0); }

 private:
  std::uint64_t state_;
};

TileShape random_shape(Dice& dice) {
  TileShape shape;
  shape.kind = dice.up_to(3) == 0 ? TileShape::Kind::profile : TileShape::Kind::slope;
  shape.side = dice.up_to(2) == 0 ? TileShape::Side::ceiling : TileShape::Side::floor;
  shape.one_way = dice.up_to(3) == 0;
  shape.tiles = 1 + dice.up_to(3);
  const int heights = shape.kind == TileShape::Kind::slope ? 2 : 3 + dice.up_to(5);
  for (int i = 0; i < heights; ++i) shape.heights.push_back(dice.in(0, 12));
  return shape;
}

Curve random_curve(Dice& dice, double width, double height) {
  const double x = dice.in(16, width - 80), y = dice.in(32, height - 32);
  switch (dice.up_to(5)) {
    case 0:
      return {Segment{{x, y}, {x + dice.in(8, 60), y + dice.in(-20, 20)}}, Curve::Faces::both};
    case 1:
      return {Arc{{x + 32, y}, 32, x, x + 64, dice.up_to(1) == 0}, Curve::Faces::up};
    case 2:
      return {Parabola{{x, y}, {x + 60, y + 8}, y - dice.in(-30, 30)}, Curve::Faces::up};
    case 3:
      return {Cubic{{x, y}, {x + 60, y + 8}, dice.in(-2, 2), dice.in(-2, 2)}, Curve::Faces::both};
    case 4:
      return {Sine{x, x + 70, y, dice.in(2, 12), dice.in(16, 64), x}, Curve::Faces::up};
    default:
      return {Polyline{x, x + 60, {y, y - 9, y + 4, y - 2.5, y}}, Curve::Faces::up};
  }
}

Level random_level(std::uint64_t seed) {
  Dice dice(seed);
  Level level;
  level.map = TileMap(30, 17);
  auto& flags = level.sheet(SheetId::tiles).flags;
  flags[1] = 1;
  flags[2] = 4;
  flags[3] = 8;
  for (int tile = 4; tile < 10; ++tile) level.tile_shapes[tile] = random_shape(dice);
  for (Cell c{0, 0}; c.y < 17; ++c.y) {
    for (c.x = 0; c.x < 30; ++c.x) {
      const bool border = c.x == 0 || c.x == 29 || c.y == 16;
      if (border || dice.up_to(5) == 0)
        level.map.set(c, border ? 1 : static_cast<TileNumber>(1 + dice.up_to(8)));
    }
  }
  for (int i = 0; i < 3; ++i) level.curves.push_back({"", random_curve(dice, 240, 136), ""});
  for (int i = 0; i < 12; ++i) {
    Spawn spawn;
    spawn.position = {dice.in(10, 220), dice.in(-40, 100)};
    spawn.velocity = {dice.in(-6, 6), dice.in(-6, 6)};
    spawn.kind = i % 4 == 3 ? BodyKind::player : BodyKind::ball;
    level.spawns.push_back(spawn);
  }
  level.tuning.exact.rebound = dice.up_to(1);
  level.tuning.exact.gravity = dice.up_to(1) == 0 ? 0 : 0.25;
  level.tuning.player.surface_speed = dice.up_to(1);
  return level;
}

std::uint64_t hash_of_run(Level level, SolverKind solver, bool single, BodyPairs pairs, std::uint64_t seed) {
  level.tuning.solver = solver;
  level.tuning.shared.bodies = static_cast<double>(pairs);
  level.tuning.exact.single_precision = single ? 1 : 0;
  const auto scene = std::make_shared<const Scene>(compile_scene(level));
  const auto stepper = make_solver(scene);
  State state = initial_state(*scene);
  Dice dice(seed);
  Input input;
  std::uint64_t hash = 0;
  for (int frame = 0; frame < 300; ++frame) {
    if (frame % 10 == 0) {
      input.left = dice.up_to(1) == 0;
      input.right = !input.left;
      input.jump = dice.up_to(1) == 0;
    }
    stepper->step(state, input);
    hash = hash * 31 + state_hash(state);
  }
  return hash;
}

}  // namespace
}  // namespace talus

int main() {
  using namespace talus;
  const struct {
    const char* name;
    SolverKind solver;
    bool single;
    BodyPairs pairs = BodyPairs::block;
  } solvers[] = {{"article", SolverKind::article, false},
                 {"bump", SolverKind::bump, false},
                 {"exact", SolverKind::exact, false},
                 {"exact-float", SolverKind::exact, true},
                 {"meet", SolverKind::exact, false, BodyPairs::meet}};
  for (const auto& s : solvers) {
    std::uint64_t hash = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      hash = hash * 1'000'003 + hash_of_run(random_level(seed), s.solver, s.single, s.pairs, seed);
    }
    std::printf("%s %016" PRIx64 "\n", s.name, hash);
  }
}
