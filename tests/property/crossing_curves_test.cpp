// Random curves that cross, touch and begin above one another, some of them shifted copies of others: the
// solver exact takes a player over them as their geometry says. TALUS_CROSSING_LEVELS: the number of levels,
// at least kLevels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "prove/proof.h"
#include "random_ground.h"
#include "tries.h"

namespace talus::crossing_curves_test {

constexpr double kLevels = 6;
constexpr int kWidth = 26, kHeight = 16;  // cells
constexpr Vec2 kSizes[] = {{8, 8}, {6, 16}, {12, 20}, {8, 6}, {16, 8}, {5, 11}};

Arc any_arc(Dice& dice, double middle, double y, double half) {
  const double radius = dice.in(6, 80), reach = std::min(half, radius * 0.7);
  const bool upper = dice.one_in(2);
  return {
      {middle, upper ? y + radius : y - radius}, radius, weld(middle - reach), weld(middle + reach), upper};
}

Curve any_curve(Dice& dice) {
  Curve curve;
  curve.faces = dice.one_in(3) ? Curve::Faces::both : Curve::Faces::up;
  const double x0 = weld(dice.in(8, 148)), x1 = weld(std::min(204.0, x0 + dice.in(16, 140)));
  const double y = dice.one_in(3) ? dice.step(40, 104, 1.0 / 8) : dice.in(40, 104);
  switch (dice.up_to(4)) {
    case 0:
      curve.form = Segment{weld({x0, y}), weld({x1, y + dice.in(-0.9, 0.9) * std::min(40.0, x1 - x0)})};
      break;
    case 1:
      curve.form = any_arc(dice, (x0 + x1) / 2, y, (x1 - x0) / 2);
      break;
    case 2:
      curve.form = Parabola{weld({x0, y}), weld({x1, y + dice.in(-20, 20)}), weld(y + dice.in(-30, 30))};
      break;
    case 3:
      curve.form =
          Cubic{weld({x0, y}), weld({x1, y + dice.in(-20, 20)}), dice.in(-0.8, 0.8), dice.in(-0.8, 0.8)};
      break;
    default: {
      const double wave = dice.in(8, 80);
      curve.form = Sine{x0, x1, y, dice.in(-0.14, 0.14) * wave, wave, x0 - dice.in(0, wave)};
    }
  }
  return curve;
}

// A copy that is a little higher or lower, or that crosses the original.
struct Shift {
  double by;  // px
  void operator()(Arc& arc) const { arc.center.y += by; }
  void operator()(Sine& sine) const { sine.middle += by; }
  void operator()(Polyline&) const {}
  template <class Form>
  void operator()(Form& form) const {
    form.from.y = weld(form.from.y + by);
    form.to.y = weld(form.to.y - by);
  }
};

Level random_level(Dice& dice) {
  Level level;
  level.tuning.solver = SolverKind::exact;
  PlayerTuning& player = level.tuning.player;
  player.run_speed = player.run_gain = player.run_loss = dice.step(0.3, dice.one_in(2) ? 4 : 12, 64);
  level.map = TileMap(kWidth, kHeight);
  level.sheet(SheetId::tiles).flags[1] = 1;
  for (int i = 2 + dice.up_to(4); i > 0; --i) {
    Curve curve = any_curve(dice);
    if (!level.curves.empty() && dice.one_in(4)) {
      curve =
          level.curves[static_cast<std::size_t>(dice.up_to(static_cast<int>(level.curves.size()) - 1))].curve;
      std::visit(Shift{dice.one_in(2) ? dice.in(-3, 3) : dice.in(-0.3, 0.3)}, curve.form);
    }
    if (!problem_of(curve, level.map)) level.curves.push_back({"", curve, ""});
  }
  for (int x = 0; x < kWidth && dice.up_to(kWidth) > 0; ++x) level.map.set({x, kHeight - 1}, 1);
  return level;
}

TEST(ProveCurves, CurvesThatCrossHaveNoFindingOfTheSolver) {
  const auto levels = static_cast<std::uint64_t>(tries("TALUS_CROSSING_LEVELS", kLevels));
  for (std::uint64_t number = 1; number <= levels; ++number) {
    Dice dice(number);
    const Level level = random_level(dice);
    const ProveBody body{.size = kSizes[dice.up_to(5)], .foot = dice.one_in(2) ? Foot::box : Foot::centre};
    const Proof proof = *prove(ProveScene(level, {.bodies = {body}}), 1);
    for (const Finding& finding : proof.findings)
      EXPECT_TRUE(info_of(finding.kind).of_level) << "level " << number << ": " << message_of(finding);
  }
}

}  // namespace talus::crossing_curves_test
