// Properties of whole runs of the exact solver in random rooms: no body is in the ground, goes through it or
// leaves the room; a mirrored room gives the mirrored run; and the order of bodies that pass through each
// other does not matter. TALUS_PROPERTY_MOVES: the number of steps of a body for each property, at least
// kMoves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include <talus/sim/solver.h>
#include "random_ground.h"
#include "tries.h"

namespace talus::exact_solver_property_test {

using reference::Exact;
using reference::ExactBox;
using reference::ExactGround;
using reference::ExactHit;

constexpr double kMoves = 9600;
constexpr int kFrames = 60;
constexpr int kBodies = 4;
constexpr double kUnits = 16;  // units in the last place by which a box may be in the ground

// The number of a room is the seed of everything in it, so that a failing room can be made again. The rooms
// are the same in every run, and there are more of them at night.
template <class Check>
void for_rooms(Check check) {
  const auto rooms = static_cast<std::uint64_t>(tries("TALUS_PROPERTY_MOVES", kMoves) / (kFrames * kBodies));
  for (std::uint64_t room = 1; room <= rooms && !testing::Test::HasFailure(); ++room) {
    SCOPED_TRACE("room " + std::to_string(room));
    Dice dice(room);
    check(dice);
  }
}

// ---- Rooms ----

// How many columns lie left of a room (its width in cells), so that it is between two neighbouring powers of
// two: all x there are multiples of one number.
int columns_left_of(int room_width, TileSize tile) {
  for (int power = 1;; power *= 2) {
    const int columns = (power + tile.width - 1) / tile.width;
    if ((columns + room_width) * tile.width <= 2 * power) return columns;
  }
}

enum class Place { at_the_left, between_powers_of_two };

// Random ground between walls of full tiles, in a map that has as many columns on the right of the walls as
// on their left.
struct Room {
  RandomGround ground;
  ExactGround exact;
  Rect inside;  // px, between the walls

  Room(Dice& dice, Place place, int width, int height, GroundKinds kinds) {
    ground = random_ground(dice, width - 2, height - 2, kinds);
    const int columns = place == Place::at_the_left ? 0 : columns_left_of(width, ground.tile);
    ground = ground.moved(columns + 1, 1);
    const RandomGround inner = ground;
    ground.width = 2 * columns + width, ground.height = height;
    ground.cells.assign(static_cast<std::size_t>(ground.width) * height, 0);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const bool wall = x == 0 || y == 0 || x == width - 1 || y == height - 1;
        const std::size_t from = static_cast<std::size_t>(y) * inner.width + columns + x;
        ground.cells[static_cast<std::size_t>(y) * ground.width + columns + x] = wall ? 1 : inner.cells[from];
      }
    }
    exact = ground.exact();
    const double w = ground.tile.width, h = ground.tile.height;
    inside = {(columns + 1) * w, h, (width - 2) * w, (height - 2) * h};
  }
};

struct Tune {
  bool single = false, bodies_block = false;
};

Tuning random_tuning(Dice& dice, Tune tune) {
  Tuning t;
  t.exact.single_precision = tune.single;
  t.shared.bodies = tune.bodies_block;
  if (dice.one_in(2)) {
    t.shared.fall_speed = dice.step(0.5, 100, 16);
    t.shared.floor_bounce = t.shared.wall_bounce = dice.up_to(4) / 4.0;
    t.shared.floor_grip = 1;
    t.shared.drift_blend = 0;
  }
  if (dice.one_in(3)) t.exact.gravity = 0.25;
  t.exact.rebound = dice.up_to(1);
  t.exact.steepest = dice.step(0, 4, 2);
  t.player.run_speed = dice.one_in(3) ? dice.step(1, 100, 16) : 1.5;
  t.player.jump_speed = dice.one_in(3) ? dice.step(1, 100, 16) : 3.5;
  return t;
}

SceneItem random_body(Dice& dice, const Room& room, BodyKind kind, Foot foot) {
  SceneItem body{.role = TileRole::ball, .box = {}, .cell = {}, .velocity = {}, .spawn = 0, .kind = kind};
  body.foot = foot;
  for (int tries = 0; tries < 40; ++tries) {
    const double side = tries < 20 ? 8 : 0.5;
    Vec2 size{dice.one_in(2) ? side : dice.step(0.25, side, 16), dice.step(0.25, side, 16)};
    body.box = {dice.step(room.inside.x, room.inside.right() - size.x, 16),
                dice.step(room.inside.y, room.inside.bottom() - size.y, 16), size.x, size.y};
    const Rect& b = body.box;
    if (!room.exact.meets({b.x, b.y, b.w, b.h})) break;
  }
  const double speed = dice.one_in(2) ? 4 : 100;
  if (kind == BodyKind::ball) body.velocity = {dice.step(-speed, speed, 16), dice.step(-speed, speed, 16)};
  return body;
}

// Bodies for which no free place was found are left out.
std::vector<SceneItem> random_bodies(Dice& dice, const Room& room, bool players, Foot foot) {
  std::vector<SceneItem> bodies;
  for (int i = 0; i < kBodies; ++i) {
    const BodyKind kind = players && dice.one_in(2) ? BodyKind::player : BodyKind::ball;
    const SceneItem body = random_body(dice, room, kind, foot);
    if (room.exact.meets({body.box.x, body.box.y, body.box.w, body.box.h})) continue;
    bodies.push_back(body);
    bodies.back().spawn = static_cast<int>(bodies.size()) - 1;
  }
  return bodies;
}

std::shared_ptr<const Scene> scene_of(const RandomGround& ground, const Tuning& tuning,
                                      std::vector<SceneItem> bodies) {
  TerrainSource source;
  source.width = ground.width, source.height = ground.height;
  source.tile = ground.tile;
  source.cells = ground.cells;
  source.shapes = ground.shapes;
  source.curves = ground.curves;
  auto scene = std::make_shared<Scene>();
  scene->tuning = tuning;
  scene->items = std::move(bodies);
  if (tuning.exact.single_precision != 0) {
    scene->single_ground = std::make_shared<const BasicTerrain<float>>(source);
  } else {
    scene->ground = std::make_shared<const Terrain>(source);
  }
  scene->features.pairs = tuning.shared.pairs() != BodyPairs::pass && scene->items.size() > 1;
  return scene;
}

std::vector<Input> random_keys(Dice& dice) {
  std::vector<Input> keys(kFrames);
  Input now;
  for (Input& input : keys) {
    if (dice.one_in(8)) now.left = dice.one_in(2);
    if (dice.one_in(8)) now.right = dice.one_in(2);
    if (dice.one_in(8)) now.jump = dice.one_in(2);
    input = now;
  }
  return keys;
}

// ---- What is wrong with a step ----

ExactBox exact_box(const Rect& b) { return {b.x, b.y, b.w, b.h}; }

// A unit in the last place of the largest coordinate in the room, in the precision of the step. Bounds are
// multiples of it.
double unit_of(const Room& room, bool single) {
  const double most = std::max(room.inside.right(), room.inside.bottom());
  return std::exp2(std::floor(std::log2(most)) - (single ? 23 : 52));
}

struct Judge {
  const Room& room;
  double slack;  // the allowed depth of a box in the ground, px

  const char* wrong_place(const Body& body) const {
    Rect b = body.box;
    if (body.foot == Foot::centre) b.x += b.w / 2, b.w = 0;  // its sides may be in a slope, or behind one
    const Rect& in = room.inside;
    if (b.x < in.x - slack || b.y < in.y - slack || b.right() > in.right() + slack ||
        b.bottom() > in.bottom() + slack)
      return "is out of the room";
    return room.exact.depth(exact_box(b)) <= slack ? nullptr : "is in the ground";
  }

  // A ball moves straight from contact to contact: nothing may be in between.
  const char* wrong_way(const StepRecord& record, const BodyPath& path) const {
    Rect at = path.from;
    const auto goes_through = [&](Vec2 to) {
      const ExactBox less = exact_box(at).grown(-slack);
      const Exact dx = Exact(to.x) - Exact(at.x), dy = Exact(to.y) - Exact(at.y);
      at.x = to.x, at.y = to.y;
      if (less.w <= 0 || less.h <= 0) return false;
      const ExactHit hit = room.exact.cast(less, dx, dy);
      return hit.t < 1 && !hit.passed_a_line;
    };
    for (const ContactRecord& contact : record.contacts) {
      if (contact.body == path.body && goes_through(contact.touch)) return "came through the ground";
    }
    return goes_through(path.to.position()) ? "goes through the ground" : nullptr;
  }
};

void expect_inside(Dice& dice, Foot foot, bool single) {
  const GroundKinds kinds{.one_way = dice.one_in(2), .segments = dice.one_in(2)};
  const Room room(dice, Place::at_the_left, 6 + dice.up_to(10), 6 + dice.up_to(10), kinds);
  const Tuning tuning = random_tuning(dice, {single, dice.one_in(2)});
  const auto scene = scene_of(room.ground, tuning, random_bodies(dice, room, true, foot));
  const Judge judge{room, kUnits * unit_of(room, single)};
  const auto solver = make_solver(scene);
  State state = initial_state(*scene);
  StepRecord record;
  for (const Input& input : random_keys(dice)) {
    const State before = state;
    solver->step(state, input, &record);
    for (std::size_t i = 0; i < state.bodies.size(); ++i) {
      const Body& body = state.bodies[i];
      const char* wrong = judge.wrong_place(body);
      if (wrong == nullptr && body.kind == BodyKind::ball && foot == Foot::box)
        wrong = judge.wrong_way(record, record.paths[i]);
      if (wrong != nullptr) {
        const Rect& from = before.bodies[i].box;
        const Vec2 v = before.bodies[i].velocity;
        char text[400];
        std::snprintf(
            text, sizeof text,
            "frame %d body %d kind %d {%.17g, %.17g, %.17g, %.17g} at %.17g %.17g went to %.17g %.17g "
            "depth %g units: ",
            static_cast<int>(state.frame), body.id, static_cast<int>(body.kind), from.x, from.y, from.w,
            from.h, v.x, v.y, body.box.x, body.box.y,
            room.exact.depth(exact_box(body.box)).get_d() / unit_of(room, single));
        ADD_FAILURE() << text << wrong;
      }
      ASSERT_EQ(wrong, nullptr);
    }
  }
}

// ---- Properties ----

TEST(ExactSolverProperty, NoBodyIsInTheGround) {
  for_rooms([](Dice& dice) { expect_inside(dice, Foot::box, false); });
}

TEST(ExactSolverProperty, NoBodyIsInTheGroundInSinglePrecision) {
  for_rooms([](Dice& dice) { expect_inside(dice, Foot::box, true); });
}

TEST(ExactSolverProperty, NoCentreIsInTheGround) {
  for_rooms([](Dice& dice) { expect_inside(dice, Foot::centre, false); });
}

TEST(ExactSolverProperty, NoCentreIsInTheGroundInSinglePrecision) {
  for_rooms([](Dice& dice) { expect_inside(dice, Foot::centre, true); });
}

// The room's mirror image is at the same place, and all x in it are multiples of one number, so both sides
// round alike. Left and right of a power of two they would not.
TEST(ExactSolverProperty, AMirroredRoomGivesTheMirroredRun) {
  for_rooms([](Dice& dice) {
    const GroundKinds kinds{.one_way = dice.one_in(2), .segments = dice.one_in(2)};
    const Room room(dice, Place::between_powers_of_two, 32, 6 + dice.up_to(10), kinds);
    Tuning tuning = random_tuning(dice, {false, dice.one_in(2)});
    const std::vector<SceneItem> bodies =
        random_bodies(dice, room, true, dice.one_in(2) ? Foot::box : Foot::centre);
    std::vector<SceneItem> images = bodies;
    const double width = room.ground.right();
    for (SceneItem& item : images) {
      item.box.x = width - item.box.x - item.box.w;
      item.velocity.x = -item.velocity.x;
    }
    const auto scene = scene_of(room.ground, tuning, bodies);
    tuning.shared.drift_speed = -tuning.shared.drift_speed;
    const auto image = scene_of(room.ground.mirrored(), tuning, images);
    const auto solver = make_solver(scene), other = make_solver(image);
    State a = initial_state(*scene), b = initial_state(*image);
    for (Input input : random_keys(dice)) {
      solver->step(a, input);
      std::swap(input.left, input.right);
      other->step(b, input);
      for (std::size_t k = 0; k < a.bodies.size(); ++k) {
        const Body &x = a.bodies[k], &y = b.bodies[k];
        ASSERT_EQ(x.box.x, width - y.box.x - y.box.w) << "frame " << a.frame << " body " << x.id;
        ASSERT_EQ(x.box.y, y.box.y) << "frame " << a.frame << " body " << x.id;
        ASSERT_EQ(x.velocity, (Vec2{-y.velocity.x, y.velocity.y}));
        ASSERT_EQ(x.gait, y.gait);
      }
    }
  });
}

TEST(ExactSolverProperty, BodiesThatPassEachOtherDoNotDependOnTheirOrder) {
  for_rooms([](Dice& dice) {
    const GroundKinds kinds{.one_way = true, .segments = true, .curves = dice.one_in(2)};
    const Room room(dice, Place::at_the_left, 6 + dice.up_to(10), 6 + dice.up_to(10), kinds);
    const Tuning tuning = random_tuning(dice, {dice.one_in(2), false});
    const auto bodies = random_bodies(dice, room, true, dice.one_in(2) ? Foot::box : Foot::centre);
    auto shuffled = bodies;
    dice.shuffle(shuffled);
    const auto scene = scene_of(room.ground, tuning, bodies), other = scene_of(room.ground, tuning, shuffled);
    const auto solver = make_solver(scene), other_solver = make_solver(other);
    State a = initial_state(*scene), b = initial_state(*other);
    for (const Input& input : random_keys(dice)) {
      solver->step(a, input);
      other_solver->step(b, input);
      for (const Body& body : a.bodies) {
        const auto same = std::find_if(b.bodies.begin(), b.bodies.end(),
                                       [&](const Body& x) { return x.origin == body.origin; });
        ASSERT_TRUE(same->box == body.box && same->velocity == body.velocity && same->gait == body.gait);
      }
    }
  });
}

}  // namespace talus::exact_solver_property_test
