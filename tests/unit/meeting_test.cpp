// Bodies that meet, against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <talus/sim/solver.h>
#include "level/transform.h"
#include "level_picture.h"
#include "meeting_run.h"

namespace talus::meeting_test {

Level empty_level() {
  return meeting_level({"................................", "................................"}, 0);
}

Spawn body(Vec2 at, Vec2 velocity = {}, Vec2 size = {8, 8}) {
  return {.name = "", .position = at, .velocity = velocity, .extra = "", .size = size};
}

using Play = MeetingRun;

double momentum(const State& state) {
  double sum = 0;
  for (const Body& b : state.bodies) sum += b.box.w * b.box.h * b.velocity.x;
  return sum;
}
double energy(const State& state) {
  double sum = 0;
  for (const Body& b : state.bodies) sum += b.box.w * b.box.h * dot(b.velocity, b.velocity) / 2;
  return sum;
}

// px: how deep the two bodies that overlap most are in one another.
double deepest_overlap(const State& state) {
  double deepest = 0;
  for (const Body& a : state.bodies)
    for (const Body& b : state.bodies) {
      if (a.id >= b.id) continue;
      const double x = std::min(a.box.right() - b.box.x, b.box.right() - a.box.x);
      const double y = std::min(a.box.bottom() - b.box.y, b.box.bottom() - a.box.y);
      deepest = std::max(deepest, std::min(x, y));
    }
  return deepest;
}

// ---- Impacts ----

Level cradle(int coming) {
  Level level = empty_level();
  for (int i = 0; i < 5; ++i) {
    const bool comes = i < coming;
    level.spawns.push_back(body({(comes ? 60.3 : 100.0) + 8 * i, 2}, {comes ? 2.0 : 0.0, 0}));
  }
  return level;
}

TEST(Meeting, InACradleAsManyLeaveAsCome) {
  for (const int coming : {1, 2, 3}) {
    Play run(cradle(coming));
    run.step(40);
    for (int i = 0; i < 5; ++i)
      EXPECT_NEAR(run.body(static_cast<std::size_t>(i)).velocity.x, i < 5 - coming ? 0 : 2, 1e-12)
          << coming << i;
    EXPECT_NEAR(run.body(4).box.x, 132 + 2 * (40 - (39.7) / 2), 1e-12) << coming;
  }
}

// The contacts of A and D with B and C depend on one another: any three give the fourth.
TEST(Meeting, AHitOnARingOfFourIsShared) {
  Level level = meeting_level(
      {"#######", "#.....#", "#.....#", "#.....#", "#.....#", "#.....#", "#.....#", "#.....#", "#######"}, 0);
  level.spawns = {body({28, 44}, {}, {8, 12}), body({36, 44}), body({36, 52}), body({44, 48}, {2, 0}, {4, 8}),
                  body({24, 52}, {1.5, 0}, {4, 4})};
  Play run(level);
  run.step(1);
  // From a world in rational numbers, see tests/reference/exact_boxes.h.
  const double right[] = {-0.86836734694, -0.70673469388, -0.70673469388, -0.53938775510, -1.07142857143};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(run.body(i).velocity.x, right[i], 1e-11) << i;
}

TEST(Meeting, ACornerPassedAtTheEndOfAFrameIsNoHit) {
  Level level = meeting_level({"....", "....", ".#..", "...."}, 0);
  for (const double frames : {0.5, 1.0, 2.0}) {
    level.spawns = {body({15, 11.5}, {1 / frames, 0.5 / frames}, {12, 4})};
    Play run(level);
    run.step(3);
    EXPECT_EQ(run.body(0).velocity, level.spawns[0].velocity) << frames;
    level.spawns[0].position.y += 0.25;  // now its bottom comes first
    Play lower(level);
    lower.step(3);
    EXPECT_LT(lower.body(0).velocity.y, 0) << frames;
  }
}

TEST(Meeting, TwoFromEitherSideAreMirrored) {
  Level level = empty_level();
  level.spawns = {body({100, 2}), body({60.5, 2}, {2, 0}), body({139.5, 2}, {-2, 0})};
  Play run(level);
  run.step(40);
  EXPECT_EQ(run.body(0).box.x, 100);
  EXPECT_EQ(run.body(0).velocity, Vec2());
  EXPECT_NEAR(run.body(1).velocity.x, -2, 1e-12);
  EXPECT_NEAR(run.body(2).velocity.x, 2, 1e-12);
  EXPECT_NEAR(run.body(1).box.x, 200 - run.body(2).box.x, 1e-12);
}

TEST(Meeting, MassesOfAllKindsKeepMomentumAndEnergy) {
  for (const double size : {1.0, 8.0, 256.0}) {
    Level level = empty_level();
    level.spawns = {body({20, 2}, {2, 0}), body({60, 2}, {}, {size, 8}), body({60 + size, 2})};
    Play run(level);
    const double before = momentum(run.state), power = energy(run.state);
    run.step(60);
    EXPECT_GT(std::abs(run.body(0).velocity.x - 2), 1e-3) << "they have met";
    EXPECT_NEAR(momentum(run.state) / before, 1, 1e-12) << size;
    EXPECT_NEAR(energy(run.state) / power, 1, 1e-12) << size;
  }
}

TEST(Meeting, TheOrderOfBodiesChangesNoBit) {
  Level level = meeting_level({"#..............#",  //
                               "#..............#",  //
                               "#..............#",  //
                               "#.../-.........#",  //
                               "################"},
                              0.2);
  level.tuning.shared.floor_bounce = 0.5;
  for (int i = 0; i < 6; ++i)
    level.spawns.push_back(
        body({9.0 + 13 * i, 2.0 + 3 * (i % 3)}, {1.5 - 0.6 * i, 0.3 * i}, {6.0 + i, 9.0 - i}));
  Level other = level;
  std::rotate(other.spawns.begin(), other.spawns.begin() + 2, other.spawns.end());
  Play run(level), turned(other);
  for (int i = 0; i < 200; ++i) {
    run.step(1);
    turned.step(1);
    for (std::size_t k = 0; k < 6; ++k) {
      const Body &a = run.body((k + 2) % 6), &b = turned.body(k);
      ASSERT_EQ(a.box, b.box) << i << " " << k;
      ASSERT_EQ(a.velocity, b.velocity) << i << " " << k;
    }
  }
}

TEST(Meeting, ABodyFarAwayChangesNoBitOfTheOthers) {
  Level level = cradle(1);
  Play run(level);
  level.spawns.push_back(body({200, 1}, {0.3, 0}));
  Play more(level);
  for (int i = 0; i < 30; ++i) {
    run.step(1);
    more.step(1);
    for (std::size_t k = 0; k < 5; ++k) ASSERT_EQ(run.body(k).box, more.body(k).box) << i;
  }
}

// Boxes of many sizes in a room without gravity. Every impact can be undone, so that they find back.
TEST(Meeting, ElasticBoxesComeBackWhenTheirWaysAreTurnedRound) {
  Level level = meeting_level({"##########", "#........#", "#........#", "#........#", "#........#",
                               "#........#", "#........#", "##########"},
                              0);
  for (int i = 0; i < 12; ++i) {
    const double size = 2.5 + i % 4;
    level.spawns.push_back(body({9.25 + 15 * (i % 4), 9.5 + 15 * static_cast<double>(i / 4)},
                                {2.5 - 0.45 * i, 0.35 * (i * i % 13) - 2}, {size, 8 - size}));
  }
  Play run(level);
  const State start = run.state;
  const double power = energy(start);
  run.step(500);
  EXPECT_NEAR(energy(run.state) / power, 1, 1e-12);
  for (Body& b : run.state.bodies) b.velocity = b.velocity * -1;
  run.step(500);
  for (std::size_t i = 0; i < start.bodies.size(); ++i) {
    EXPECT_NEAR(run.body(i).box.x, start.bodies[i].box.x, 1e-6) << i;
    EXPECT_NEAR(run.body(i).box.y, start.bodies[i].box.y, 1e-6) << i;
  }
}

// ---- Ground ----

TEST(Meeting, AFlightIsTheParabolaAtAnyNumberOfParts) {
  for (const double parts : {1.0, 3.0, 16.0}) {
    Level level = meeting_level({"..........", "..........", "..........", "##########"}, 0.2);
    level.tuning.exact.substeps = parts;
    level.spawns = {body({20, 4}), body({60, 4})};
    Play run(level);
    // It falls 12 px in sqrt(120) frames, and rises as long.
    const double fall = std::sqrt(2 * 12 / 0.2);
    for (int frame = 1; frame <= 1000; ++frame) {
      run.step(1);
      const double phase = std::abs(std::remainder(frame, 2 * fall));
      ASSERT_NEAR(run.body(0).box.y, 4 + 0.1 * phase * phase, 1e-9) << parts << " " << frame;
    }
  }
}

TEST(Meeting, ABoxSlidesDownASlopeByTheClosedForm) {
  Level level = meeting_level({"..................", "................/-", "............../-##",
                               "............/-####", "########../-######", "##################"},
                              0.2);
  level.tuning.shared.floor_bounce = level.tuning.shared.wall_bounce = 0;
  // Its right corner is on the line from (80, 40) to (144, 8).
  const double x = 120, slope = 0.5;
  level.spawns = {body({x - 8, 40 - (x - 80) * slope - 8})};
  Play run(level);
  const double along = 0.2 * slope / (1 + slope * slope);  // px/frame^2, in x
  for (int frame = 1; frame <= 20; ++frame) {
    run.step(1);
    ASSERT_NEAR(run.body(0).box.x, x - 8 - along * frame * frame / 2, 1e-9) << frame;
    ASSERT_NEAR(run.body(0).box.bottom(), 40 - (run.body(0).box.right() - 80) * slope, 1e-9) << frame;
  }
}

// ---- Rest ----

Level pile() {
  Level level =
      meeting_level({"..........", "..........", "..........", "..........", "..........", "..........",
                     "..........", "..........", "..........", "..........", "..........", "##########"},
                    0.2);
  level.tuning.shared.floor_bounce = 0.3;
  for (int i = 0; i < 8; ++i) level.spawns.push_back(body({20 + i * 0.5, 78.0 - 9 * i}));
  return level;
}

TEST(Meeting, APileComesToRestAndKeepsItsBits) {
  Play run(pile());
  run.step(300);
  for (int i = 0; i < 8; ++i) EXPECT_NEAR(run.body(static_cast<std::size_t>(i)).box.y, 80 - 8 * i, 1e-9);
  EXPECT_LE(deepest_overlap(run.state), 1e-9);
  const std::vector<Body> before = run.state.bodies;
  run.step(1000);
  EXPECT_EQ(run.state.bodies, before);
}

// 21 crates, more than are solved at once.
Level pyramid() {
  Level level = pile();
  level.spawns.clear();
  for (int row = 0; row < 6; ++row) {
    for (int i = 0; i < 6 - row; ++i) {
      level.spawns.push_back(body({10 + 4.5 * row + 9 * i, 80 - 8.5 * row}));
      level.spawns.back().kind = BodyKind::crate;
    }
  }
  return level;
}

TEST(Meeting, SleepChangesNoBit) {
  for (const int substeps : {1, 3}) {
    for (Level level : {pile(), pyramid()}) {
      level.tuning.exact.substeps = substeps;
      Play run(level), recorded(level);
      State state = run.state;
      StepRecord record;  // with which nothing sleeps
      for (int i = 0; i < 150; ++i) {
        run.step(1);
        recorded.solver->step(recorded.state, {}, &record);
        state = step(*run.scene, state, {});
        ASSERT_EQ(run.state, state) << i;
        ASSERT_EQ(recorded.state, state) << i;
      }
    }
  }
}

TEST(Meeting, APileFallsWhenItsLowestBodyIsTakenAway) {
  Level level = pile();
  Play run(level);
  run.step(300);
  level.spawns.erase(level.spawns.begin());
  for (Spawn& spawn : level.spawns) spawn.name = "one of the others";
  const auto scene = std::make_shared<const Scene>(compile_scene(level));
  State state = run.state;
  state.bodies.erase(state.bodies.begin());
  const auto solver = make_solver(scene);
  for (int i = 0; i < 8; ++i) solver->step(state, {});
  for (std::size_t i = 0; i < 7; ++i)
    EXPECT_NEAR(state.bodies[i].box.y, 72 - 8.0 * static_cast<double>(i) + 0.1 * 8 * 8, 1e-9) << i;
}

TEST(Meeting, ASolverGoesOnWhenABodyIsTakenAway) {
  const Level level = pile();
  Play run(level);
  run.step(300);
  run.state.bodies.erase(run.state.bodies.begin());
  State state = run.state;
  for (int i = 0; i < 100; ++i) {
    run.step(1);
    state = step(*run.scene, state, {});
    ASSERT_EQ(run.state, state) << i;
  }
}

TEST(Meeting, HeavyAndLightRestOnOneAnother) {
  for (const bool heavy_below : {true, false}) {
    Level level = pile();
    level.spawns = {body({8, heavy_below ? 40.0 : 20.0}, {}, {64, 40}),
                    body({30, heavy_below ? 20.0 : 80.0}, {}, {1, 1})};
    Play run(level);
    run.step(400);
    const std::size_t lower = heavy_below ? 0 : 1;
    EXPECT_NEAR(run.body(lower).box.bottom(), 88, 1e-9);
    EXPECT_NEAR(run.body(1 - lower).box.bottom(), run.body(lower).box.y, 1e-9);
  }
}

TEST(Meeting, BodiesInOnePlacePartAndRest) {
  Level level = pile();
  level.spawns.assign(20, body({30, 60}));
  Play run(level);
  run.step(600);
  EXPECT_LE(deepest_overlap(run.state), 1e-9);
  for (const Body& b : run.state.bodies) EXPECT_LE(b.box.bottom(), 88 + 1e-9);
}

// So many in one place take more work than a step may: it stops before anything is missed, and says so.
TEST(Meeting, AStepWithTooMuchWorkStopsAndSaysSo) {
  Level level = pile();
  level.spawns.assign(2600, body({30, 79.95}));
  Play run(level);
  StepRecord record;
  run.solver->step(run.state, {}, &record);
  for (std::size_t i = 0; i < record.paths.size(); ++i) {
    ASSERT_TRUE(record.paths[i].cut_short) << i;
    ASSERT_LE(run.body(i).box.bottom(), 88) << i;
  }
}

// Bouncy bodies, one on the other, hit the floor at once: so many impacts follow that a step does not end
// them.
TEST(Meeting, ATallTowerLandsAndRests) {
  Level level = pile();
  level.tuning.shared.floor_bounce = 0.9;
  level.spawns.clear();
  for (int i = 0; i < 120; ++i) level.spawns.push_back(body({30, 70.0 - 8 * i}));
  Play run(level);
  run.step(60);
  for (int i = 0; i < 120; ++i)
    ASSERT_NEAR(run.body(static_cast<std::size_t>(i)).box.bottom(), 88 - 8 * i, 1e-9) << i;
}

// ---- Friction ----

// A crate with a friction of 1/2 slides to rest on a level floor, by the closed form.
TEST(Meeting, FrictionStopsACrateWhereTheClosedFormSays) {
  Level level = meeting_level({"....................", "....................", "####################"}, 0.2);
  level.spawns = {body({20, 8}, {2.5, 0})};
  level.spawns[0].kind = BodyKind::crate;
  Play run(level);
  const double slows = 0.5 * 0.2;  // px/frame^2
  for (int frame = 1; frame <= 40; ++frame) {
    run.step(1);
    const double time = std::min<double>(frame, 2.5 / slows);
    ASSERT_NEAR(run.body(0).box.x, 20 + 2.5 * time - slows * time * time / 2, 1e-9) << frame;
  }
  EXPECT_EQ(run.body(0).velocity, Vec2());
}

// One on the other: the lower one takes the upper one along as far as friction can.
// On the slope, sliding would press the lowest crate ever more into what it slides on.
TEST(Meeting, JammedCratesStop) {
  const auto crate = [](Vec2 at, Vec2 velocity, Vec2 size) {
    Spawn spawn = body(at, velocity, size);
    spawn.kind = BodyKind::crate;
    return spawn;
  };
  Level level = meeting_level({"...."}, 0.5);
  level.map = TileMap(26, 40);
  level.tuning.shared.floor_bounce = 0;
  level.tuning.shared.wall_bounce = 0.6;
  const Vec2 line[] = {{8, 312}, {52, 288}, {104, 312}, {156, 288}, {200, 312}};
  for (int i = 0; i < 4; ++i)
    level.curves.push_back({"", {Segment{line[i], line[i + 1]}, Curve::Faces::both}, ""});
  level.spawns = {
      crate({66.20379139174202, 98.21574673590573}, {3.13604287861408, 3.2562616670087436}, {3, 5}),
      crate({140.6341188080211, 125.42471136076165}, {0.0, 0.0}, {8, 8}),
      crate({136.1293187931751, 147.25795966693966}, {-0.10496699787216879, -0.15721257149691015}, {12, 3}),
      crate({145.39867254713937, 26.821597770164118}, {0.0, 0.0}, {8, 8}),
  };
  for (const int substeps : {1, 2, 3}) {
    level.tuning.exact.substeps = substeps;
    Play run(level);
    for (int frame = 1; frame <= 60; ++frame) {
      run.step(1);
      for (const Body& b : run.state.bodies) ASSERT_LT(std::abs(b.velocity.x) + std::abs(b.velocity.y), 20);
    }
  }
}

TEST(Meeting, ACrateTakesAlongWhatStandsOnIt) {
  Level level = meeting_level(
      {"....................", "....................", "....................", "####################"}, 0.2);
  level.spawns = {body({20, 16}, {2, 0}), body({20, 8})};
  for (Spawn& spawn : level.spawns) spawn.kind = BodyKind::crate;
  Play run(level);
  run.step(1);
  // Both are slowed, or pulled along, with half of the gravity; the lower one by the floor, too.
  EXPECT_NEAR(run.body(1).velocity.x, 0.1, 1e-12);
  EXPECT_NEAR(run.body(0).velocity.x, 2 - 0.1 - 0.2, 1e-12);
  run.step(60);
  EXPECT_EQ(run.body(0).velocity, Vec2());
  EXPECT_EQ(run.body(1).velocity, Vec2());
  EXPECT_NEAR(run.body(1).box.bottom(), run.body(0).box.y, 1e-9);
}

// ---- The mouse and players ----

TEST(Meeting, TheMouseDragsABallIntoOthersAndMovesThem) {
  Level level = meeting_level({"....................", "....................", "####################"}, 0.2);
  level.tuning.shared.floor_bounce = level.tuning.shared.wall_bounce = 0;
  level.spawns = {body({20, 8}), body({40, 8})};
  Play run(level);
  Input input;
  input.mouse_down = true;
  input.grab = 1;
  for (int i = 0; i < 60; ++i) {
    input.mouse = {24.0 + i, 12};
    run.step(1, input);
    EXPECT_LE(run.body(0).box.right(), run.body(1).box.x + 1e-9) << i;
  }
  EXPECT_GT(run.body(1).box.x, 60);
  EXPECT_NEAR(run.body(1).box.bottom(), 16, 1e-9);
  // Let go, it is thrown with the speed of its last frame.
  const double speed = run.body(0).box.x - run.body(0).previous.x;
  run.step(1);
  EXPECT_NEAR(run.body(0).velocity.x, speed, 1e-12);
}

TEST(Meeting, WhatTheMouseDragsDoesNotBounce) {
  Level level = meeting_level({"....................", "....................", "####################"}, 0.2);
  level.tuning.shared.floor_bounce = level.tuning.shared.wall_bounce = 0.9;
  level.spawns = {body({24, -8}), body({20, 8})};
  Play run(level);
  Input input{.mouse = {24, 12}, .mouse_down = true, .grab = 1};
  run.step(60, input);
  const Rect at = run.body(0).box;
  EXPECT_NEAR(at.bottom(), run.body(1).box.y, 1e-9) << "on the other one, however much it is pulled down";
  for (int i = 0; i < 60; ++i) {
    run.step(1, input);
    EXPECT_NEAR(run.body(0).box.y, at.y, 1e-9) << i;
  }
}

TEST(Meeting, ABallThatFallsAsInTheArticleComesToRest) {
  Level level = meeting_level({"..........", "..........", "..........", "##########"}, 0);
  level.tuning.shared.fall_speed = 5;
  level.tuning.shared.fall_blend = 0.075;
  level.tuning.shared.floor_bounce = 0.9;
  level.spawns = {body({24, 3.3})};
  Play run(level);
  run.step(400);
  EXPECT_EQ(run.body(0).box.bottom(), 24);
  EXPECT_EQ(run.body(0).velocity.y, 0);
}

TEST(Meeting, APlayerStandsLikeAWall) {
  Level level = meeting_level({"....................", "....................", "####################"}, 0.2);
  level.tuning.shared.floor_bounce = 0;
  level.spawns = {body({40, 8}, {-2, 0}), body({8, 8})};
  level.spawns[1].kind = BodyKind::player;
  Play run(level);
  run.step(60);
  EXPECT_EQ(run.body(1).box.x, 8);
  EXPECT_NEAR(run.body(0).velocity.x, 2, 1e-12);
}

TEST(Meeting, ARecordTellsOfContactsAndChangesNothing) {
  const Level level = cradle(1);
  Play run(level), recorded(level);
  StepRecord record;
  int impacts = 0;
  for (int i = 0; i < 40; ++i) {
    run.step(1);
    recorded.solver->step(recorded.state, {}, &record);
    ASSERT_EQ(record.paths.size(), 5u);
    for (std::size_t k = 0; k < 5; ++k) ASSERT_EQ(record.paths[k].to, recorded.body(k).box);
    for (const ContactRecord& contact : record.contacts) {
      EXPECT_NE(contact.other.body, 0);
      if (contact.body == 1) ++impacts;
    }
    ASSERT_EQ(run.state, recorded.state);
  }
  EXPECT_EQ(impacts, 1);
}

TEST(Meeting, AMirroredLevelRunsMirrored) {
  Level level = meeting_level({"#..................#",  //
                               "#..................#",  //
                               "#......../-........#",  //
                               "#....../-##........#",  //
                               "####################"},
                              0.2);
  level.tuning.shared.floor_bounce = 0.3;
  level.tuning.shared.wall_bounce = 0.5;
  for (int i = 0; i < 5; ++i)
    level.spawns.push_back(body({20.0 + 21 * i, 2}, {1.1 - 0.5 * i, 0}, {5.0 + i, 6}));
  Play run(level), other(mirrored(level));
  for (int frame = 1; frame <= 600; ++frame) {
    run.step(1);
    other.step(1);
    for (std::size_t i = 0; i < 5; ++i) {
      ASSERT_NEAR(run.body(i).box.x, 160 - other.body(i).box.right(), 1e-9) << frame;
      ASSERT_NEAR(run.body(i).box.y, other.body(i).box.y, 1e-9) << frame;
    }
  }
}

}  // namespace talus::meeting_test
