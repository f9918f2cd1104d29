// Every rule of the lint on small maps drawn here: '#' solid, 'o' ball, '/' up-slope, '\' down-slope, each
// with its other half '-', '!' solid and up-slope, '.' empty, '?' half of a flagged slope without a drawing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <talus/formats/format.h>
#include "level/lint/lint.h"
#include "paths.h"

namespace talus::lint_test {

using testing::ElementsAre;
using testing::IsEmpty;

enum Tile : TileNumber { kEmpty, kSolid, kBall, kUp, kDown, kHalf, kBoth, kBlank };

Level level_of(const std::vector<std::string>& rows) {
  Level level;
  level.map = TileMap(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
  constexpr std::string_view kSigns = ".#o/\\-!?";
  for (int y = 0; y < level.map.height(); ++y) {
    for (int x = 0; x < level.map.width(); ++x) {
      level.map.set({x, y}, static_cast<TileNumber>(kSigns.find(rows[y][x])));
    }
  }
  Sheet& tiles = level.sheet(SheetId::tiles);
  for (int tile = kSolid; tile < kBlank; ++tile) tiles.images[tile].fill(1);
  tiles.flags[kSolid] = 1;
  tiles.flags[kBall] = 2;
  tiles.flags[kUp] = 4;
  tiles.flags[kDown] = 8;
  tiles.flags[kBoth] = 5;
  return level;
}

// "E code (x, y) tile: message", with the cell and the tile if the problem has them.
std::vector<std::string> problems(const Level& level) {
  std::vector<std::string> list;
  for (const Problem& p : lint(level)) {
    std::string text = p.severity == Severity::error ? "E " : "W ";
    text += p.rule->code;
    if (p.cell)
      text.append(" (").append(std::to_string(p.cell->x)).append(", ").append(std::to_string(p.cell->y)) +=
          ")";
    if (p.tile >= 0) text.append(" ").append(std::to_string(p.tile));
    list.push_back(text + ": " + p.message);
  }
  return list;
}

TEST(Lint, ACorrectLevelHasNoProblem) {
  EXPECT_THAT(problems(level_of({"..o....o..",  //
                                 "#./-##\\-.#", "##########"})),
              IsEmpty());
}

TEST(Lint, OnlyTheFirstThousandAreListed) {
  const Level level =
      level_of(std::vector<std::string>(40, std::string(40, '/')));  // 1600 slopes without a half
  const std::vector<Problem> found = lint(level);
  ASSERT_EQ(found.size(), kMaxProblems + 1);
  EXPECT_EQ(found[0].rule->code, "more");
  EXPECT_EQ(found[0].severity, Severity::error);
  EXPECT_EQ(found[0].message, "601 more problems are not listed");  // one of them says that nothing will move
}

TEST(Lint, NothingWillMove) {
  Level level = level_of({"..", "##"});
  EXPECT_THAT(problems(level),
              ElementsAre("W no-bodies: there is no player and no ball, so nothing will move"));
  level.spawns.push_back({});
  EXPECT_THAT(problems(level), IsEmpty());
}

TEST(Lint, AShapeReachesOverTheMapsEdge) {
  Level level = level_of({"o.........", "..........", ".........."});
  level.sheet(SheetId::tiles)
      .images.assign(kCartTiles, {});  // so that the rest of the shapes need not be drawn either
  level.tile_shapes[100] = {.kind = TileShape::Kind::slope, .tiles = 8, .heights = {0, 8}};
  level.tile_shapes[101] = {.kind = TileShape::Kind::slope, .heights = {0, 16}};
  level.tile_shapes[102] = level.tile_shapes[101];
  level.tile_shapes[102].side = TileShape::Side::ceiling;
  for (const Cell cell : {Cell{2, 1}, Cell{3, 1}, Cell{9, 2}}) level.map.set(cell, 100);
  level.map.set({4, 0}, 101);
  level.map.set({5, 0}, 102);
  level.map.set({6, 2}, 101);
  level.map.set({7, 2}, 102);
  EXPECT_THAT(problems(level),
              ElementsAre("W shape-leaves-map (4, 0) 101: tile 101 at (4, 0) reaches over "
                          "the map's upper edge, where it stops nothing",
                          "W shape-leaves-map (3, 1) 100: tile 100 at (3, 1) reaches over "
                          "the map's right edge, where it stops nothing",
                          "W interior-edge (4, 1): the ground above (4, 1) stays open by 6 px, "
                          "too little for a body: edges inside it can catch what comes along",
                          "W seam (6, 1): floor jumps 3 px between (6, 1) and (7, 1)",
                          "W shape-leaves-map (7, 2) 102: tile 102 at (7, 2) reaches over "
                          "the map's lower edge, where it stops nothing",
                          "W shape-leaves-map (9, 2) 100: tile 100 at (9, 2) reaches over "
                          "the map's right edge, where it stops nothing"));
}

TEST(Lint, HalfOfASlopeIsNotDrawn) {
  EXPECT_THAT(problems(level_of({"o./.\\?", "..-../"})),
              ElementsAre("E slope-half-missing (2, 0) 3: tile 3 at (2, 0) is an up-slope, but the tile to "
                          "its right is empty: half "
                          "of the slope is not drawn",
                          "E slope-half-missing (4, 0) 4: tile 4 at (4, 0) is a down-slope, but the tile to "
                          "its right is empty: half "
                          "of the slope is not drawn",
                          "E slope-half-missing (5, 1) 3: tile 3 at (5, 1) is an up-slope, but the map ends "
                          "at its right: the rest "
                          "of the slope is cut off"));
}

TEST(Lint, TheRestOfAShapeIsNotDrawn) {
  using Kind = TileShape::Kind;
  constexpr std::size_t kWide = 100, kTall = 102, kLast = 111, kDrawn = 120;
  Level level = level_of({"o.......", "........", "........"});
  for (const std::size_t tile : {kWide, kTall, kLast, kDrawn})
    level.sheet(SheetId::tiles).images[tile].fill(1);
  level.tile_shapes[kWide] = {.kind = Kind::slope, .tiles = 2, .heights = {8, 0}};
  level.map.set({1, 2}, kWide);
  const auto only = [&] { return problems(level); };
  EXPECT_THAT(only(), ElementsAre("W slope-half-missing (1, 2) 100: tile 100 at (1, 2) has a shape that also "
                                  "covers (2, 2), where no tile shows it"));
  level.map.set({2, 2}, kDrawn);
  EXPECT_THAT(only(), IsEmpty());
  level.map.set({2, 2}, 0);
  level.tile_shapes[kWide].one_way = true;
  EXPECT_THAT(only(), testing::SizeIs(1));
  level.tile_shapes[kWide].heights = {2, 0};
  EXPECT_THAT(only(), IsEmpty()) << "less than a pixel of it is there";
  level.sheet(SheetId::tiles).images[kWide].fill(0);
  level.tile_shapes[kWide].heights = {8, 0};
  EXPECT_THAT(only(), ElementsAre(testing::HasSubstr("invisible"))) << "another rule already reports it";

  level.map.set({1, 2}, kTall);
  level.tile_shapes[kTall] = {.kind = Kind::slope, .tiles = 2, .heights = {0, 16}};
  EXPECT_THAT(only(), ElementsAre("W slope-half-missing (1, 2) 102: tile 102 at (1, 2) has a shape that also "
                                  "covers (2, 2) and 1 more cell, where no tile shows it"));
  level.tile_shapes[kTall].one_way = true;
  EXPECT_THAT(only(), ElementsAre(testing::HasSubstr("covers (2, 1), where"))) << "the line alone";
  level.tile_shapes[kTall].side = TileShape::Side::ceiling;
  level.map.set({1, 2}, 0);
  level.map.set({1, 0}, kTall);
  EXPECT_THAT(only(), ElementsAre(testing::HasSubstr("covers (2, 1), where"))) << "it hangs down";

  level.map.set({1, 0}, 0);
  level.map.set({1, 2}, kLast);
  level.tile_shapes[kLast] = {.kind = Kind::profile, .tiles = 4, .heights = {4, 8, 8, 8, 4}};
  EXPECT_THAT(only(), ElementsAre("W slope-half-missing (1, 2) 111: tile 111 at (1, 2) has a shape that also "
                                  "covers (2, 2) and 2 more cells, where no tile shows it: it is wider than "
                                  "what the sheet has at the tile's right"));
}

TEST(Lint, ASlopeOverlapsItsNeighbour) {
  EXPECT_THAT(problems(level_of({"o./#", "//-."})),
              ElementsAre("E slope-overlap (2, 0) 3: tile 3 at (2, 0) is an up-slope, but the tile to its "
                          "right is solid: it stands "
                          "inside the slope's box",
                          "E slope-overlap (0, 1) 3: tile 3 at (0, 1) is an up-slope, but the tile to its "
                          "right has a slope's flag "
                          "too: only the left tile of a slope may be flagged"));
}

TEST(Lint, ALongerSlopeNeedsMoreTiles) {
  Level level = level_of({"o./--", "../-."});
  level.tuning.shared.slope_width = 24;
  EXPECT_THAT(
      problems(level),
      ElementsAre(
          "E slope-half-missing (2, 1) 3: tile 3 at (2, 1) is an up-slope, but the tile 2 to its right is "
          "empty: half of the slope is not drawn"));
  level.tuning.shared.slope_width = 8;
  EXPECT_THAT(problems(level), IsEmpty());
}

TEST(Lint, ContradictingFlagsAreReportedOnceForATile) {
  EXPECT_THAT(
      problems(level_of({"o.!.", "!!!!"})),
      ElementsAre(
          "E flags-conflict (2, 0) 6: tile 6 has the flags of solid and up-slope; only the first, solid, "
          "counts"));
}

TEST(Lint, AFlagWithTwoRoles) {
  Level level = level_of({"o#"});
  level.roles.up_slope = 0;
  EXPECT_THAT(problems(level), ElementsAre("E shared-flag: flag 0 stands for both solid and up-slope"));
  level.roles.up_slope = level.roles.down_slope = FlagRoles::kUnused;
  EXPECT_THAT(problems(level), IsEmpty());
}

TEST(Lint, ABallInTheOtherHalfOfASlope) {
  EXPECT_THAT(
      problems(level_of({"/o.\\o"})),
      ElementsAre(
          "E spawn-in-slope (1, 0) 2: the ball at (1, 0) starts 6 px inside the up-slope at (0, 0)",
          "E spawn-in-slope (4, 0) 2: the ball at (4, 0) starts 2 px inside the down-slope at (3, 0)"));
}

TEST(Lint, ASpawnInASolid) {
  Level level = level_of({"....", ".##.", "...."});
  level.spawns.push_back({"", {0, 0}, {}, ""});          // touches the solid tiles at its corner
  level.spawns.push_back({"hero", {0.5, 0.5}, {}, ""});  // overlaps it
  level.spawns.push_back({"", {16, 15.5}, {}, ""});
  EXPECT_THAT(
      problems(level),
      ElementsAre(
          "E spawn-in-solid (0, 0): body \"hero\" at 0.5, 0.5 px starts inside the solid tile at (1, 1)",
          "E spawn-in-solid (2, 1): ball 3 at 16, 15.5 px starts inside the solid tile at (2, 1)"));
}

TEST(Lint, ASpawnInASlope) {
  Level level = level_of({"....", "./-.", "####"});
  level.spawns.push_back(
      {"", {12, 2}, {}, ""});  // its centre is half way along the slope, where the floor is at 4
  level.spawns.push_back({"", {12, 4}, {}, ""});
  level.spawns.push_back({"", {12, 4.25}, {}, ""});
  EXPECT_THAT(
      problems(level),
      ElementsAre(
          "E spawn-in-slope (1, 0): ball 3 at 12, 4.25 px starts 0.25 px inside the up-slope at (1, 1)"));
}

TEST(Lint, ASpawnOutsideTheMap) {
  Level level = level_of({"#.", ".."});
  level.spawns.push_back({"", {9, 0}, {}, ""});
  level.spawns.push_back({"", {-4, 2}, {}, ""});
  level.spawns.push_back({"", {-1e6, 1e6}, {}, ""});
  EXPECT_THAT(
      problems(level),
      ElementsAre("E spawn-in-solid (0, 0): ball 2 at -4, 2 px starts inside the solid tile at (0, 0)",
                  "W spawn-outside (0, 0): ball 2 at -4, 2 px is partly or wholly off the map",
                  "W spawn-outside (1, 0): ball 1 at 9, 0 px is partly or wholly off the map",
                  "W spawn-outside (0, 1): ball 3 at -1000000, 1000000 px is partly or wholly off the map"));
}

TEST(Lint, BadShapesAndCurves) {
  Level level = level_of({"o#"});
  level.tile_shapes[200] = {.kind = TileShape::Kind::slope, .heights = {1}};
  level.flag_shapes[5] = {.tiles = 9};
  level.curves = {{"", {Segment{{0, 0}, {8, 8}}, Curve::Faces::up}, ""},
                  {"", {Segment{{8, 0}, {0, 8}}, Curve::Faces::up}, ""},
                  {"hill", {Segment{{0, 0}, {17, 8}}, Curve::Faces::up}, ""}};
  EXPECT_THAT(problems(level), ElementsAre("E bad-shape: the shape of flag 5 must be 1 to 8 tiles wide",
                                           "E bad-shape 200: the shape of tile 200 must have 2 heights",
                                           "E bad-curve (0, 0): curve \"hill\" has its last end off the map",
                                           "E bad-curve (1, 0): curve 1 has its right end left of its left "
                                           "end"));
}

TEST(Lint, ACurveLeavesTheMapBetweenItsEnds) {
  Level level = level_of({"o#.."});
  level.curves = {{"", {Arc{{16, 8}, 8, 8, 24, true}, Curve::Faces::up}, ""},  // touches the upper side
                  {"", {Arc{{16, 8}, 8.5, 8, 24, true}, Curve::Faces::up}, ""},
                  {"", {Parabola{{0, 8}, {32, 8}, 8.5}, Curve::Faces::up}, ""}};
  EXPECT_THAT(problems(level),
              ElementsAre("W curve-leaves-map (0, 0): curve 2 leaves the map between its ends",
                          "W curve-leaves-map (1, 0): curve 1 leaves the map between its ends"));
}

TEST(Lint, CurvesThatTheSolverIgnores) {
  Level level = level_of({"o..", "###"});
  level.curves.push_back({"", {Segment{{2, 4}, {20, 4}}, Curve::Faces::up}, ""});
  EXPECT_THAT(problems(level), IsEmpty());
  level.tuning.solver = SolverKind::bump;
  EXPECT_THAT(problems(level), ElementsAre("W curves-need-exact: curves and segments stop only bodies of the "
                                           "exact solver, but the level's solver is bump"));
}

TEST(Lint, ConveyorsThatTheSolverIgnores) {
  Level level = level_of({"o..", "###"});
  level.tile_shapes[1] = {.kind = TileShape::Kind::solid, .conveyor = 1};
  level.tuning.solver = SolverKind::exact;
  EXPECT_THAT(problems(level), IsEmpty());
  level.tuning.solver = SolverKind::bump;
  EXPECT_THAT(problems(level),
              ElementsAre("W conveyors-need-exact (0, 1) 1: conveyors carry only bodies of the "
                          "exact solver, but the level's solver is bump"));
}

TEST(Lint, CratesThatNothingPushes) {
  Level level = level_of({"...", "###"});
  level.spawns = {{"", {2, 0}, {}, "", BodyKind::ball, {8, 8}},
                  {"", {12, 0}, {}, "", BodyKind::crate, {8, 8}}};
  const auto lacks = ElementsAre(
      "W needs-meet (1, 0): crate 2 moves like a ball: bodies are round, are pushed and rub only with the "
      "solver exact and bodies that meet");
  EXPECT_THAT(problems(level), lacks);
  level.tuning.solver = SolverKind::article;
  EXPECT_THAT(problems(level), lacks);
  level.tuning.solver = SolverKind::exact;
  level.tuning.shared.bodies = static_cast<double>(BodyPairs::meet);
  EXPECT_THAT(problems(level), IsEmpty());
}

TEST(Lint, EveryKindThatIsMoreThanABallNeedsBodiesThatMeet) {
  for (const BodyKind kind : {BodyKind::crate, BodyKind::disc, BodyKind::marble}) {
    Level level = level_of({"...", "###"});
    level.spawns = {{"", {2, 0}, {}, "", kind, {8, 8}}};
    EXPECT_THAT(problems(level), ElementsAre(testing::HasSubstr("W needs-meet"))) << traits_of(kind).word;
  }
}

TEST(Lint, BodiesThatMeetWithAnotherSolver) {
  Level level = level_of({"...", "###"});
  level.spawns = {{"", {2, 0}, {}, "", BodyKind::ball, {8, 8}}};
  level.tuning.shared.bodies = static_cast<double>(BodyPairs::meet);
  level.tuning.solver = SolverKind::article;
  EXPECT_THAT(problems(level),
              ElementsAre("W needs-meet: bodies meet only with the solver exact, but the level's solver "
                          "is article, where they block one another"));
  level.tuning.solver = SolverKind::exact;
  EXPECT_THAT(problems(level), IsEmpty());
}

TEST(Lint, ShapesDecideWhatIsSolid) {
  Level level = level_of({"o.-.", "/-.."});
  level.spawns.push_back({"", {12, 0}, {}, ""});
  level.tile_shapes[kHalf] = {.kind = TileShape::Kind::solid};
  EXPECT_THAT(
      problems(level),
      ElementsAre("E spawn-in-solid (1, 0): ball 1 at 12, 0 px starts inside the solid tile at (2, 0)",
                  "E slope-overlap (0, 1) 3: tile 3 at (0, 1) is an up-slope, but the tile to its right "
                  "is solid: it stands inside the slope's box"));
  level.tile_shapes[kHalf].one_way = true;
  EXPECT_THAT(problems(level), IsEmpty());
}

TEST(Lint, ASpawnHasItsOwnSize) {
  Level level = level_of({"..#", "..."});
  level.spawns = {{"", {8, 0}, {}, "", BodyKind::player, {8, 16}}};
  EXPECT_THAT(problems(level), IsEmpty());
  level.spawns[0].size = {9, 17};
  EXPECT_THAT(
      problems(level),
      ElementsAre("E spawn-in-solid (1, 0): player 1 at 8, 0 px starts inside the solid tile at (2, 0)",
                  "W spawn-outside (1, 0): player 1 at 8, 0 px is partly or wholly off the map"));
}

// Just below the top of a slope, a corner of a body on its centre is in the block that follows.
TEST(Lint, ABodyThatStandsOnASlopeIsInNoBlock) {
  Level level = level_of({"....", "..##", "####"});
  level.tuning.solver = SolverKind::exact;
  level.tile_shapes[5] = {.kind = TileShape::Kind::slope, .heights = {0, 8}};
  level.map.set({1, 1}, 5);
  level.spawns = {{"", {11, 1}, {}, "", BodyKind::player, {8, 8}, Foot::centre}};
  EXPECT_EQ(lint(level).size(), 0U) << lint(level)[0].message;
  level.spawns[0].foot = Foot::box;
  EXPECT_THAT(problems(level), ElementsAre(testing::HasSubstr("starts inside the solid tile at (2, 1)")));
}

TEST(Lint, ModifiersDoNotConflict) {
  Level level = level_of({"o#"});
  level.roles.one_way = 6;
  level.sheet(SheetId::tiles).flags[kSolid] |= 1 << 6;
  EXPECT_THAT(problems(level), IsEmpty());
  level.roles.ceiling = 6;
  EXPECT_THAT(problems(level), ElementsAre("E shared-flag: flag 6 stands for both one-way and ceiling"));
}

TEST(Lint, TheScenesOfTheArticleHaveNoProblem) {
  for (const std::string name : {"drag", "one", "s4", "s26", "s60", "six"}) {
    EXPECT_THAT(problems(load_level(source_path("tests/golden/article/") + name + ".lua")->level), IsEmpty())
        << name;
  }
}

TEST(Lint, ForeignCartsGetFewProblems) {
  const auto count = [](const std::string& name) {
    return problems(load_level(source_path("tests/golden/carts/") + name + "-data.tic")->level).size();
  };
  EXPECT_EQ(count("car"), 1u);  // no balls
  EXPECT_EQ(count("tetris"), 1u);
  EXPECT_EQ(count("quest"), 3u);  // its tile 0 has every flag and no picture
}

TEST(Lint, PolygonsThatASolverDoesNotTake) {
  Level level = level_of({"o..", "###"});
  level.map.set({1, 0}, 20);
  level.sheet(SheetId::tiles).images[20].fill(1);
  TileShape& shape = level.tile_shapes[20];
  shape.kind = TileShape::Kind::polygon;
  shape.points = {{0, 0}, {8, 0}, {8, 8}, {0, 8}};
  for (const SolverKind solver : {SolverKind::article, SolverKind::bump, SolverKind::exact}) {
    level.tuning.solver = solver;
    EXPECT_THAT(problems(level), IsEmpty());
  }
  shape.points = {{0, 0}, {8, 6}, {8, 8}, {0, 2}};
  const auto unknown = testing::Contains(
      testing::StartsWith("W ground-not-in-bump 20: bodies pass through parts of tile 20: bump "));
  EXPECT_THAT(problems(level), testing::Not(unknown));
  level.tuning.solver = SolverKind::bump;
  EXPECT_THAT(problems(level), unknown);
}

TEST(Lint, GroundOfALayerThatIsDrawnElsewhere) {
  Level level = level_of({"o..", "###"});
  level.layers.list[0].offset = {4, -0.5};
  level.layers.list[0].name = "land";
  const auto moved = ElementsAre(
      "W ground-not-where-drawn: bodies do not stop where the layer \"land\" is drawn: its picture has an "
      "offset of 4, -0.5 px, and its ground has none");
  EXPECT_THAT(problems(level), moved);
  Level sky = level;
  sky.layers.list.push_back({.name = "sky", .is_ground = false, .offset = {9, 9}});
  sky.layers.list[1].cells = std::make_shared<const MapCells>(level.map.cells());
  EXPECT_THAT(problems(sky), moved) << "one among several";
  sky.layers.list[0].offset = {};
  EXPECT_THAT(problems(sky), IsEmpty());
  level.map.cells().tiles().assign(6, 0);
  level.map.set({0, 0}, kBall);
  EXPECT_THAT(problems(level), testing::Not(testing::Contains(testing::HasSubstr("not-where-drawn"))))
      << "it has no ground";
}

TEST(Lint, GroundThatTheArticleDoesNotKnow) {
  Level level = level_of({"o..", "###"});
  level.map.set({1, 0}, 20);
  level.tile_shapes[20] = {.kind = TileShape::Kind::solid, .one_way = true};
  level.tile_shapes[21] = {.kind = TileShape::Kind::profile, .heights = {0, 4, 0}};  // not on the map
  level.sheet(SheetId::tiles).images[20].fill(1);
  for (const SolverKind solver : {SolverKind::bump, SolverKind::exact}) {
    level.tuning.solver = solver;
    EXPECT_THAT(problems(level), IsEmpty());
  }
  level.tuning.solver = SolverKind::article;
  EXPECT_THAT(problems(level),
              ElementsAre("W ground-not-in-article 20: bodies pass through tile 20: the article's solver "
                          "does not know one-way ground, ceilings and profiles; bump and exact do"));
}

TEST(Lint, ABodyThatIsTooFast) {
  Level level = level_of({"...", "###"});
  Spawn spawn;
  spawn.velocity = {-4096, 4096};
  level.spawns = {spawn};
  EXPECT_THAT(problems(level), IsEmpty());
  level.spawns[0].velocity.y = 1e6;
  ASSERT_EQ(problems(level).size(), 1u);
  EXPECT_THAT(problems(level)[0],
              testing::HasSubstr("1000000 px/frame; after the first step speeds are cut to 4096"));
}

}  // namespace talus::lint_test
