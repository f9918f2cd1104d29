// Discs: circles among bodies that meet.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <talus/c/talus.h>
#include <talus/level/body_kind.h>
#include "level_picture.h"
#include "meeting_run.h"
#include "native_text.h"
#include "reference/closed_forms.h"

namespace talus::disc_test {

using Play = MeetingRun;

// Nothing bounces but what a test asks for.
Level disc_level(std::initializer_list<std::string_view> rows, double gravity, double bounce = 0) {
  return meeting_level(rows, gravity, bounce);
}
void add(Level& level, Vec2 at, Vec2 velocity = {}, Vec2 size = {8, 8}, BodyKind kind = BodyKind::disc) {
  add_body(level, kind, at, velocity, size);
}
void add_line(Level& level, Vec2 from, Vec2 to) {
  level.curves.push_back({"", {Segment{from, to}, Curve::Faces::up}, ""});
}
Vec2 middle(const Body& disc) { return disc.box.center(); }
double norm(Vec2 v) { return std::hypot(v.x, v.y); }
double mass(const Body& body) { return mass_of(body.kind, {body.box.w, body.box.h}); }

// Of motion, of turning and of height, for a mass of 1.
double energy(const Body& disc, double gravity) {
  return dot(disc.velocity, disc.velocity) / 2 + disc.spin * disc.spin / 4 - gravity * middle(disc).y;
}

// ---- On the ground ----

TEST(Disc, SlidesOverAFloorUntilItRolls) {
  Level level = open_level(0.1, 0);
  add_line(level, {0, 100}, {480, 100});
  add(level, {20, 92}, {2, 0});
  Play run(level);
  const reference::Slide slide{.speed = 2, .gravity = 0.1, .friction = 0.5};
  double turned = 0;
  for (int frame = 1; frame <= 40; ++frame) {
    run.step();
    ASSERT_NEAR(run.body(0).box.x, 20 + slide.way(frame), 1e-12) << frame;
    ASSERT_NEAR(run.body(0).spin, slide.rim(frame), 1e-12) << frame;
    ASSERT_EQ(run.body(0).box.y, 92) << frame;
    ASSERT_TRUE(run.body(0).gait.grounded) << frame;
    turned += run.body(0).spin;
  }
  EXPECT_GE(run.body(0).turn, 0);
  EXPECT_LT(run.body(0).turn, 6.2832);
  EXPECT_GT(turned, 0);
}

// Radians from the lowest place of a bowl, of a body that swings from there, by steps of a two-thousandth of
// a frame (Runge and Kutta's).
double swung(double angle, double speed, double pull, double radius, int frames) {
  constexpr int kSteps = 2000;
  const double h = 1.0 / kSteps;
  const auto gain = [&](double at) { return -pull / radius * std::sin(at); };
  double turning = speed / radius;
  for (int i = 0; i < kSteps * frames; ++i) {
    const double k1 = turning, l1 = gain(angle), k2 = turning + h / 2 * l1, l2 = gain(angle + h / 2 * k1);
    const double k3 = turning + h / 2 * l2, l3 = gain(angle + h / 2 * k2), k4 = turning + h * l3;
    const double l4 = gain(angle + h * k3);
    angle += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    turning += h / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
  }
  return angle;
}

TEST(Disc, SwingsInABowlAsAPendulumDoes) {
  for (const BodyKind kind : {BodyKind::marble, BodyKind::disc}) {
    for (const double angle : {-0.6, 0.0, 0.5}) {
      for (const double speed : {-2.0, 1.0}) {
        Level level = open_level(0.2, 1);
        level.curves.push_back({"", {Arc{{150, 100}, 64, 86, 214, false}, Curve::Faces::up}, ""});
        const Vec2 at{150 + 60 * std::sin(angle), 100 + 60 * std::cos(angle)};
        add_body(level, kind, at - Vec2{4, 4}, Vec2{std::cos(angle), -std::sin(angle)} * speed);
        Play run(level);
        const bool rolls = kind == BodyKind::disc;
        if (rolls) run.state.bodies[0].spin = speed;
        run.step(3);
        const Vec2 from = middle(run.body(0)) - Vec2{150, 100};
        const double right = swung(angle, speed, rolls ? 0.2 * 2 / 3 : 0.2, 60, 3);
        EXPECT_NEAR(60 * std::atan2(from.x, from.y), 60 * right, 1e-4) << angle << ", " << speed;
      }
    }
  }
}

TEST(Disc, RollsOrSlidesDownAnIncline) {
  for (const double slope : {0.25, 0.5, 1.0, 1.5, 2.0, 3.0}) {
    Level level = open_level(0.1, 0);
    add_line(level, {16, 8}, {16 + 64, 8 + 64 * slope});
    const double size = std::hypot(1, slope);
    const Vec2 start{32 + 4 * slope / size - 4, 8 + 16 * slope - 4 / size - 4};
    add(level, start);
    Play run(level);
    const auto gains = reference::disc_down_incline(0.1, slope, 0.5);
    for (int frame = 1; frame <= 20; ++frame) {
      run.step();
      const double way = gains.gain * frame * frame / 2;
      ASSERT_NEAR(run.body(0).box.x, start.x + way / size, 1e-9) << slope << " " << frame;
      ASSERT_NEAR(run.body(0).box.y, start.y + way * slope / size, 1e-9) << slope << " " << frame;
      ASSERT_NEAR(run.body(0).spin, gains.rim * frame, 1e-9) << slope << " " << frame;
    }
  }
}

TEST(Disc, RollsOverTheJointsOfTiles) {
  Level level = disc_level({"................", "................", "################"}, 0.1);
  add(level, {4, 8}, {1.5, 0});
  Play run(level);
  run.step(12);
  const double speed = run.body(0).velocity.x;
  for (int frame = 0; frame < 80; ++frame) {
    run.step();
    ASSERT_EQ(run.body(0).velocity, (Vec2{speed, 0})) << frame;
    ASSERT_EQ(run.body(0).box.y, 8) << frame;
  }
}

TEST(Disc, KeepsItsEnergyInABowl) {
  for (const int parts : {1, 3}) {
    Level level = open_level(0.1, 0);
    level.tuning.exact.substeps = parts;
    level.curves.push_back({"", {Arc{{150, 100}, 60, 90, 210, false}, Curve::Faces::up}, ""});
    const double angle = 0.6, around = 56;
    add(level, {150 - around * std::sin(angle) - 4, 100 + around * std::cos(angle) - 4});
    Play run(level);
    const double before = energy(run.body(0), 0.1);
    for (int frame = 0; frame < 3000; ++frame) {
      run.step();
      ASSERT_NEAR(norm(middle(run.body(0)) - Vec2{150, 100}), around, 1e-9) << frame;
    }
    EXPECT_NEAR(energy(run.body(0), 0.1), before, 1e-7 * std::abs(before)) << parts;
  }
}

// A third of what pulls a disc goes into its turning. What is left out within a frame changes the time of a
// swing a little, and not its height.
TEST(Disc, SwingsInABowlAsAPendulum) {
  for (const BodyKind kind : {BodyKind::marble, BodyKind::disc}) {
    Level level = open_level(0.1, 1);
    level.curves.push_back({"", {Arc{{150, 100}, 60, 90, 210, false}, Curve::Faces::up}, ""});
    const double around = 56;
    reference::Pendulum swings{-0.6, (kind == BodyKind::disc ? 2.0 / 3 : 1) * 0.1 / around};
    add(level, {150 + around * std::sin(swings.angle) - 4, 100 + around * std::cos(swings.angle) - 4}, {},
        {8, 8}, kind);
    Play run(level);
    for (int frame = 1; frame <= 100; ++frame) {
      run.step();
      swings.frame();
      const Vec2 off = middle(run.body(0)) - Vec2{150, 100};
      ASSERT_NEAR(off.x, around * std::sin(swings.angle), 1.0 / 16) << frame;
      ASSERT_NEAR(off.y, around * std::cos(swings.angle), 1.0 / 16) << frame;
    }
  }
}

TEST(Disc, MarblesPassTheirMotionOn) {
  Level level = open_level(0, 1);
  for (int i = 0; i < 5; ++i)
    add(level, {i == 0 ? 61.0 : 100.0 + 8 * i, 40}, {i == 0 ? 2.0 : 0, 0}, {8, 8}, BodyKind::marble);
  Play run(level);
  run.step(60);
  const std::vector<double> after = reference::cradle(5, 1, 0, 2);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(run.body(i).velocity.x, after[i], 1e-12) << i;
}

TEST(Disc, RestsInAValleyAndSleeps) {
  Level level = open_level(0.2, 0);
  add_line(level, {16, 24}, {64, 72});
  add_line(level, {64, 72}, {112, 24});
  add(level, {40, 20});
  Play run(level);
  run.step(400);
  const State rests = run.state;
  run.step(50);
  EXPECT_EQ(run.body(0).box, rests.bodies[0].box);
  EXPECT_EQ(run.body(0).velocity, Vec2());
  EXPECT_NEAR(middle(run.body(0)).x, 64, 1e-6);
  EXPECT_NEAR(middle(run.body(0)).y, 72 - 4 * std::sqrt(2.0), 1e-6);
}

TEST(Disc, FallsThroughAGapAsWideAsItself) {
  for (const double more : {0.0, 1.0 / 256}) {
    Level level = disc_level({"........", "........", "........", "###.####", "###.####", "........",
                              "........", "........", "########"},
                             0.1);
    add(level, {24 - more / 2, 2}, {}, {8 + more, 8 + more});
    Play run(level);
    run.step(200);
    const double lowest = run.body(0).box.bottom();
    EXPECT_EQ(lowest > 60, more == 0) << lowest;
    EXPECT_EQ(lowest<29, more> 0) << "it rests on both corners";
    EXPECT_NEAR(middle(run.body(0)).x, 28, 1e-9);
  }
}

// A floor at y = 24 with a hole, that a circle of 8 px rolls to.
Level holed_floor(double hole, BodyKind kind, double speed, int parts) {
  Level level = open_level(0.1, 0);
  level.tuning.exact.substeps = parts;
  add_line(level, {0, 24}, {240, 24});
  add_line(level, {240 + hole, 24}, {480, 24});
  add(level, {speed > 0 ? 231 : 241 + hole, 16}, {speed, 0}, {8, 8}, kind);
  return level;
}

// The same with a hole of a tile in tiles.
Level holed_tiles(BodyKind kind, double speed, int parts) {
  Level level = disc_level({"....................", "....................", "....................",
                            "##########.#########", "....................", "...................."},
                           0.1);
  level.tuning.exact.substeps = parts;
  add(level, {speed > 0 ? 71.0 : 89.0, 16}, {speed, 0}, {8, 8}, kind);
  return level;
}

template <class Check>
void roll_to_holes(Check check) {
  for (const BodyKind kind : {BodyKind::marble, BodyKind::disc}) {
    for (const double speed : {0.1, 0.2, 0.5, 1.0, 1.5, -0.1, -0.2, -0.5, -1.0, -1.5}) {
      for (const int parts : {1, 3}) check(kind, speed, parts);
    }
  }
}

// hole: px, its left end.
void expect_through_or_across(const Level& level, double hole) {
  const double speed = level.spawns.front().velocity.x;
  Play run(level);
  run.step(140);
  const Rect& circle = run.body(0).box;
  const bool is_across = speed > 0 ? circle.x > hole + 8 : circle.right() < hole;
  EXPECT_TRUE(is_across || circle.y > 48) << speed << " " << level.tuning.exact.substeps;
  EXPECT_TRUE(is_across || std::abs(circle.x - hole) < 1e-8) << speed << " " << circle.x;
}

// It touches both corners a little before its middle is between them, where they would hold it as a wedge.
TEST(Disc, NoHoleAsWideAsItselfHoldsIt) {
  roll_to_holes([](BodyKind kind, double speed, int parts) {
    expect_through_or_across(holed_floor(8, kind, speed, parts), 240);
    expect_through_or_across(holed_tiles(kind, speed, parts), 80);
  });
}

TEST(Disc, ALittleNarrowerHoleHoldsIt) {
  roll_to_holes([](BodyKind kind, double speed, int parts) {
    Play run(holed_floor(8 - 1.0 / 256, kind, speed, parts));
    run.step(140);
    EXPECT_LT(run.body(0).box.bottom(), 28) << speed << " " << parts;
  });
}

TEST(Disc, FallsOutOfAHoleWhereItWasHeld) {
  Level level = holed_tiles(BodyKind::marble, 0.1, 1);
  level.spawns.front().position = {80 - 2e-10, 20 - 4e-5};
  level.spawns.front().velocity = {};
  Play run(level);
  run.step(40);
  EXPECT_NEAR(run.body(0).box.y, 100, 5);
  EXPECT_NEAR(run.body(0).box.x, 80, 1e-8);
}

TEST(Disc, StandsOnTheMiddleOfABoxThatIsNoSquare) {
  Level level = disc_level({"........", "........", "........", "########"}, 0.1);
  add(level, {10, 0}, {}, {6, 14});
  add(level, {30, 10}, {}, {14, 6});
  Play run(level);
  run.step(100);
  EXPECT_EQ(run.body(0).box.bottom(), 24);
  EXPECT_EQ(run.body(1).box.bottom(), 24);
  EXPECT_EQ(radius_of(BodyKind::disc, {6, 14}), 3);
  EXPECT_EQ(radius_of(BodyKind::crate, {6, 14}), 0);
  EXPECT_EQ(mass_of(BodyKind::disc, {6, 14}), mass_of(BodyKind::disc, {6, 6}));
}

// Heights of a hill, by turns of a small generator.
std::vector<double> hill(unsigned seed) {
  std::vector<double> heights(13);
  for (double& height : heights) {
    seed = seed * 1664525u + 1013904223u;
    height = 120 + static_cast<double>(seed >> 24) / 8;
  }
  heights.front() = heights.back() = 60;
  return heights;
}

// At a joint of two lines it goes from one to its end, and on to the next one. A record changes nothing.
TEST(Disc, RollsOverHillsAndIsNeverCaught) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    Level level = open_level(0.2, seed % 2 == 0 ? 0 : 0.7);
    level.tuning.exact.substeps = 1 + seed % 3;
    level.curves.push_back({"", {Polyline{0, 384, hill(seed)}, Curve::Faces::up}, ""});
    add(level, {40.0 + seed, 20}, {1.5, 0});
    add(level, {200, 30}, {-0.5, 0}, {13, 13});
    Play run(level), recorded(level);
    StepRecord record;
    for (int frame = 0; frame < 250; ++frame) {
      run.step();
      recorded.solver->step(recorded.state, {}, &record);
      for (std::size_t i = 0; i < 2; ++i) {
        ASSERT_FALSE(record.paths[i].capped) << seed << " " << frame;
        ASSERT_EQ(run.body(i), recorded.body(i)) << seed << " " << frame;
        ASSERT_LT(run.body(i).box.bottom(), 160) << seed << " " << frame;
      }
    }
  }
}

// ---- With other bodies ----

TEST(Disc, TwoThatHitKeepTheirMomenta) {
  for (const double beside : {0.0, 1.0, 3.5, 6.0, 9.0}) {
    Level level = open_level(0, 1);
    add(level, {20, 50}, {3, 0});
    add(level, {60.3, 48 + beside}, {-1, 0.05}, {12, 12});
    Play run(level);
    Vec2 momentum;
    double turning = 0;
    const auto measure = [&] {
      momentum = {};
      turning = 0;
      for (const Body& body : run.state.bodies) {
        const Vec2 at = middle(body);
        momentum = momentum + body.velocity * mass(body);
        turning +=
            mass(body) * (at.x * body.velocity.y - at.y * body.velocity.x + body.spin * body.box.w / 4);
      }
    };
    measure();
    const Vec2 before = momentum;
    const double turned = turning;
    run.step(30);
    measure();
    EXPECT_NEAR(momentum.x, before.x, 1e-12) << beside;
    EXPECT_NEAR(momentum.y, before.y, 1e-12) << beside;
    EXPECT_NEAR(turning, turned, 1e-10) << beside;
    EXPECT_NE(run.body(0).velocity, (Vec2{3, 0})) << beside;
  }
}

// A player stands like a wall, and has no friction.
TEST(Disc, LeavesACornerWhereTheClosedFormSays) {
  for (const double start : {0.05, 0.2}) {
    Level level = open_level(0.1, 0);
    add_line(level, {0, 100}, {480, 100});
    add(level, {100, 60}, {}, {40, 40}, BodyKind::player);
    add(level, {134, 52}, {start, 0});
    Play run(level);
    while (middle(run.body(1)).y < 59) run.step();
    const double cosine = reference::cosine_where_it_leaves(start, 0.1, 4);
    const double speed = std::sqrt(0.1 * 4 * cosine);
    EXPECT_NEAR(run.body(1).velocity.x, speed * cosine, 1e-9) << start;
  }
}

TEST(Disc, RollsOffACrateThatStands) {
  Level level = disc_level(
      {"................", "................", "................", "................", "################"},
      0.2);
  add(level, {40, 24}, {}, {8, 8}, BodyKind::crate);
  add(level, {42, 4}, {0.3, 0});
  Play run(level);
  run.step(120);
  EXPECT_EQ(run.body(1).box.bottom(), 32);
  EXPECT_GT(run.body(1).box.x, 48);
}

// px: how deep two discs, or a disc and a crate, are in one another at most.
double deepest_overlap(const State& state) {
  double deepest = 0;
  for (const Body& a : state.bodies)
    for (const Body& b : state.bodies)
      if (a.id < b.id) deepest = std::max(deepest, (a.box.w + b.box.w) / 2 - norm(middle(a) - middle(b)));
  return deepest;
}

TEST(Disc, APileComesToRest) {
  for (const int parts : {1, 2}) {
    Level level = disc_level({"#........#", "#........#", "#........#", "#........#", "#........#",
                              "#........#", "#........#", "#........#", "#........#", "##########"},
                             0.2, 0.3);
    level.tuning.exact.substeps = parts;
    for (int i = 0; i < 14; ++i)
      add(level, {11.0 + 10 * (i % 5) + 0.3 * (i % 3), 4.0 + 11 * (i / 5)}, {}, {7.0 + i % 3, 7.0 + i % 3});
    Play run(level);
    double deepest = 0;
    for (int frame = 0; frame < 400; ++frame) {
      run.step();
      deepest = std::max(deepest, deepest_overlap(run.state));
    }
    EXPECT_LT(deepest, 0.06) << parts;
    const State rests = run.state;
    run.step(20);
    EXPECT_EQ(state_hash(run.state) != state_hash(rests), true) << "the frame counts";
    for (std::size_t i = 0; i < rests.bodies.size(); ++i) {
      EXPECT_EQ(run.body(i).box, rests.bodies[i].box) << parts << " " << i;
      EXPECT_EQ(run.body(i).velocity, Vec2()) << parts << " " << i;
      EXPECT_LE(run.body(i).box.bottom(), 72 + 1e-12) << parts << " " << i;
    }
  }
}

// ---- Where they are boxes ----

TEST(Disc, IsABoxWhereBodiesOnlyBlock) {
  Level level = disc_level({"........", "........", "........", "########"}, 0.1);
  level.tuning.shared.bodies = static_cast<double>(BodyPairs::block);
  Level same = level;
  add(level, {10, 0}, {1, 0});
  add(same, {10, 0}, {1, 0}, {8, 8}, BodyKind::ball);
  Play disc(level), ball(same);
  for (int frame = 0; frame < 60; ++frame) {
    disc.step();
    ball.step();
    ASSERT_EQ(disc.body(0).box, ball.body(0).box) << frame;
  }
  EXPECT_EQ(disc.body(0).turn, 0);
}

TEST(Disc, ItsTurnIsPartOfTheHash) {
  State state;
  Body& disc = state.bodies.emplace_back();
  disc.kind = BodyKind::disc;
  State turned = state;
  turned.bodies[0].turn = 1;
  EXPECT_NE(state_hash(state), state_hash(turned));
  turned.bodies[0].turn = 0;
  turned.bodies[0].spin = 1;
  EXPECT_NE(state_hash(state), state_hash(turned));
}

TEST(Disc, TheInterfaceForCHasItsTurn) {
  const std::string text = native_with(R"("tuning": {"solver": "exact", "bodies": "meet",
                                                     "exact": {"gravity": 0.2}},
    "tiles": {"1": {"flags": [0]}},
    "map": {"width": 8, "height": 2, "rows": ["0000000000000000", "0101010101010101"]},
    "spawns": [{"kind": "disc", "x": 8, "y": 0, "vx": 1, "vy": 0}, {"kind": "crate", "x": 40, "y": 0}])");
  char error[200];
  talus_game* game = talus_read(text.data(), text.size(), "a.talus.json", error, sizeof error);
  ASSERT_NE(game, nullptr) << error;
  for (int frame = 0; frame < 10; ++frame) talus_step(game, 0, 0, 0, 0);
  talus_body disc, crate;
  ASSERT_EQ(talus_body_at(game, 0, &disc), 1);
  ASSERT_EQ(talus_body_at(game, 1, &crate), 1);
  EXPECT_EQ(disc.radius, 4);
  EXPECT_EQ(disc.mass, 1);
  EXPECT_NEAR(disc.spin, disc.vx, 1e-12);
  EXPECT_GT(disc.turn, 1);
  EXPECT_EQ(crate.radius, 0);
  EXPECT_EQ(crate.turn, 0);
  talus_close(game);
}

}  // namespace talus::disc_test
