// Random boxes that meet in a closed room without gravity, against an event-driven world in rational numbers.
// TALUS_BOX_WORLDS: the number of worlds, at least kWorlds.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <talus/sim/solver.h>
#include "random_ground.h"
#include "reference/closed_forms.h"
#include "reference/exact_boxes.h"
#include "tries.h"
#include "unit/meeting_run.h"

namespace talus::exact_boxes_test {

using reference::Exact;
using reference::ExactBoxes;

constexpr double kWorlds = 12;
constexpr int kFrames = 300;
constexpr int kTile = 8;  // px
// px and px/frame. The core may err by what a rounding at the start would grow to. Where the bounce is less
// than 1, bodies that touch reflect one another ever more weakly; the core ends that at 1e-11 px/frame.
constexpr double kLeast = 1e-9, kMax = 1e-4, kRounding = 1e-12, kReflection = 1e-11;

// ---- Worlds ----

struct World {
  Level level;
  std::vector<Rect> blocks;  // px, of the ground
};

bool overlaps(const Rect& a, const Rect& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

void add_block(World& world, int x, int y, int w, int h) {
  world.blocks.push_back({1.0 * x * kTile, 1.0 * y * kTile, 1.0 * w * kTile, 1.0 * h * kTile});
  for (int i = 0; i < w; ++i)
    for (int k = 0; k < h; ++k) world.level.map.set({x + i, y + k}, 1);
}

// Walls around a room, and a few blocks in it.
void add_ground(Dice& dice, World& world) {
  const int w = 7 + dice.up_to(17), h = 6 + dice.up_to(14);  // cells
  world.level.sheet(SheetId::tiles).flags[1] = 1;
  world.level.sheet(SheetId::tiles).images[1].fill(12);
  world.level.map = TileMap(w, h);
  add_block(world, 0, 0, w, 1);
  add_block(world, 0, h - 1, w, 1);
  add_block(world, 0, 0, 1, h);
  add_block(world, w - 1, 0, 1, h);
  for (int i = dice.up_to(4); i > 0; --i) {
    const int wide = 1 + dice.up_to(2), high = 1 + dice.up_to(1);
    add_block(world, 1 + dice.up_to(w - 2 - wide), 1 + dice.up_to(h - 2 - high), wide, high);
  }
}

// On a grid many contacts are at one time, and boxes touch from the start. There most go along one axis, as
// corners that meet exactly end the comparison.
Vec2 any_velocity(Dice& dice, bool on_grid) {
  if (dice.one_in(on_grid ? 2 : 4)) return {};
  if (!on_grid) return {dice.in(-3, 3), dice.in(-3, 3)};
  const double along = dice.step(-2, 2, 2), across = dice.one_in(8) ? dice.step(-2, 2, 2) : 0;
  return dice.one_in(3) ? Vec2{across, along} : Vec2{along, across};
}

Spawn any_body(Dice& dice, const World& world, bool on_grid) {
  const double right = (world.level.map.width() - 1) * kTile, bottom = (world.level.map.height() - 1) * kTile;
  Spawn body;
  if (on_grid) {
    const auto side = [&] { return 4.0 * (1 + dice.up_to(dice.one_in(6) ? 9 : 2)); };
    body.size = {side(), side()};
    body.position = {dice.step(kTile, right, 0.25), dice.step(kTile, bottom, 0.25)};
    if (!world.level.spawns.empty() && dice.one_in(2)) {
      const Spawn& last = world.level.spawns.back();
      body.position = last.position;
      (dice.one_in(2) ? body.position.x += last.size.x : body.position.y += last.size.y);
    }
  } else {
    body.size = {dice.in(1, 14), dice.in(1, 14)};
    body.position = {dice.in(kTile, right), dice.in(kTile, bottom)};
  }
  body.velocity = any_velocity(dice, on_grid);
  return body;
}

void add_bodies(Dice& dice, World& world, bool on_grid) {
  const int count = 2 + dice.up_to(28);
  std::vector<Rect> taken = world.blocks;
  for (int tries = 0; tries < 20 * count && static_cast<int>(world.level.spawns.size()) < count; ++tries) {
    const Spawn body = any_body(dice, world, on_grid);
    const Rect box{body.position.x, body.position.y, body.size.x, body.size.y};
    const double room = on_grid ? 0 : 0.01;
    const Rect wide{box.x - room, box.y - room, box.w + 2 * room, box.h + 2 * room};
    if (std::any_of(taken.begin(), taken.end(), [&](const Rect& r) { return overlaps(wide, r); })) continue;
    taken.push_back(box);
    world.level.spawns.push_back(body);
  }
}

World any_world(Dice& dice, bool on_grid) {
  World world;
  Tuning& t = world.level.tuning;
  let_bodies_meet(t, 0);
  t.shared.floor_bounce = dice.one_in(3) ? dice.step(0, 1, 8) : 1;
  t.shared.wall_bounce = dice.one_in(3) ? dice.step(0, 1, 8) : 1;
  add_ground(dice, world);
  add_bodies(dice, world, on_grid);
  return world;
}

// ---- The reference ----

ExactBoxes exact_world(const World& world, const State& state) {
  ExactBoxes exact;
  exact.bounce = {Exact(world.level.tuning.shared.wall_bounce),
                  Exact(world.level.tuning.shared.floor_bounce)};
  for (const Body& body : state.bodies) {
    const Rect& box = body.box;
    exact.boxes.push_back({.size = {box.w, box.h},
                           .place = {box.x, box.y},
                           .velocity = {body.velocity.x, body.velocity.y},
                           .inverse_mass = 1 / (Exact(box.w) * box.h)});
  }
  for (const Rect& block : world.blocks)
    exact.boxes.push_back({.size = {block.w, block.h}, .place = {block.x, block.y}});
  return exact;
}

constexpr double kShift = 0x1p-100;  // px, and px/frame

ExactBoxes shifted(const ExactBoxes& exact, Dice& dice) {
  ExactBoxes other = exact;
  for (ExactBoxes::Box& box : other.boxes) {
    if (box.inverse_mass == 0) continue;
    for (const int axis : {0, 1}) {
      box.place[axis] += kShift * dice.in(-1, 1);
      box.velocity[axis] += kShift * dice.in(-1, 1);
    }
  }
  return other;
}

// How far two worlds have gone apart, for each unit of the shift.
double growth(const ExactBoxes& a, const ExactBoxes& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.boxes.size(); ++i) {
    for (const int axis : {0, 1}) {
      const ExactBoxes::Box &one = a.boxes[i], &other = b.boxes[i];
      most = std::max(most, std::abs(Exact(one.place[axis] - other.place[axis]).get_d()));
      most = std::max(most, std::abs(Exact(one.velocity[axis] - other.velocity[axis]).get_d()));
    }
  }
  return most / kShift;
}

// ---- The comparison ----

struct Errors {
  double place = 0, velocity = 0;
};

Errors errors(const State& state, const ExactBoxes& exact) {
  Errors most;
  for (std::size_t i = 0; i < state.bodies.size(); ++i) {
    const Body& body = state.bodies[i];
    const double place[] = {body.box.x, body.box.y}, velocity[] = {body.velocity.x, body.velocity.y};
    for (const int axis : {0, 1}) {
      const ExactBoxes::Box& box = exact.boxes[i];
      most.place = std::max(most.place, std::abs(Exact(box.place[axis] - place[axis]).get_d()));
      most.velocity = std::max(most.velocity, std::abs(Exact(box.velocity[axis] - velocity[axis]).get_d()));
    }
  }
  return most;
}

// What was compared.
struct Tally {
  int frames = 0;
  std::size_t impacts = 0, largest_set = 0;
  std::array<int, 6> ends = {};  // worlds, by ExactBoxes::Result; the last: so chaotic that nothing is known
  double error = 0;              // px, the largest
  double share = 0;              // of what is allowed, the largest
};

// Returns how the comparison ended, as the index in Tally::ends.
std::size_t compare(const World& world, Dice& dice, Tally& tally) {
  constexpr std::size_t kChaotic = 5;
  const auto scene = std::make_shared<const Scene>(compile_scene(world.level));
  const auto solver = make_solver(scene);
  State state = initial_state(*scene);
  ExactBoxes exact = exact_world(world, state), other = shifted(exact, dice);
  const bool is_elastic = exact.bounce[0] == 1 && exact.bounce[1] == 1;
  const double rounding = is_elastic ? kRounding : kReflection;
  for (int frame = 1; frame <= kFrames; ++frame) {
    const ExactBoxes::Result result = exact.step();
    tally.largest_set = std::max(tally.largest_set, exact.largest_set());
    if (result != ExactBoxes::Result::done) return static_cast<std::size_t>(result);
    if (other.step() != ExactBoxes::Result::done) return kChaotic;
    const double allowed = std::max(kLeast, rounding * growth(exact, other));
    if (allowed > kMax) return kChaotic;
    solver->step(state, {});
    const Errors error = errors(state, exact);
    const bool is_right = error.place <= allowed && (exact.ends_at_impact() || error.velocity <= allowed);
    EXPECT_TRUE(is_right) << "frame " << frame << ": " << error.place << " px, " << error.velocity
                          << " px/frame, " << allowed << " allowed";
    if (!is_right) break;
    ++tally.frames;
    tally.impacts += exact.take_impacts();
    tally.error = std::max(tally.error, error.place);
    tally.share = std::max(tally.share, error.place / allowed);
  }
  return 0;
}

// The number of a world is the seed of everything in it.
void compare_worlds(bool on_grid) {
  const auto worlds = static_cast<std::uint64_t>(tries("TALUS_BOX_WORLDS", kWorlds) / 2);
  Tally tally;
  for (std::uint64_t number = 1; number <= worlds && !testing::Test::HasFailure(); ++number) {
    SCOPED_TRACE("world " + std::to_string(number));
    Dice dice(number);
    const World world = any_world(dice, on_grid);
    ++tally.ends[compare(world, dice, tally)];
  }
  EXPECT_GE(5 * static_cast<std::uint64_t>(tally.frames), worlds * kFrames) << "too little was compared";
  const auto record = [](const char* name, auto value) {
    testing::Test::RecordProperty(name, std::to_string(value));
  };
  record("frames", tally.frames);
  record("impacts", tally.impacts);
  record("largest_set", tally.largest_set);
  record("error_1e_15_px", tally.error * 1e15);
  record("share_of_allowed", tally.share);
  constexpr const char* kEnds[] = {"to_the_end", "close_call",   "large_set",
                                   "endless",    "many_impacts", "chaotic"};
  for (std::size_t i = 0; i < tally.ends.size(); ++i) record(kEnds[i], tally.ends[i]);
}

TEST(ExactBoxes, MeetAnywhereAsInRationalNumbers) { compare_worlds(false); }
TEST(ExactBoxes, MeetOnAGridAsInRationalNumbers) { compare_worlds(true); }

// ---- The reference itself ----

ExactBoxes::Box free_box(double width, double x, double velocity) {
  return {.size = {width, 8}, .place = {x, 0}, .velocity = {velocity, 0}, .inverse_mass = 1 / Exact(width)};
}

double off(const ExactBoxes& exact, std::size_t index, double velocity) {
  return std::abs(Exact(exact.boxes[index].velocity[0] - velocity).get_d());
}

TEST(ExactBoxes, OfTheReferenceAgreeWithClosedForms) {
  ExactBoxes row;
  for (int i = 0; i < 5; ++i) row.boxes.push_back(free_box(8, i < 2 ? 8 * i : 8 * i + 1.25, i < 2 ? 1 : 0));
  for (int i = 0; i < 3; ++i) ASSERT_EQ(row.step(), ExactBoxes::Result::done);
  const std::vector<double> after = reference::cradle(5, 2, 0, 1);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_LE(off(row, i, after[i]), 1e-50) << i;

  ExactBoxes two;
  two.bounce = {Exact(1, 2), 1};
  two.boxes = {free_box(8, 0, 2), free_box(24, 9, -1)};
  ASSERT_EQ(two.step(), ExactBoxes::Result::done);
  const auto [a, b] = reference::after_impact({8, 24}, {2, -1}, 0.5);
  EXPECT_LE(off(two, 0, a), 1e-15);
  EXPECT_LE(off(two, 1, b), 1e-15);
}

// Three that meet at one time, of several masses: momentum and energy are kept, and nothing approaches.
TEST(ExactBoxes, OfTheReferenceKeepMomentumAndEnergy) {
  ExactBoxes three;
  three.boxes = {free_box(8, 0, 3), free_box(24, 9, 0), free_box(2, 34, -3)};
  const auto sums = [&] {
    std::array<Exact, 2> all;
    for (const ExactBoxes::Box& box : three.boxes) {
      all[0] += box.velocity[0] / box.inverse_mass;
      all[1] += box.velocity[0] * box.velocity[0] / box.inverse_mass;
    }
    return all;
  };
  const auto before = sums();
  ASSERT_EQ(three.step(), ExactBoxes::Result::done);
  const auto after = sums();
  EXPECT_EQ(three.largest_set(), 2u);
  for (const int i : {0, 1}) EXPECT_LE(std::abs(Exact(after[i] - before[i]).get_d()), 1e-50);
  for (const int i : {0, 1}) EXPECT_LE(three.boxes[i].velocity[0], three.boxes[i + 1].velocity[0]);
}

}  // namespace talus::exact_boxes_test
