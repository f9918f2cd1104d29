// Walks of the exact solver: where a player goes on along the floor, and where it is stopped.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <talus/sim/solver.h>

namespace talus::walk_test {

constexpr int kFloor = 96;  // px, y of the floor's top

// A floor in row 12, with tiles of these shapes on it from column 5 on.
struct Scenery {
  Scenery() {
    level.tuning.solver = SolverKind::exact;
    level.map = TileMap(40, 14);
    level.tile_shapes[1].kind = TileShape::Kind::solid;
    for (int x = 0; x < 40; ++x) level.map.set({x, 12}, 1);
  }
  void put(Cell cell, TileShape shape) {
    level.tile_shapes[next] = std::move(shape);
    level.map.set(cell, next++);
  }
  void fill(int from, int to, int row) {
    for (int x = from; x <= to; ++x) level.map.set({x, row}, 1);
  }
  void player(double x, double y, Foot foot, Vec2 size = {8, 8}) {
    Spawn& spawn = level.spawns.emplace_back();
    spawn.kind = BodyKind::player;
    spawn.position = {x, y - size.y};
    spawn.size = size;
    spawn.foot = foot;
  }
  Level level;
  TileNumber next = 2;
};

TileShape slope(double left, double right, bool one_way = false) {
  return {.kind = TileShape::Kind::slope, .one_way = one_way, .heights = {left, right}};
}

// The player after these steps in a direction; each step must leave it on a floor.
Body walked(const Level& level, int direction, int steps) {
  const auto scene = std::make_shared<const Scene>(compile_scene(level));
  const auto solver = make_solver(scene);
  State state = initial_state(*scene);
  for (int i = 0; i < 4 + steps; ++i) {
    Input input;
    input.left = i >= 4 && direction < 0;
    input.right = i >= 4 && direction > 0;
    solver->step(state, input, nullptr);
    if (i >= 4) {
      EXPECT_TRUE(state.bodies[0].gait.grounded) << "step " << i - 4;
    }
  }
  return state.bodies[0];
}

TEST(Walk, LeadsFromAOneWaySlopeOntoSolidGround) {
  for (const double rise : {2.0, 4.0, 8.0}) {  // 14, 27 and 45 degrees
    for (const double width : {2.0, 8.0, 15.0, 40.0}) {
      Scenery scenery;
      const int columns = static_cast<int>(8 / rise);
      for (int i = 0; i < columns; ++i) scenery.put({8 + i, 11}, slope(i * rise, (i + 1) * rise, true));
      scenery.fill(8 + columns, 39, 11);
      scenery.player(10, kFloor, Foot::centre, {width, 12});
      const Body body = walked(scenery.level, 1, 110);
      EXPECT_GT(body.box.x + width / 2, 8 * (8 + columns) + 10) << rise << " " << width;
      EXPECT_EQ(body.box.bottom(), kFloor - 8) << rise << " " << width;
    }
  }
}

TEST(Walk, LeadsUpIntoACorridorThatTheBodyFits) {
  for (const Foot foot : {Foot::box, Foot::centre}) {
    Scenery scenery;
    scenery.put({8, 11}, slope(0, 8));
    scenery.fill(9, 39, 11);
    scenery.fill(9, 39, 9);
    scenery.player(20, kFloor, foot);
    const Body body = walked(scenery.level, 1, 80);
    EXPECT_GT(body.box.x, 110);
    EXPECT_EQ(body.box.bottom(), kFloor - 8);
  }
}

TEST(Walk, PassesTheSideOfAHollowBelowItsSlope) {
  for (const double width : {8.0, 16.0, 17.0, 24.0, 30.0}) {
    Scenery scenery;
    for (int column = 0; column < 10; ++column) scenery.level.map.set({column, 11}, scenery.next);
    scenery.put({0, 11}, slope(6, 6));
    scenery.put({10, 11}, slope(6, 8));
    scenery.put({11, 10}, slope(0, 8));  // over an empty cell
    scenery.fill(12, 39, 10);
    scenery.fill(12, 39, 11);
    scenery.player(40 - width / 2, kFloor - 6, Foot::centre, {width, 8});
    const Body body = walked(scenery.level, 1, 60);
    EXPECT_GT(body.box.x + width / 2, 110) << width;
    EXPECT_EQ(body.box.bottom(), kFloor - 16) << width;
  }
}

TEST(Walk, PassesTheSideBelowAOneWayFloorOfManyPieces) {
  for (const double width : {8.0, 30.0, 40.0, 60.0}) {
    Scenery scenery;
    for (int column = 0; column < 4; ++column) {
      TileShape ramp{.kind = TileShape::Kind::profile, .one_way = true};
      for (int x = 0; x <= 8; ++x) ramp.heights.push_back((column * 8 + x) / 4.0);
      scenery.put({12 + column, 11}, ramp);
    }
    scenery.fill(16, 39, 11);
    scenery.player(40 - width / 2, kFloor, Foot::centre, {width, 12});
    const Body body = walked(scenery.level, 1, 80);
    EXPECT_GT(body.box.x + width / 2, 140) << width;
    EXPECT_EQ(body.box.bottom(), kFloor - 8) << width;
  }
}

TEST(Walk, LeadsThroughACorridorAlongAnAlmostLevelSlope) {
  Scenery scenery;
  const std::vector<Vec2> floor = {{96, 96}, {128, 91.8359375}, {168, 91.37109375}, {304, 91.37109375}};
  for (std::size_t i = 1; i < floor.size(); ++i) {
    const Vec2 up{-16, -8};  // the body's size
    scenery.level.curves.push_back({"", {Segment{floor[i - 1], floor[i]}}, ""});
    scenery.level.curves.push_back({"", {Segment{floor[i - 1] + up, floor[i] + up}, Curve::Faces::down}, ""});
  }
  scenery.player(40, kFloor, Foot::box, {16, 8});
  scenery.level.tuning.player.run_speed = scenery.level.tuning.player.run_gain = 2;
  const Body body = walked(scenery.level, 1, 80);
  EXPECT_GT(body.box.x, 180);
  EXPECT_EQ(body.box.y, 83.37109375);
}

TEST(Walk, FollowsTheFloorAfterAPolygonOfSeveralRows) {
  Scenery scenery;
  scenery.level.tuning.exact.steepest = 3;
  scenery.fill(0, 4, 9);
  scenery.put({5, 9}, {.kind = TileShape::Kind::polygon, .points = {{0, 0}, {8, 16}, {8, 24}, {0, 24}}});
  scenery.put({6, 11}, slope(8, 6));
  scenery.put({7, 11}, slope(6, 6));
  scenery.player(20, 72, Foot::centre, {12, 8});
  for (int steps = 14; steps < 24; ++steps) {
    const Body body = walked(scenery.level, 1, steps);
    const double middle = body.box.x + body.box.w / 2;
    if (middle > 48 && middle < 56) {
      EXPECT_NEAR(body.box.bottom(), 88 + (middle - 48) / 4, 1e-9) << middle;
    }
  }
}

TEST(Walk, StaysOnAPlateauBelowAOneWayLine) {
  for (const double speed : {0.7, 1.5, 6.0}) {
    for (double start = 20; start < 26; start += 0.5) {
      Scenery scenery;
      scenery.level.tuning.player.run_speed = speed;
      scenery.put({8, 11}, slope(0, 8));
      scenery.fill(9, 39, 11);
      for (int x = 9; x < 40; ++x) scenery.put({x, 10}, slope(1, 1, true));
      scenery.player(start, kFloor, Foot::box);
      const Body body = walked(scenery.level, 1, static_cast<int>(150 / speed));
      EXPECT_GT(body.box.x, 90);
      EXPECT_EQ(body.box.bottom(), kFloor - 8) << speed << " from " << start;
    }
  }
}

TEST(Walk, EndsAtABlockThatTheFloorDoesNotLeadOnto) {
  Scenery scenery;
  scenery.put({8, 11}, slope(0, 7, true));  // 1 px below the top of the block
  scenery.fill(9, 39, 11);
  scenery.player(20, kFloor, Foot::centre);
  EXPECT_EQ(walked(scenery.level, 1, 80).box.right(), 72);
}

TEST(Walk, EndsAtTheSideOfABlockUnderAOneWaySlope) {
  Scenery scenery;
  scenery.put({8, 10}, slope(0, 8, true));
  scenery.fill(9, 39, 10);
  scenery.fill(9, 39, 11);
  scenery.player(20, kFloor, Foot::centre);
  const Body body = walked(scenery.level, 1, 80);
  EXPECT_EQ(body.box.right(), 72);
  EXPECT_EQ(body.box.bottom(), kFloor);
}

TEST(Walk, PassesTheEndOfAFloorBelowItsLine) {
  Scenery scenery;  // a one-way slope leads down over the corner of a block
  scenery.fill(8, 9, 11);
  scenery.put({8, 10}, slope(8, 4, true));
  scenery.put({9, 10}, slope(4, 0, true));
  scenery.put({10, 11}, slope(8, 0, true));
  scenery.fill(6, 7, 10);
  scenery.fill(6, 7, 11);
  scenery.player(50, kFloor - 16, Foot::centre);
  const Body body = walked(scenery.level, 1, 60);
  EXPECT_EQ(body.box.bottom(), kFloor);
  EXPECT_GT(body.box.x, 100);
}

TEST(Walk, GoesAsFastOverEachPiece) {
  Scenery scenery;
  scenery.put({8, 11}, slope(0, 8));
  scenery.fill(9, 20, 11);
  scenery.put({21, 11}, slope(8, 0));
  scenery.player(20, kFloor, Foot::box);
  const Body body = walked(scenery.level, 1, 106);
  const double ramp = 0.25 + 0.5 + 0.75 + 1 + 1.25;  // while run_gain makes it faster
  EXPECT_DOUBLE_EQ(body.box.x, 20 + ramp + 1.5 * 101);
}

// ---- Rare meetings: a player that stands at a place takes one step ----

struct Meeting : Scenery {
  explicit Meeting(TileSize tile = {8, 8}, double speed = 1.5) {
    level.map = TileMap(24, 14, tile);
    level.tuning.player.run_speed = speed;
  }
  void sine(double x0, double x1, double middle, double amplitude, double wavelength) {
    level.curves.push_back({"", {.form = Sine{x0, x1, middle, amplitude, wavelength, x0}}, ""});
  }
  Body step(Rect box, Foot foot, int direction) {
    player(box.x, box.bottom(), foot, {box.w, box.h});
    const auto scene = std::make_shared<const Scene>(compile_scene(level));
    State state = initial_state(*scene);
    Body& body = state.bodies[0];
    body.box = box;
    body.velocity = {direction * level.tuning.player.run_speed, 0};
    body.gait.grounded = true;
    Input input;
    input.left = direction < 0;
    input.right = direction > 0;
    make_solver(scene)->step(state, input, nullptr);
    return body;
  }
};

TEST(Walk, LeadsDownIntoACorridorFromJustBeforeASlopeEnds) {
  Meeting meeting;
  for (int x = 0; x < 24; ++x) meeting.level.map.set({x, 12}, 1);
  meeting.put({8, 11}, slope(8, 0));
  meeting.fill(10, 20, 10);
  const Body body = meeting.step({64.4995, kFloor - 8.0005, 15, 8}, Foot::centre, 1);
  EXPECT_NEAR(body.box.x, 65.9995, 1e-9);
  EXPECT_EQ(body.box.bottom(), kFloor);
}

TEST(Walk, LeadsUpACorridorFromJustBeforeAJoint) {
  for (const Foot foot : {Foot::box, Foot::centre}) {
    Meeting meeting;
    const double beside = foot == Foot::box ? 8 : 4;  // px, from its x to its foot
    meeting.level.curves = {
        {"", {.form = Segment{{8, 96}, {80, 96}}}, ""},
        {"", {.form = Segment{{80, 96}, {140, 66}}}, ""},
        {"", {.form = Segment{{8, 88}, {80 - beside, 88}}, .faces = Curve::Faces::both}, ""},
        {"", {.form = Segment{{80 - beside, 88}, {140 - beside, 58}}, .faces = Curve::Faces::both}, ""}};
    const Body body = meeting.step({79.999 - beside, 88, 8, 8}, foot, 1);
    EXPECT_NEAR(body.box.x, 81.499 - beside, 1e-9);
    EXPECT_NEAR(body.box.y, 88 - 1.499 / 2, 1e-9);
  }
}

TEST(Walk, LeadsDownFromJustBeforeTheEndOfASlope) {
  for (const double before : {1e-13, 1e-12, 1e-9, 1e-6, 1e-3}) {
    Meeting meeting;
    meeting.put({8, 11}, slope(0, 8));  // to 72 px; beyond it is a gap
    const Body body = meeting.step({68 + before, 80, 8, 8}, Foot::centre, -1);
    EXPECT_NEAR(body.box.x, 66.5 + before, 1e-9) << before;
    EXPECT_NEAR(body.box.bottom(), 89.5 - before, 1e-9) << before;
  }
}

TEST(Walk, AJumpIsNotStoppedByAHollowBelowTheFloor) {
  Meeting meeting;
  meeting.fill(8, 8, 12);
  meeting.fill(10, 10, 12);
  meeting.put({8, 11}, slope(2, 2));
  meeting.put({9, 11}, slope(2, 0));  // over an empty cell
  meeting.put({10, 11}, slope(0, 4));
  meeting.player(72, kFloor, Foot::centre, {16, 8});
  const auto scene = std::make_shared<const Scene>(compile_scene(meeting.level));
  State state = initial_state(*scene);
  state.bodies[0].gait.grounded = true;
  Input input;
  input.left = input.jump = true;
  make_solver(scene)->step(state, input, nullptr);
  EXPECT_LT(state.bodies[0].box.x, 72);
  EXPECT_LT(state.bodies[0].velocity.x, 0);
}

TEST(Walk, LeadsOntoASlopeThatIsALipHigher) {
  Meeting meeting;
  meeting.put({8, 11}, slope(8, 4));  // its right side ends at 92 px
  meeting.level.curves.push_back({"", {.form = Segment{{71, 92}, {82, 92.03125}}}, ""});
  const Body body = meeting.step({72, 84 + 0.03125 / 11, 8, 8}, Foot::box, -1);
  EXPECT_NEAR(body.box.x, 70.5, 1e-9);
  EXPECT_NEAR(body.box.bottom(), 92 - 0.75, 1e-9);
}

// The end of the polygon is lower than the tiles to its left. A box lost its speed there, unless a step ended
// just there.
TEST(Walk, ASmallBoxClimbsALip) {
  for (const double size : {1, 2, 4, 7}) {
    for (const double start : {120.0, 120.37, 120.74}) {
      for (const int lip : {1, 4}) {
        SCOPED_TRACE(std::to_string(size) + ", " + std::to_string(start) + ", " + std::to_string(lip));
        Scenery scenery;
        scenery.player(start, kFloor, Foot::box, {size, size});
        const Body level = walked(scenery.level, -1, 40);
        TileShape polygon{.kind = TileShape::Kind::polygon};
        polygon.points = {{0, lip / 256.0 * 8 / (8 - size)}, {8, 0}, {8, 8}, {0, 8}};
        scenery.put({12, 12}, polygon);
        const Body body = walked(scenery.level, -1, 40);
        EXPECT_NEAR(body.box.x, lip == 1 ? level.box.x : 96, 1e-9) << "a higher edge stops it";
      }
    }
  }
}

// From just as far before the slope as a cast forgives, the middle of the body met the level floor once more,
// which led the body on through the air for a step.
TEST(Walk, LeavesALevelFloorFromJustBeforeItsEnd) {
  for (const int direction : {1, -1}) {
    Scenery scenery;
    const bool right = direction > 0;
    const int first = right ? 16 : 15;
    scenery.put({first, 11}, right ? slope(8, 4) : slope(4, 8));
    scenery.put({first + direction, 11}, right ? slope(4, 0) : slope(0, 4));
    for (int i = 1; i < 8; ++i) scenery.put({first - i * direction, 11}, slope(8, 8));
    for (int ulps = 0; ulps <= 40; ++ulps) {
      SCOPED_TRACE(std::to_string(direction) + ", " + std::to_string(ulps));
      scenery.level.spawns.clear();
      scenery.player(124 - direction * ulps * 0x1p-46, kFloor - 8, Foot::centre);
      const Body body = walked(scenery.level, direction, 1);
      EXPECT_NEAR(body.box.bottom(), kFloor - 8 + std::abs(body.box.x - 124) / 2, 1e-9);
    }
  }
}

// An edge of two lips stopped a box for a step, on its way to the left alone.
TEST(Walk, ABoxPassesAnEdgeOfTwoLipsBothWays) {
  for (const int direction : {1, -1}) {
    for (const double start : {152.0, 152.37, 152.74, 153.25}) {
      SCOPED_TRACE(std::to_string(direction) + ", " + std::to_string(start));
      Scenery scenery;
      scenery.player(start, kFloor, Foot::box);
      const Body level = walked(scenery.level, direction, 40);
      for (int x = 16; x < 23; ++x) {
        if (x == 16) scenery.put({x, 12}, slope(8 - 2 / 256.0, 8 - 2 / 256.0));
        if (x != 16) scenery.level.map.set({x, 12}, 2);
      }
      const Body body = walked(scenery.level, direction, 40);
      EXPECT_NEAR(body.box.x, level.box.x, 1e-9);
      EXPECT_EQ(body.box.bottom(), kFloor);
    }
  }
}

// A one-way ramp has no side: a box went under it, and fell where the floor below ended.
TEST(Walk, ABoxGoesUpAOneWayRampThatBeginsALipHigher) {
  for (const int direction : {1, -1}) {
    for (const double rise : {2.0, 8.0}) {
      for (const double width : {2.0, 8.0, 15.0}) {
        SCOPED_TRACE(std::to_string(direction) + ", " + std::to_string(rise) + ", " + std::to_string(width));
        Scenery scenery;
        for (int i = 0; i < 4; ++i) {
          const double low = i == 0 ? 1 / 256.0 : 0;
          const TileShape up = direction > 0 ? slope(low, rise, true) : slope(rise, low, true);
          if (i == 0) scenery.put({20, 11}, up);
          if (i > 0) scenery.put({20 + i * direction, 11}, slope(rise, rise, true));
          scenery.level.map.set({20 + i * direction, 12}, 0);
        }
        const double begin = direction > 0 ? 160 : 168;
        scenery.player(begin - 20 * direction - width / 2, kFloor, Foot::box, {width, 8});
        const Body body = walked(scenery.level, direction, 24);
        EXPECT_EQ(body.box.bottom(), kFloor - rise);
      }
    }
  }
}

// Two polygons that were meant to touch may be as far apart as their points are rounded.
TEST(Walk, ABodyOnItsCentreGoesOverAGapOfALip) {
  const double lip = 1.0 / kWeldParts;
  for (const int direction : {1, -1}) {
    Scenery scenery;
    const bool right = direction > 0;
    const auto x = [&](double at) { return right ? at : 8 - at; };
    scenery.put({right ? 10 : 29, 11}, {.kind = TileShape::Kind::polygon,
                                        .points = {{x(0), 8}, {x(8 - lip), lip}, {x(8 - lip), 8}}});
    scenery.put({right ? 11 : 28, 10}, right ? slope(0, 8) : slope(8, 0));
    scenery.fill(right ? 11 : 8, right ? 31 : 28, 11);
    scenery.fill(right ? 12 : 8, right ? 31 : 27, 10);
    scenery.player(right ? 60 : 252, kFloor, Foot::centre);
    const Body body = walked(scenery.level, direction, 60);
    EXPECT_EQ(body.box.bottom(), 80) << direction;
    EXPECT_GT((body.box.x - 160) * direction, -40) << direction;
  }
}

TEST(Walk, StaysOnItsFloorWhereACeilingKeepsItFromTheNextOne) {
  Meeting meeting;
  for (int x = 0; x < 24; ++x) meeting.level.map.set({x, 12}, 1);
  meeting.fill(8, 20, 10);
  meeting.level.curves.push_back({"", {.form = Segment{{60, 100}, {84, 92}}}, ""});
  const Body body = meeting.step({63.9985, kFloor - 8, 8, 8}, Foot::box, 1);
  EXPECT_EQ(body.box.bottom(), kFloor);
}

TEST(Walk, FollowsTheHigherOneOfTwoFloorsThatCross) {
  Meeting meeting({16, 16}, 3);
  meeting.put({17, 7}, slope(8, 4));
  meeting.sine(237, 349, 130, 8, 56);
  const Body body = meeting.step({280.37, 106.0925, 16, 16}, Foot::box, 1);
  EXPECT_GT(body.box.x, 283);
}

TEST(Walk, StaysOnACurveAboveAnotherFloor) {
  Meeting meeting({24, 24}, 4.5);
  meeting.put({11, 3}, {.kind = TileShape::Kind::profile, .heights = {12, 18.75, 0}});
  meeting.sine(237, 343, 89, 12, 53);
  const Body body = meeting.step({270.74, 53.0000084, 12, 24}, Foot::centre, -1);
  const double turns = (body.box.x + 6 - 237) / 53;
  EXPECT_NEAR(body.box.bottom(), 89 + 12 * std::sin(turns * 2 * std::acos(-1)), 1e-6);
  EXPECT_LT(body.box.x, 268);
}

// The chord of its way along the curve begins below the slope.
TEST(Walk, StaysOnACurveThatCrossesASlopeFurtherOn) {
  Meeting meeting({16, 16}, 10);
  meeting.put({17, 4}, slope(0, 14.77734375));
  meeting.sine(200.26953125, 290.51171875, 79.50390625, 8.232740332591675, 21.69099238395499);
  const Body body = meeting.step({278, 30.76416015625, 4, 40}, Foot::box, -1);
  EXPECT_LT(body.box.x, 270);
}

TEST(Walk, PassesAWallBelowOneOfTwoFloorsThatCrossAtItsFoot) {
  Meeting meeting({16, 16}, 3);
  meeting.put({18, 6}, slope(12, 12));
  meeting.put({19, 6}, slope(12, 4, true));
  meeting.put({20, 6}, slope(4, 4));
  meeting.sine(265, 350, 110, 8, 74);  // its line is 0.005 px above the foot
  const Body body = meeting.step({304, 88, 16, 16}, Foot::centre, -1);
  EXPECT_NEAR(body.box.x, 301, 1e-9);
  EXPECT_NEAR(body.box.bottom(), 104 - 1.5, 1e-9);
}

TEST(Walk, FliesOnBelowACeilingFromTheEndOfARamp) {
  Meeting meeting;
  meeting.level.tuning.exact.steepest = 0.75;
  meeting.put({8, 11}, slope(0, 4));
  meeting.put({9, 11}, {.kind = TileShape::Kind::profile, .heights = {4, 0, 0}});
  for (int x = 8; x < 12; ++x)
    meeting.put({x, 10},
                {.kind = TileShape::Kind::slope, .side = TileShape::Side::ceiling, .heights = {4, 4}});
  EXPECT_NEAR(meeting.step({67, 84.5, 8, 8}, Foot::centre, 1).box.x, 68.5, 1e-9);
}

TEST(Walk, PassesTheUndersideOfTheHillThatItWalksOn) {
  Meeting meeting;
  meeting.put({9, 11}, slope(8, 0, true));
  meeting.put({8, 10}, slope(8, 0));
  EXPECT_NEAR(meeting.step({69, 88, 14, 4}, Foot::centre, -1).box.x, 67.5, 1e-9);
}

// Its far side stops bodies from below, too, and the front of a wide body is under it before the middle is at
// the crest.
TEST(Walk, PassesTheCrestOfARoofThatIsALine) {
  constexpr double kHalf = 32;  // px, of the roof's width
  for (const double rise : {1.0, 1.5, 1.7, 2.0}) {
    for (const Vec2 size : {Vec2{8, 8}, Vec2{10, 8}, Vec2{12, 7}, Vec2{16, 8}, Vec2{16, 16}}) {
      for (const int direction : {1, -1}) {
        Scenery scenery;
        const Vec2 crest{160, kFloor - rise * kHalf};
        for (const double side : {-1.0, 1.0}) {
          Segment line{{crest.x - kHalf, kFloor}, crest};
          if (side > 0) line = {crest, {crest.x + kHalf, kFloor}};
          scenery.level.curves.push_back({"", {line, Curve::Faces::both}, ""});
        }
        const double start = crest.x - direction * (kHalf + 20);
        scenery.player(start - size.x / 2, kFloor, Foot::centre, size);
        const Body body = walked(scenery.level, direction, 64);
        EXPECT_NEAR(body.box.x + size.x / 2, start + direction * 96, 4)
            << rise << " " << size.x << "x" << size.y;
      }
    }
  }
}

TEST(Walk, PassesTheCrestOfAWaveThatIsALine) {
  for (const Vec2 size : {Vec2{8, 8}, Vec2{16, 8}, Vec2{24, 6}}) {
    Scenery scenery;
    scenery.level.curves.push_back({"", {Sine{100, 300, kFloor - 20, 18, 60, 115}, Curve::Faces::both}, ""});
    scenery.player(40, kFloor - 40, Foot::centre, size);
    scenery.level.spawns[0].position.x = 150 - size.x / 2;
    const auto scene = std::make_shared<const Scene>(compile_scene(scenery.level));
    const auto solver = make_solver(scene);
    State state = initial_state(*scene);
    Input input;
    for (int i = 0; i < 120; ++i) {
      input.right = i > 40;
      solver->step(state, input, nullptr);
    }
    EXPECT_GT(state.bodies[0].box.x, 220) << size.x;
  }
}

// Walks over curves that are one floor from x = 60 to 156 px; y_at gives its height. Each step must keep the
// speed, and leave the body with its middle on the floor.
template <class F>
void expect_to_follow(const Level& level, int direction, F y_at, const std::string& name) {
  const auto scene = std::make_shared<const Scene>(compile_scene(level));
  const auto solver = make_solver(scene);
  State state = initial_state(*scene);
  Body& body = state.bodies[0];
  const auto middle = [&] { return body.box.x + body.box.w / 2; };
  const double start = direction > 0 ? 64 : 152;
  body.box.x = start - body.box.w / 2;
  body.box.y = y_at(start) - body.box.h;
  body.gait.grounded = true;
  for (double from = middle(); from > 62 && from < 154; from = middle()) {
    Input input;
    input.left = direction < 0;
    input.right = direction > 0;
    const double speed = std::min(std::abs(body.velocity.x) + 0.25, 1.5);
    solver->step(state, input, nullptr);
    ASSERT_NEAR((middle() - from) * direction, speed, 0.01) << name << " at " << from;
    ASSERT_NEAR(body.box.bottom(), y_at(middle()), 0.01) << name << " at " << from;
  }
}

TEST(Walk, FollowsLinesWhoseEndsAreAlmostAtOnePlace) {
  for (const Curve::Faces faces : {Curve::Faces::up, Curve::Faces::both}) {
    for (const double apart : {-1.0 / 256, 0.0, 1.0 / 256}) {
      for (const double end : {62, 70, 78}) {
        Scenery scenery;
        scenery.level.tuning.player.surface_speed = 0;
        scenery.level.curves = {{"", {Segment{{60, 78}, {100, 70}}, faces}, ""},
                                {"", {Segment{{100, 70 + apart}, {160, end + apart}}, faces}, ""}};
        scenery.player(64, kFloor, Foot::centre);
        const auto y_at = [&](double x) {
          return x < 100 ? 78 - (x - 60) / 5 : 70 + (end - 70) * (x - 100) / 60;
        };
        for (const int direction : {-1, 1})
          expect_to_follow(scenery.level, direction, y_at, std::to_string(apart) + " " + std::to_string(end));
      }
    }
  }
}

// The arc meets both lines between two heights of the grid of ends, and its centre and radius are beside the
// grid.
TEST(Walk, FollowsAnArcBetweenLines) {
  for (const Curve::Faces faces : {Curve::Faces::up, Curve::Faces::both}) {
    for (const double radius : {30.003, 54.0, 200.0017}) {
      for (const double lean : {-8.0, 0.0, 8.003}) {
        const Arc arc{{108 + lean, 80 + radius}, radius, 100, 116.003, true};
        const auto arc_y = [&](double x) {
          return arc.center.y - std::sqrt(radius * radius - (x - arc.center.x) * (x - arc.center.x));
        };
        const double y0 = arc_y(arc.x0), y1 = arc_y(arc.x1);
        Scenery scenery;
        scenery.level.tuning.player.surface_speed = 0;
        scenery.level.curves = {{"", {Segment{{60, y0 + 8}, {100, y0}}, faces}, ""},
                                {"", {arc, faces}, ""},
                                {"", {Segment{{116.003, y1}, {160, y1 + 4}}, faces}, ""}};
        scenery.player(64, kFloor, Foot::centre);
        const auto y_at = [&](double x) {
          if (x < arc.x0) return y0 + 8 - (x - 60) / 5;
          return x < arc.x1 ? arc_y(x) : y1 + 4 * (x - arc.x1) / (160 - arc.x1);
        };
        for (const int direction : {-1, 1})
          expect_to_follow(scenery.level, direction, y_at,
                           std::to_string(radius) + " " + std::to_string(lean));
      }
    }
  }
}

// It comes to rest on two crests at once, and each of them seems to be in the way of the other by rounding.
TEST(Walk, LeavesTwoCrestsOfAWaveOnWhichItStands) {
  for (double wave = 5; wave < 25; wave += 0.93) {
    for (const double speed : {1.5, 9.0}) {
      for (const Foot foot : {Foot::box, Foot::centre}) {
        Scenery scenery;
        scenery.level.curves.push_back({"", {Sine{40, 300, 60, 0.65, wave, 41.37}, Curve::Faces::both}, ""});
        scenery.level.tuning.player.run_speed = scenery.level.tuning.player.run_gain = speed;
        scenery.player(200, 50, foot, {24, 6});
        const auto scene = std::make_shared<const Scene>(compile_scene(scenery.level));
        const auto solver = make_solver(scene);
        State state = initial_state(*scene);
        Input input;
        for (double moved = 0; moved < 180; moved += speed) {
          input.left = moved > 40;
          solver->step(state, input, nullptr);
        }
        EXPECT_LT(state.bodies[0].box.x, 120) << wave << " " << speed;
      }
    }
  }
}

// The players of a level after so many steps in a direction. They do not meet.
std::vector<Body> all_walked(Level level, int direction, int steps) {
  level.tuning.shared.bodies = 0;
  const auto scene = std::make_shared<const Scene>(compile_scene(level));
  const auto solver = make_solver(scene);
  State state = initial_state(*scene);
  Input input;
  input.left = direction < 0;
  input.right = direction > 0;
  for (int i = 0; i < steps; ++i) solver->step(state, input, nullptr);
  return state.bodies;
}

// By rounding, some came to the end of a step just behind a wall or a ceiling, and went on through it.
TEST(Walk, EndsAtAWallOrALowCeilingAfterAnyNumberOfSteps) {
  for (const double speed : {0.1, 0.9, 1.1, 1.9}) {
    for (const Foot foot : {Foot::box, Foot::centre}) {
      for (const bool is_ceiling : {false, true}) {
        Scenery scenery;
        scenery.level.tuning.player.run_speed = speed;
        for (int x = 3; x <= 36; x += 33) {
          if (is_ceiling)
            scenery.put({x, 10}, {.kind = TileShape::Kind::solid});
          else
            scenery.fill(x, x, 11);
        }
        for (int i = 0; i < 40; ++i) {
          scenery.player(33 + i, kFloor, foot, {8, 10});
          scenery.player(279 - i, kFloor, foot, {8, 10});
        }
        const int steps = static_cast<int>(60 / speed);
        for (const Body& body : all_walked(scenery.level, -1, steps)) EXPECT_GE(body.box.x, 32 - 1e-9);
        for (const Body& body : all_walked(scenery.level, 1, steps)) EXPECT_LE(body.box.x, 280 + 1e-9);
      }
    }
  }
}

// The floor is a wave that goes through the underside of a tile, beside which there is another tile.
TEST(Walk, EndsBelowACeilingThatItsFloorGoesInto) {
  for (const double speed : {0.3, 0.5, 1.5}) {
    Scenery scenery;
    scenery.level.map = TileMap(40, 14);
    scenery.fill(5, 5, 12);
    scenery.put({4, 12}, slope(4, 0));
    scenery.level.curves = {{"", {Sine{16.5, 53.75, 105.75, 2, 29, 16.5}, Curve::Faces::both}, ""}};
    scenery.level.tuning.player.run_speed = scenery.level.tuning.player.run_gain = speed;
    scenery.player(42, 104, Foot::centre, {14, 1});
    for (const Body& body : all_walked(scenery.level, -1, 100)) EXPECT_EQ(body.box.y, 104);
  }
}

// The slope begins 1/256 px above the floor, under a ceiling that leaves no room for that.
TEST(Walk, GoesBackFromAnEdgeBelowALowCeiling) {
  for (const bool one_way : {false, true}) {
    Scenery scenery;
    scenery.put({9, 11}, slope(0.00390625, 8, one_way));
    scenery.fill(2, 13, 9);
    scenery.player(40, kFloor, Foot::centre, {8, 16});
    const auto scene = std::make_shared<const Scene>(compile_scene(scenery.level));
    const auto solver = make_solver(scene);
    State state = initial_state(*scene);
    Input right, left;
    right.right = left.left = true;
    for (int i = 0; i < 60; ++i) solver->step(state, right, nullptr);
    EXPECT_EQ(state.bodies[0].box.x, 68) << one_way;
    for (int i = 0; i < 30; ++i) solver->step(state, left, nullptr);
    EXPECT_LT(state.bodies[0].box.x, 40) << one_way;
  }
}

TEST(Walk, DoesNotStandOnASeamOfAWall) {
  Meeting meeting;
  meeting.put({9, 10}, {.kind = TileShape::Kind::slope, .side = TileShape::Side::ceiling, .heights = {8, 5}});
  meeting.fill(9, 9, 11);
  meeting.player(64, 88, Foot::box);
  const auto scene = std::make_shared<const Scene>(compile_scene(meeting.level));
  State state = initial_state(*scene);
  Body& body = state.bodies[0];
  body.box.y = 80;
  body.velocity = {0, 2.5};
  Input input;
  input.right = true;
  make_solver(scene)->step(state, input, nullptr);
  EXPECT_FALSE(body.gait.grounded);
  EXPECT_GT(body.box.y, 82);
}

}  // namespace talus::walk_test
