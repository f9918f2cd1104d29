// Proofs of whole levels: faults that are planted are found, and nothing else is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <utility>

#include <talus/formats/format.h>
#include "paths.h"
#include "prove/proof.h"

namespace talus::prove_test {

// A floor in row 12, and a player of 8x8 px.
struct Scenery {
  explicit Scenery(Foot foot = Foot::centre) {
    level.map = TileMap(24, 14);
    level.tile_shapes[1].kind = TileShape::Kind::solid;
    for (int x = 0; x < 24; ++x) level.map.set({x, 12}, 1);
    Spawn player;
    player.kind = BodyKind::player;
    player.foot = foot;
    player.position = {16, 80};
    level.spawns = {player};
  }
  void put(Cell cell, TileShape shape) {
    level.tile_shapes[next] = std::move(shape);
    level.map.set(cell, next++);
  }
  Proof proof(int threads = 1) const { return *prove(ProveScene(level, {}), threads); }
  Level level;
  TileNumber next = 2;
};

TileShape slope(double left, double right, bool one_way = false) {
  return {.kind = TileShape::Kind::slope, .one_way = one_way, .heights = {left, right}};
}

std::set<std::string> kinds_of(const Proof& proof) {
  std::set<std::string> kinds;
  for (const Finding& finding : proof.findings) kinds.insert(std::string(info_of(finding.kind).word));
  return kinds;
}

std::string text_of(const Proof& proof) {
  std::string text;
  for (const Finding& finding : proof.findings) text += message_of(finding) + "\n";
  return text;
}

TEST(Prove, FindsNothingOnAGoodHill) {
  for (const Foot foot : {Foot::box, Foot::centre}) {
    Scenery good(foot);
    good.put({8, 11}, slope(0, 4));
    good.put({9, 11}, slope(4, 8, true));
    good.level.map.set({10, 11}, 1);
    good.put({11, 11}, slope(8, 0));
    const Proof proof = good.proof();
    EXPECT_EQ(text_of(proof), "");
    EXPECT_GT(proof.counts.places, 20);
    EXPECT_GT(proof.counts.steps, 1000);
    EXPECT_THAT(summary_of(proof), testing::HasSubstr("no finding"));
  }
}

TEST(Prove, AnswersForAGravityOfAlmostNothing) {
  for (const double gravity : {1e-12, 1e-100, 1e-300}) {
    Scenery flat;
    flat.level.tuning.player.gravity = gravity;
    EXPECT_EQ(text_of(flat.proof()), "") << gravity;
  }
}

struct Planted {
  const char* what;
  std::vector<TileShape> shapes;  // in row 11, from column 8 on
  const char* found;
  int column;  // of the higher ground
};

TEST(Prove, FindsPlantedEdges) {
  const Planted all[] = {
      {"two slopes that do not meet", {slope(0, 4), slope(4.5, 8)}, "lip", 9},
      {"a one-way slope below a block", {slope(0, 7, true), slope(8, 8)}, "lip", 9},
      {"a plate on the floor", {slope(0.25, 0.25)}, "lip", 8},
      {"a profile with a jump", {{.kind = TileShape::Kind::profile, .heights = {1, 1, 1}}}, "lip", 8},
      {"a polygon with an edge",
       {{.kind = TileShape::Kind::polygon, .points = {{0, 7}, {8, 3}, {8, 8}, {0, 8}}}},
       "lip",
       8},
  };
  for (const Planted& planted : all) {
    SCOPED_TRACE(planted.what);
    Scenery scenery;
    for (std::size_t i = 0; i < planted.shapes.size(); ++i)
      scenery.put({8 + static_cast<int>(i), 11}, planted.shapes[i]);
    const Proof proof = scenery.proof();
    EXPECT_EQ(kinds_of(proof), std::set<std::string>{planted.found}) << text_of(proof);
    for (const Finding& finding : proof.findings) {
      EXPECT_EQ(finding.cell, (Cell{planted.column, 11})) << message_of(finding);
      EXPECT_EQ(std::fmod(finding.place.x, 8), 0) << "at the side of that cell";
    }
  }
}

TileShape polygon(std::vector<Vec2> points) {
  return {.kind = TileShape::Kind::polygon, .points = std::move(points), .parts = {}};
}

// Each holds a body or leads it below the ramp that it was meant to walk up.
TEST(Prove, FindsEdgesOfOtherForms) {
  const Planted all[] = {
      {"a low edge that is not upright", {polygon({{0, 8}, {0.05, 7}, {8, 7}, {8, 8}})}, "lip", 8},
      {"a lower one", {polygon({{0, 8}, {0.01, 7.75}, {8, 7.75}, {8, 8}})}, "lip", 8},
      {"a one-way ramp that begins above the floor",
       {slope(0.25, 8, true), {.kind = TileShape::Kind::solid}},
       "lip",
       8},
      {"one that begins just above it", {slope(0.02, 8, true), {.kind = TileShape::Kind::solid}}, "lip", 8},
  };
  struct Tried {
    BodyKind kind;
    Foot foot;
  };
  constexpr Tried kTried[] = {{BodyKind::player, Foot::box},
                              {BodyKind::player, Foot::centre},
                              {BodyKind::ball, Foot::box},
                              {BodyKind::ball, Foot::centre}};
  for (const Planted& planted : all) {
    for (const auto [kind, foot] : kTried) {
      SCOPED_TRACE(std::string(planted.what) + " before a " + std::string(traits_of(kind).word));
      Scenery scenery;
      scenery.level.spawns[0].kind = kind;
      scenery.level.spawns[0].foot = foot;
      for (std::size_t i = 0; i < planted.shapes.size(); ++i)
        scenery.put({8 + static_cast<int>(i), 11}, planted.shapes[i]);
      const Proof proof = scenery.proof();
      EXPECT_EQ(kinds_of(proof), std::set<std::string>{planted.found}) << text_of(proof);
    }
  }
}

// The floor stops a slow one before it comes to the next cell.
TEST(Prove, FindsEdgesBeforeSmallBalls) {
  for (const int tile : {8, 16, 24}) {
    Level level;
    level.map = TileMap(24, 8, {tile, tile});
    level.tile_shapes[1].kind = TileShape::Kind::solid;
    level.tile_shapes[2] = slope(tile - tile / 8.0, tile - tile / 8.0);
    for (int x = 0; x < 24; ++x) level.map.set({x, 4}, x < 12 ? 1 : 2);
    for (const double size : {2, 3, 4, 6, 8}) {
      for (const Foot foot : {Foot::box, Foot::centre}) {
        const ProveBody ball{.kind = BodyKind::ball, .size = {size, size}, .foot = foot};
        const Proof proof = *prove(ProveScene(level, {.bodies = {ball}}), 1);
        EXPECT_EQ(kinds_of(proof), std::set<std::string>{"lip"}) << tile << ", " << size;
      }
    }
  }
}

// The end of a line that stops bodies from both sides.
TEST(Prove, FindsTheEndOfALineJustAboveTheFloor) {
  for (const Foot foot : {Foot::box, Foot::centre}) {
    Scenery scenery;
    scenery.level.spawns[0].foot = foot;
    scenery.level.curves.push_back({"", {Segment{{64, 95}, {80, 95}}, Curve::Faces::both}, ""});
    const Proof proof = scenery.proof();
    EXPECT_EQ(kinds_of(proof), std::set<std::string>{"lip"}) << text_of(proof);
  }
}

// The body goes under it, as it has no side, and falls where its own floor ends.
TEST(Prove, FindsAOneWayFloorThatGoesOnHigher) {
  for (const Foot foot : {Foot::box, Foot::centre}) {
    Scenery scenery(foot);
    for (int x = 0; x < 24; ++x) scenery.level.map.set({x, 12}, 0);
    scenery.level.curves = {{"", {Segment{{0, 96}, {100, 96}}, Curve::Faces::up}, ""},
                            {"", {Segment{{100, 95.75}, {192, 95.75}}, Curve::Faces::up}, ""}};
    const Proof proof = scenery.proof();
    ASSERT_EQ(kinds_of(proof), std::set<std::string>{"lip"}) << text_of(proof);
    EXPECT_EQ(proof.findings[0].amount, 0.25);
  }
}

TEST(Prove, HasNoFindingBesideAWallOfManyParts) {
  Scenery scenery(Foot::box);
  scenery.put({8, 8}, slope(0.5, 0.5));
  for (int y = 9; y < 12; ++y) scenery.level.map.set({8, y}, 1);
  EXPECT_EQ(scenery.proof().findings.size(), 0u) << text_of(scenery.proof());
}

TEST(Prove, HasNoFindingWhereAShapeLeavesTheMap) {
  Scenery scenery(Foot::box);
  TileShape wide = slope(0, 8);
  wide.tiles = 2;
  scenery.put({23, 11}, wide);
  EXPECT_EQ(scenery.proof().findings.size(), 0u) << text_of(scenery.proof());
}

// The line of a ramp leads onto a plate; below the line there is no place to begin.
TEST(Prove, HasNoFindingUnderAOneWayRamp) {
  Scenery scenery;
  scenery.put({8, 11}, slope(0, 2, true));
  scenery.put({9, 11}, slope(2, 2));
  scenery.put({10, 11}, slope(2, 0));
  EXPECT_EQ(scenery.proof().findings.size(), 0u) << text_of(scenery.proof());
}

// It begins at the left end, not where it dips behind the body's head.
TEST(Prove, HasNoFindingUnderAOneWayLineThatDips) {
  Scenery scenery;
  scenery.level.map = TileMap(20, 6, {24, 24});
  for (int x = 0; x < 20; ++x) scenery.level.map.set({x, 5}, 1);
  scenery.level.curves = {{"", {Polyline{100, 164, {120, 108, 117, 108, 120}}, Curve::Faces::up}, ""}};
  scenery.level.spawns[0].size = {3, 5};
  scenery.level.spawns[0].position = {40, 100};
  scenery.level.tuning.player.run_speed = 9;
  EXPECT_EQ(scenery.proof().findings.size(), 0u) << text_of(scenery.proof());
}

// A pit as wide as the body, and a wall behind it: the floor ends where the body's last corner is.
TEST(Prove, FallsIntoAPitBesideAWall) {
  Scenery scenery(Foot::box);
  scenery.level.map = TileMap(24, 17);
  for (int y = 12; y < 17; ++y)
    for (int x = 0; x < 24; ++x)
      if (x != 10 || y == 16) scenery.level.map.set({x, y}, 1);
  scenery.level.map.set({11, 11}, 1);
  scenery.level.map.set({11, 10}, 1);
  scenery.level.tuning.player.run_speed = 4;
  EXPECT_EQ(scenery.proof().of_solver, 0u) << text_of(scenery.proof());
}

TEST(Prove, FindsAnEdgeHigherThanASmallBody) {
  Scenery scenery;
  scenery.level.map = TileMap(20, 6, {24, 24});
  for (int x = 0; x < 20; ++x) scenery.level.map.set({x, 5}, 1);
  scenery.put({8, 4}, slope(6, 6));
  scenery.level.spawns[0].size = {3, 5};
  scenery.level.spawns[0].position = {40, 100};
  const Proof proof = scenery.proof();
  EXPECT_EQ(kinds_of(proof), std::set<std::string>{"lip"}) << text_of(proof);
}

TEST(Prove, ABodyThatSlidesDownACliffIsNotStopped) {
  for (const double steepness : {2.1, 2.5, 3.0, 4.0}) {
    Scenery scenery(Foot::box);
    TileShape cliff{.kind = TileShape::Kind::polygon};
    cliff.points = {{0, 0}, {4, 0}, {4 + 40 / steepness, 40}, {0, 40}};
    scenery.put({8, 7}, cliff);
    for (int x = 0; x < 8; ++x) scenery.level.map.set({x, 7}, 1);
    for (const Vec2 size : {Vec2{8, 8}, Vec2{10, 15}}) {
      scenery.level.spawns[0].size = size;
      const Proof proof = scenery.proof();
      EXPECT_TRUE(proof.findings.empty()) << steepness << ": " << text_of(proof);
    }
  }
}

TEST(Prove, MeasuresABevelledEdgeToItsTop) {
  Scenery scenery(Foot::box);
  TileShape edge{.kind = TileShape::Kind::polygon};
  edge.points = {{0, 8}, {0.3125, 6.75}, {8, 6.75}, {8, 8}};  // 4 px for each px, then level
  scenery.put({8, 11}, edge);
  const Proof proof = scenery.proof();
  EXPECT_EQ(kinds_of(proof), std::set<std::string>{"lip"}) << text_of(proof);
  const auto bevel = std::find_if(proof.findings.begin(), proof.findings.end(),
                                  [](const Finding& finding) { return finding.place.x < 68; });
  ASSERT_NE(bevel, proof.findings.end()) << text_of(proof);
  EXPECT_NEAR(bevel->amount, 1.25, 0.02) << text_of(proof);
  EXPECT_NEAR(bevel->place.x, 64.3125, 0.02);
  EXPECT_NEAR(bevel->place.y, 94.75, 0.02);
}

TEST(Prove, FindsWhereABodyIsWedged) {
  Scenery scenery;
  scenery.level.tuning.exact.steepest = 1;
  scenery.level.tuning.player.jump_speed = 1;
  scenery.put({8, 11}, slope(24, 0));
  scenery.put({9, 11}, slope(0, 24));
  EXPECT_EQ(kinds_of(scenery.proof()), std::set<std::string>{"wedged"}) << text_of(scenery.proof());
}

// Nothing leads there: a body can only fall into it.
TEST(Prove, FindsAFunnelThatHoldsABody) {
  Scenery scenery;
  scenery.level.map = TileMap(24, 14);
  scenery.put({8, 8}, slope(19, 0));
  scenery.put({9, 8}, slope(0, 26));
  EXPECT_TRUE(scenery.proof().findings.empty()) << "a jump leads out";
  scenery.level.tuning.player.jump_speed = 1;
  const Proof proof = scenery.proof();
  EXPECT_EQ(kinds_of(proof), std::set<std::string>{"wedged"}) << text_of(proof);
  EXPECT_EQ(proof.counts.places, 0) << "nobody can walk there";
}

// There is no room for the body above its ground, and just a little more further up.
TEST(Prove, FindsACleftThatHoldsABody) {
  const auto put_cleft = [](int depth) {
    const double y = 8.0 * depth;
    Scenery scenery(Foot::box);
    scenery.put({9, 12 - depth}, {.kind = TileShape::Kind::polygon, .points = {{0, 0}, {8, y}, {0, y}}});
    scenery.put({10, 12 - depth}, {.kind = TileShape::Kind::polygon, .points = {{8, 0}, {8, y}, {0, y}}});
    return scenery.proof();
  };
  EXPECT_EQ(kinds_of(put_cleft(9)), std::set<std::string>{"wedged"});
  EXPECT_EQ(kinds_of(put_cleft(8)), std::set<std::string>()) << "a long jump to the side leads out";
}

// A body on its centre steps off the end of a ramp, and comes below the ramp behind the gap.
TEST(Prove, FindsAGapInASlope) {
  for (const double gap : {5, 7, 12}) {
    SCOPED_TRACE(gap);
    Scenery scenery;
    const auto add = [&](double from, double to) {
      const auto y_at = [](double x) { return 96 - (x - 48) / 4; };
      scenery.level.curves.push_back(
          {"", {Segment{{from, y_at(from)}, {to, y_at(to)}}, Curve::Faces::up}, ""});
    };
    add(48, 84);
    add(84 + gap, 144);
    const Proof proof = scenery.proof();
    const bool is_narrow = gap < scenery.level.spawns[0].size.x;
    EXPECT_EQ(kinds_of(proof), is_narrow ? std::set<std::string>{"gap"} : std::set<std::string>())
        << text_of(proof);
    for (const Finding& finding : proof.findings) {
      EXPECT_NEAR(finding.amount, gap, 0.01) << message_of(finding);
      EXPECT_EQ(finding.place, (Vec2{84, 87}));
    }
  }
}

// A level of cells of 8x8 px without ground.
Level empty_level() {
  Level level;
  level.map = TileMap(24, 20);
  level.tile_shapes[1].kind = TileShape::Kind::solid;
  return level;
}

std::string text_of(const Level& level, const ProveBody& body) {
  return text_of(*prove(ProveScene(level, {.bodies = {body}}), 1));
}

// Ends that are 1/256 px apart count as one for balls, too.
TEST(Prove, BallsRollOverTheSmallestEdge) {
  Level level = empty_level();
  level.tile_shapes[2] = slope(3, 0.00390625);
  level.map.set({9, 6}, 2);
  for (int x = 10; x < 14; ++x) level.map.set({x, 7}, 1);
  for (const Foot foot : {Foot::box, Foot::centre})
    EXPECT_EQ(text_of(level, {.kind = BodyKind::ball, .size = {12, 20}, .foot = foot}), "");
}

// A ball that bounces meets the edge above its floor.
TEST(Prove, MeasuresAnEdgeFromTheFloorOfABouncingBall) {
  for (const bool mirrored : {false, true}) {
    Level level = empty_level();
    level.tile_shapes[2] = mirrored ? slope(1.8984375, 0) : slope(0, 1.8984375);
    level.tile_shapes[3] = mirrored ? slope(8, 4) : slope(4, 8);
    for (int x = 0; x < 24; ++x) level.map.set({x, 9}, 1);
    level.map.set({13, 8}, mirrored ? 3 : 2);
    level.map.set({14, 8}, mirrored ? 2 : 3);
    EXPECT_EQ(text_of(level, {.kind = BodyKind::ball, .size = {8, 8}, .foot = Foot::box}), "");
  }
}

// A body on its centre comes to a ceiling that falls with the floor, before its middle does.
TEST(Prove, ALowCeilingIsNoEdge) {
  Level level;
  level.map = TileMap(6, 12, {18, 12});
  level.tile_shapes[2] = slope(6, 12);
  level.tile_shapes[1].kind = TileShape::Kind::solid;
  level.tile_shapes[3] = {
      .kind = TileShape::Kind::slope, .side = TileShape::Side::ceiling, .heights = {9, 3}};
  level.map.set({1, 9}, 2);
  level.map.set({2, 9}, 1);
  level.map.set({3, 9}, 1);
  level.map.set({1, 7}, 3);
  EXPECT_EQ(text_of(level, {.size = {18, 20}, .foot = Foot::centre}), "");
}

TEST(Prove, FindsWhatTheArticleDoes) {
  Scenery scenery;
  scenery.level.tuning.solver = SolverKind::article;
  scenery.level.spawns[0].kind = BodyKind::ball;
  scenery.level.spawns[0].foot = Foot::box;
  scenery.put({8, 11}, slope(0, 8));
  const Proof proof = scenery.proof();
  EXPECT_GT(proof.of_solver, 0u) << "it rounds floors, and sinks into slopes";
  EXPECT_EQ(proof.of_solver, proof.findings.size());
}

TEST(Prove, AFindingCanBePlayedAgain) {
  Scenery scenery;
  scenery.put({8, 11}, slope(0.5, 0.5));
  const ProveScene scene(scenery.level, {});
  const Proof proof = *prove(scene, 1);
  ASSERT_FALSE(proof.findings.empty());
  for (const Finding& finding : proof.findings) {
    const auto again = TrialRunner(scene).play(finding.trial);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->frame, finding.frame);
    EXPECT_EQ(message_of(*again), message_of(finding));
  }
}

TEST(Prove, ThreadsDoNotChangeTheAnswer) {
  Scenery scenery;
  scenery.level.map = TileMap(80, 70);
  for (int x = 0; x < 80; ++x) scenery.level.map.set({x, 60}, 1);
  scenery.put({20, 59}, slope(0.5, 0.5));
  scenery.put({50, 59}, slope(0.5, 0.5));
  const Proof one = scenery.proof(1), three = scenery.proof(3);
  EXPECT_GT(one.findings.size(), 2u);
  EXPECT_EQ(text_of(one), text_of(three));
  EXPECT_EQ(one.counts.steps, three.counts.steps);
}

TEST(Prove, EndsWhenItIsTold) {
  const ProveScene scene(Scenery().level, {});
  EXPECT_FALSE(prove(scene, 1, [](double) { return false; }));
}

TEST(Prove, TriesAFewKindsOfBodiesAlone) {
  Scenery scenery;
  for (int i = 0; i < 20; ++i) {
    Spawn spawn = scenery.level.spawns[0];
    spawn.size.x = 2 + i;
    scenery.level.spawns.push_back(spawn);
  }
  const Proof proof = scenery.proof();
  EXPECT_EQ(proof.bodies.size(), kMaxBodies);
  EXPECT_EQ(proof.left_out, 21 - 1 - kMaxBodies) << "one has the size of the first";
}

// What Talus comes with, and real carts, keep its promise, whatever solver they are for.
TEST(Prove, HasNoFindingOfTheSolverInCartsAndExamples) {
  std::vector<std::string> files;
  for (const char* folder : {"assets", "assets/hard_cases", "tests/golden/article", "tests/golden/carts"}) {
    for (const auto& file : std::filesystem::directory_iterator(source_path(folder))) {
      const std::string extension = file.path().extension().string();
      const bool is_level =
          file.path().string().ends_with(".talus.json") || extension == ".lua" || extension == ".tic";
      if (is_level) files.push_back(file.path().string());
    }
  }
  EXPECT_GT(files.size(), 40u);
  for (const std::string& file : files) {
    auto level = load_level(file);
    ASSERT_TRUE(level) << file;
    level->level.tuning.solver = SolverKind::exact;
    const Proof proof = *prove(ProveScene(level->level, {}), 1);
    EXPECT_EQ(proof.of_solver, 0u) << file << "\n" << text_of(proof);
  }
}

// Random levels in which a body stopped, sank or floated, without what does not matter to that.
TEST(Prove, HasNoFindingOfTheSolverWhereItOnceHadOne) {
  int levels = 0;
  for (const auto& file : std::filesystem::recursive_directory_iterator(source_path("tests/prove"))) {
    if (!file.is_regular_file()) continue;
    const auto level = load_level(file.path().string());
    ASSERT_TRUE(level) << file.path();
    const Proof proof = *prove(ProveScene(level->level, {}), 1);
    EXPECT_GT(proof.counts.places, 0) << file.path();
    EXPECT_EQ(proof.of_solver, 0u) << file.path() << "\n" << text_of(proof);
    ++levels;
  }
  EXPECT_GT(levels, 10);
}

TEST(Prove, TheMeadowHasItsSixSeams) {
  const auto level = load_level(source_path("assets/platformer/meadow.tmx"));
  ASSERT_TRUE(level);
  const Proof proof = *prove(ProveScene(level->level, {}), 1);
  EXPECT_EQ(proof.findings.size(), 12u) << text_of(proof);
  std::set<std::pair<double, double>> seams;
  for (const Finding& finding : proof.findings) {
    EXPECT_EQ(finding.kind, FindingKind::lip);
    EXPECT_NEAR(finding.amount, 0.5, 0.001);
    seams.emplace(finding.place.x, finding.place.y);
  }
  EXPECT_EQ(seams.size(), 6u) << "one for the player and one for the ball";
}

TEST(Prove, SaysWhatItAssumesAndWhenThereWasNothingToTry) {
  Level level;
  level.map = TileMap(8, 4);
  level.tuning.solver = SolverKind::exact;
  Proof proof = *prove(ProveScene(level, {}), 1);
  EXPECT_EQ(summary_of(proof), "no place where a body can stand, so nothing was tried");
  EXPECT_TRUE(proof.assumes_body);
  Spawn ball;
  ball.position = {8, 8};
  level.spawns = {ball};
  EXPECT_FALSE(prove(ProveScene(level, {}), 1)->assumes_body);
}

TEST(Prove, SaysThatPlayersDoNotRun) {
  Scenery scenery;
  scenery.level.tuning.player.run_speed = 0;
  const Proof proof = scenery.proof();
  EXPECT_TRUE(proof.stands_still);
  EXPECT_NE(summary_of(proof).find("exact, but no walk of a player, as run_speed is 0, no finding"),
            std::string::npos)
      << summary_of(proof);
}

// It rests with a corner on a block, and comes back there from every jump, as it does not run.
TEST(Prove, APlayerThatDoesNotRunIsNotWedged) {
  Scenery scenery(Foot::centre);
  scenery.level.tuning.player.run_speed = 0;
  scenery.level.map.set({6, 8}, 1);
  scenery.level.map.set({10, 10}, 1);
  EXPECT_EQ(text_of(scenery.proof()), "");
}

TEST(Prove, CountsNoPlaceInsideOfGround) {
  Level level = empty_level();
  for (int y = 4; y < 20; ++y)
    for (int x = 0; x < 24; ++x) level.map.set({x, y}, 1);
  const Proof proof = *prove(ProveScene(level, {.bodies = {{}}}), 1);
  EXPECT_EQ(proof.counts.places, 24);
}

}  // namespace talus::prove_test
