// Walks of the exact solver along random floors of lines and curves, each of which begins where the one
// before ends: a player goes on along the whole floor and back, whether it is one-way or stops bodies on both
// sides. Numbers are on no grid. TALUS_WALK_FLOORS: the number of floors, at least kFloors.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <talus/sim/solver.h>
#include "prove/proof.h"
#include "random_ground.h"
#include "tries.h"

namespace talus::curve_walk_property_test {

constexpr double kFloors = 40, kProvedFloors = 3;
constexpr double kLength = 640, kFlat = 64;      // px, of the floor, and of the level part at each end
constexpr double kHighest = 100, kLowest = 250;  // px, y of the floor
constexpr double kSteepest = 0.9;                // |dy/dx|
constexpr double kOff = 0.02;  // px, by which the foot may be off the floor, as ends are rounded

struct Part {
  double x1;
  std::function<double(double)> y_at;
};

class FloorMaker {
 public:
  explicit FloorMaker(Dice& dice) : dice_(dice) {}
  // Fills curves() and parts().
  void make() {
    add_line(kFlat, 0);
    while (x_ < kLength - kFlat - 62) add_random();
    add_line(kLength - kFlat - x_, 0);
    add_line(kFlat, 0);
  }
  const std::vector<Curve>& curves() const { return curves_; }
  double y_at(double x) const {
    const auto part = std::find_if(parts_.begin(), parts_.end(), [x](const Part& p) { return x <= p.x1; });
    return part == parts_.end() ? y_ : part->y_at(x);
  }

 private:
  void add_random() {
    const double length = dice_.in(4, 60), slope = dice_.in(-kSteepest, kSteepest);
    switch (dice_.up_to(4)) {
      case 0:
        return add_line(length, slope);
      case 1:
        return add_arc(length);
      case 2:
        return add_sine(length, slope);
      case 3:
        return add_parabola(length, slope);
      default:
        return add_cubic(length);
    }
  }
  // A part that would leave the range of heights is left out.
  void add(const Curve& curve, double length, std::function<double(double)> y_at) {
    for (int i = 1; i <= 16; ++i) {
      const double y = y_at(x_ + length * i / 16);
      if (y < kHighest || y > kLowest) return;
    }
    curves_.push_back(curve);
    x_ += length;
    y_ = y_at(x_);
    parts_.push_back({x_, std::move(y_at)});
  }
  void add_line(double length, double slope) {
    const double x = x_, y = y_;
    add({Segment{{x, y}, {x + length, y + slope * length}}}, length,
        [=](double at) { return y + slope * (at - x); });
  }
  void add_arc(double length) {
    const bool upper = dice_.one_in(2);
    const double radius = length * dice_.in(0.8, 4), sign = upper ? -1 : 1;
    // Both ends are flat enough.
    const double most = radius * kSteepest / std::sqrt(1 + kSteepest * kSteepest);
    const double from = dice_.in(-most, std::max(-most, most - length)), to = std::min(from + length, most);
    const auto height = [=](double u) { return sign * std::sqrt(radius * radius - u * u); };
    const Vec2 center{x_ - from, y_ - height(from)};
    add({Arc{center, radius, x_, x_ + (to - from), upper}}, to - from,
        [=](double at) { return center.y + height(at - center.x); });
  }
  void add_sine(double length, double slope) {
    const double wave = dice_.in(20, 120), amplitude = slope * wave / (2 * std::numbers::pi);
    const double origin = x_ - dice_.in(0, wave);
    const auto wave_at = [=](double at) {
      return amplitude * std::sin(2 * std::numbers::pi * (at - origin) / wave);
    };
    const double middle = y_ - wave_at(x_);
    add({Sine{x_, x_ + length, middle, amplitude, wave, origin}}, length,
        [=](double at) { return middle + wave_at(at); });
  }
  void add_parabola(double length, double slope) {
    const double x = x_, y = y_, last = dice_.in(-kSteepest, kSteepest);
    const double control = y + slope * length / 2, end = control + last * length / 2;
    add({Parabola{{x, y}, {x + length, end}, control}}, length, [=](double at) {
      const double u = at - x;
      return y + slope * u + (last - slope) / (2 * length) * u * u;
    });
  }
  // In Hermite form, by its slopes at both ends and that of the line between them.
  void add_cubic(double length) {
    const double x = x_, y = y_, rise = dice_.in(-0.3, 0.3) * length;
    const double first = dice_.in(-0.5, 0.5), last = dice_.in(-0.5, 0.5);
    add({Cubic{{x, y}, {x + length, y + rise}, first, last}}, length, [=](double at) {
      const double t = (at - x) / length, a = first * length, b = last * length;
      return y + t * (a + t * (3 * rise - 2 * a - b + t * (a + b - 2 * rise)));
    });
  }

  Dice& dice_;
  double x_ = 0, y_ = 180;
  std::vector<Curve> curves_;
  std::vector<Part> parts_;
};

struct Walker {
  Vec2 size = {8, 8};  // px
  double speed = 1.5;  // px a frame
};
constexpr Walker kWalkers[] = {{},          {{6, 14}, 0.37}, {{16, 8}, 2.3}, {{40, 4}, 1.5}, {{8, 8}, 7.9},
                               {{24, 6}, 3}};

void walk(const Level& level, const FloorMaker& floor, const Walker& walker) {
  const auto scene = std::make_shared<const Scene>(compile_scene(level));
  const auto solver = make_solver(scene);
  State state = initial_state(*scene);
  const Body& body = state.bodies.front();
  const auto middle = [&] { return body.box.x + body.box.w / 2; };
  solver->step(state, {}, nullptr);
  for (const int direction : {1, -1}) {
    Input input;
    input.left = direction < 0;
    input.right = direction > 0;
    for (bool turns = true; direction > 0 ? middle() < kLength - 28 : middle() > 28; turns = false) {
      const double from = middle();
      solver->step(state, input, nullptr);
      ASSERT_TRUE(body.gait.grounded) << "leaves the floor at " << from;
      ASSERT_GE((middle() - from) * direction, turns ? 0 : walker.speed - kOff) << "is slowed at " << from;
      ASSERT_NEAR(body.box.bottom(), floor.y_at(middle()), kOff) << "is off the floor at " << middle();
    }
  }
}

Level level_of(const FloorMaker& floor, const Walker& walker, Dice& dice) {
  Level level;
  level.tuning.solver = SolverKind::exact;
  level.tuning.player.run_speed = level.tuning.player.run_gain = level.tuning.player.run_loss = walker.speed;
  level.tuning.player.surface_speed = 0;
  level.map = TileMap(static_cast<int>(kLength) / 8, 40);
  const bool one_way = dice.one_in(3);
  for (Curve curve : floor.curves()) {
    curve.faces = one_way || dice.one_in(4) ? Curve::Faces::up : Curve::Faces::both;
    level.curves.push_back({"", curve, ""});
  }
  Spawn& player = level.spawns.emplace_back();
  player.kind = BodyKind::player;
  player.foot = Foot::centre;
  player.size = walker.size;
  player.position = {28 - walker.size.x / 2, floor.y_at(28) - walker.size.y};
  return level;
}

TEST(WalkProperty, FloorsOfCurvesAreOneFloor) {
  const auto floors = static_cast<std::uint64_t>(tries("TALUS_WALK_FLOORS", kFloors));
  for (std::uint64_t number = 1; number <= floors && !testing::Test::HasFailure(); ++number) {
    SCOPED_TRACE("floor " + std::to_string(number));
    Dice dice(number);
    FloorMaker floor(dice);
    floor.make();
    const Walker& walker = kWalkers[number % std::size(kWalkers)];
    walk(level_of(floor, walker, dice), floor, walker);
  }
}

TEST(ProveCurves, FloorsOfCurvesHaveNoFindingOfTheSolver) {
  const auto floors = static_cast<std::uint64_t>(tries("TALUS_PROVE_FLOORS", kProvedFloors));
  for (std::uint64_t number = 1; number <= floors; ++number) {
    Dice dice(number);
    FloorMaker floor(dice);
    floor.make();
    const Proof proof =
        *prove(ProveScene(level_of(floor, kWalkers[number % std::size(kWalkers)], dice), {}), 1);
    for (const Finding& finding : proof.findings)
      EXPECT_TRUE(info_of(finding.kind).of_level) << "floor " << number << ": " << message_of(finding);
  }
}

}  // namespace talus::curve_walk_property_test
