// Every fix: its label, and that the problem is gone after it.
#include "level/lint/fixes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "slope_level.h"

namespace talus::fixes_test {

using testing::ElementsAre;
using testing::IsEmpty;

Problem first_of(const Level& level, std::string_view code) {
  for (const Problem& problem : lint(level)) {
    if (problem.rule->code == code) return problem;
  }
  ADD_FAILURE() << "no " << code;
  return {};
}

// The labels of the fixes of the first problem with this code. Each fix is tried: it must leave fewer
// problems, and can be undone.
std::vector<std::string> labels_of(const Level& level, std::string_view code) {
  const Problem problem = first_of(level, code);
  std::vector<std::string> labels;
  for (const Edit& edit : fixes_for(level, level, {}, problem)) {
    labels.push_back(edit.label);
    Level fixed = level;
    apply_edit(fixed, edit);
    EXPECT_LT(lint(fixed).size(), lint(level).size()) << edit.label;
    EXPECT_THAT(fixes_for(fixed, fixed, {}, problem), IsEmpty()) << edit.label;
    revert_edit(fixed, edit);
    EXPECT_TRUE(fixed == level) << edit.label;
  }
  return labels;
}

TEST(Fixes, SlopesGetTheirOtherHalf) {
  EXPECT_THAT(labels_of(slope_level({"o....", "./...", "#####"}), "slope-half-missing"),
              ElementsAre("Place tile 10, the slope's right half, at (2, 1)"));
  EXPECT_THAT(labels_of(slope_level({"o....", "..../", "#####"}), "slope-half-missing"),
              ElementsAre("Take tile 9 away from (4, 1), where the map cuts it off"));
  EXPECT_THAT(labels_of(slope_level({"o....", "./#..", "#####"}), "slope-overlap"),
              ElementsAre("Put tile 10, the slope's right half, in the place of tile 1 at (2, 1)"));
  EXPECT_THAT(labels_of(slope_level({"o....", "..-##", "#####"}), "slope-left-missing"),
              ElementsAre("Place tile 9, the slope's left half, at (1, 1)", "Take tile 10 away from (2, 1)"));
  EXPECT_THAT(labels_of(slope_level({"o....", "..-..", "#####"}), "slope-left-missing"),
              ElementsAre("Take tile 10 away from (2, 1)"))
      << "the slope would end at a wall";
}

TEST(Fixes, ShapesGetTheTilesThatDrawTheRest) {
  using Kind = TileShape::Kind;
  Level level = slope_level({"o....", ".....", "..../"});
  level.map.set({4, 2}, 0);
  const std::uint8_t wide = 40, tall = 60;
  for (const std::size_t tile : {40u, 41u, 60u}) level.sheet(SheetId::tiles).images[tile].fill(1);
  level.tile_shapes[wide] = {.kind = Kind::slope, .tiles = 2, .heights = {0, 8}};
  level.map.set({1, 2}, wide);
  EXPECT_THAT(labels_of(level, "slope-half-missing"),
              ElementsAre("Place tile 41, the rest of tile 40's shape, at (2, 2)"));
  level.map.set({1, 2}, tall);
  level.tile_shapes[tall] = {.kind = Kind::slope, .tiles = 2, .heights = {0, 16}};
  EXPECT_THAT(labels_of(level, "slope-half-missing"), IsEmpty()) << "the sheet has no picture of it";
  for (const std::size_t tile : {45u, 61u}) level.sheet(SheetId::tiles).images[tile].fill(1);
  EXPECT_THAT(labels_of(level, "slope-half-missing"),
              ElementsAre("Place 2 tiles, the rest of tile 60's shape, at (2, 2) and on"));
  level.tile_shapes[61] = {.kind = Kind::solid};
  EXPECT_THAT(labels_of(level, "slope-half-missing"), IsEmpty()) << "tile 61 has another shape";
}

TEST(Fixes, FlagsOfSlopes) {
  Level level = slope_level({"o....", "./-##", "#####"});
  level.sheet(SheetId::tiles).flags[kFlaggedHalf] = 4;
  Level fixed = level;
  const std::vector<Edit> edits = fixes_for(level, level, {}, first_of(level, "slope-overlap"));
  ASSERT_EQ(edits.size(), 1u);
  EXPECT_EQ(edits[0].label, "Clear the up-slope flag of tile 10, the slope's right half");
  apply_edit(fixed, edits[0]);
  EXPECT_THAT(lint_lines(fixed), IsEmpty());

  level = slope_level({"o......", "./-.a-#", "#######"});
  level.tile_shapes[kSlopeA] = {};
  level.sheet(SheetId::tiles).images[kSlopeA] = level.sheet(SheetId::tiles).images[kFlaggedSlope];
  const auto flag = fixes_for(level, level, {}, first_of(level, "slope-unflagged"));
  ASSERT_EQ(flag.size(), 1u);
  EXPECT_EQ(flag[0].label, "Set flag 2, up-slope, of tile 2");
  apply_edit(level, flag[0]);
  EXPECT_EQ(level.tile_flags(kSlopeA), 4);
}

TEST(Fixes, SeamsAreFilledOrLevelled) {
  EXPECT_THAT(labels_of(slope_level({"o....", ".a.##", "#####"}), "seam"),
              ElementsAre("Place tile 3, which goes on at the same height, at (2, 1)"));
  EXPECT_THAT(
      labels_of(slope_level({"o....", ".a##.", "#####"}), "seam"),
      ElementsAre("Raise the right end of tile 2's slope from 4 to 8 px, in every cell with that tile"));
  EXPECT_THAT(
      labels_of(slope_level({"o....", "...b#", "#####"}), "seam"),
      ElementsAre("Place tile 2, which goes on at the same height, at (2, 1)",
                  "Lower the left end of tile 3's slope from 4 to 0 px, in every cell with that tile"));
  Level hanging = slope_level({"#####", ".^...", "....o", "....."});
  hanging.tile_shapes[kHangingSign].heights = {2, 5};
  EXPECT_THAT(
      labels_of(hanging, "seam-ceiling"),
      ElementsAre("Lower the left end of tile 7's slope from 2 to 0 px, in every cell with that tile"));
}

TEST(Fixes, PixelsMoveWithTheEndOfASlope) {
  Level level = slope_level({"o....", ".a##.", "#####"});
  TileImage& image = level.sheet(SheetId::tiles).images[kSlopeA];
  image = {};
  for (int x = 0; x < 8; ++x) {  // green above brown, rising from 0 to 4 px
    const int top = 8 - (x + 1) / 2;
    for (int y = top; y < 8; ++y) image[static_cast<std::size_t>(y * 8 + x)] = y == top ? 5 : 9;
  }
  const auto fixes = fixes_for(level, level, {}, first_of(level, "seam"));
  ASSERT_EQ(fixes.size(), 1u);
  apply_edit(level, fixes[0]);  // the right end goes up to 8 px
  const TileImage& moved = level.sheet(SheetId::tiles).images[kSlopeA];
  EXPECT_EQ(moved[0 * 8 + 7], 5);
  EXPECT_EQ(moved[1 * 8 + 7], 9);
  EXPECT_EQ(moved[7 * 8 + 7], 9);
  EXPECT_EQ(moved[4 * 8 + 3], 5);
  EXPECT_EQ(moved[3 * 8 + 3], 0);
}

TEST(Fixes, AFixThatBreaksAnotherJoinIsNotOffered) {
  // Raising tile 2 to the wall would make a step to tile 3 beside it.
  const Level level = slope_level({"o........", ".a#..ab#.", "#########"});
  EXPECT_THAT(fixes_for(level, level, {}, first_of(level, "seam")), IsEmpty());
}

TEST(Fixes, NoTileIsLaidOverAir) {
  // Tile 3 goes on at the same height, but would hang over tile 6.
  const Level level = slope_level({"o........", "...a.....", "..##e....", "#########"});
  EXPECT_THAT(fixes_for(level, level, {}, first_of(level, "seam")),
              testing::Each(testing::Field(&Edit::label, testing::Not(testing::StartsWith("Place")))));
}

TEST(Fixes, NoWallIsMadeElsewhere) {
  // Tile 2 at the wall would fit if it rose to 8 px. At the other place, its end would become a wall.
  const Level level = slope_level({"o........", ".a#...a..", "#########"});
  for (const Problem& problem : lint(level))
    EXPECT_THAT(fixes_for(level, level, {}, problem), IsEmpty()) << problem.message;
}

TEST(Fixes, NoSlopeIsLaidToTheFootOfAWall) {
  // Tile 2 goes on at the same height, but a body on it would be stopped by a part of the wall.
  const Level level = slope_level({"o.....", ".##.b#", "######"});
  EXPECT_THAT(fixes_for(level, level, {}, first_of(level, "seam")),
              testing::Each(testing::Field(&Edit::label, testing::Not(testing::StartsWith("Place")))));
}

TEST(Fixes, EveryRuleSaysWhatToDoByHand) {
  for (const LintRule* rule : lint_rules()) {
    EXPECT_THAT(std::string(rule->by_hand), testing::EndsWith(".")) << rule->code;
    EXPECT_LE(rule->by_hand.size(), 100u) << rule->code;
  }
}

TEST(Fixes, SteepFloorsAreLowered) {
  Level level = slope_level({"o....", ".....", "..a..", "..#.."});
  level.tile_shapes[kSlopeA].heights = {0, 20};
  EXPECT_THAT(
      labels_of(level, "too-steep"),
      ElementsAre("Lower the right end of tile 2's slope from 20 to 16 px, in every cell with that tile",
                  "Let floors rise by 3 px for each px, in the whole level (steepest floor, in Tuning)"));
}

TEST(Fixes, TilesAndFlags) {
  Level level = slope_level({"o....", ".....", "#####"});
  level.sheet(SheetId::tiles).flags[kSolidSign] = 1 | 8;
  EXPECT_THAT(labels_of(level, "flags-conflict"),
              ElementsAre("Clear the down-slope flag of tile 1, which is solid as before"));
  level.sheet(SheetId::tiles).flags[kSolidSign] = 1;
  level.sheet(SheetId::tiles).images[kSolidSign].fill(0);
  EXPECT_THAT(labels_of(level, "invisible"),
              ElementsAre("Draw tile 1 as what it is", "Clear all flags of tile 1"));
  apply_edit(level, fixes_for(level, level, {}, first_of(level, "invisible"))[0]);
  EXPECT_EQ(level.sheet(SheetId::tiles).images[kSolidSign][63], 15);

  Level painted = slope_level({"o....", ".....", "#####"});
  SheetPicture picture{128, 128, std::vector<std::uint8_t>(std::size_t{4} * 128 * 128, 255)};
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) picture.rgba[4 * (y * picture.width + kSolidSign * 8 + x) + 3] = 0;
  painted.sheet(SheetId::tiles).picture = std::make_shared<const SheetPicture>(picture);
  EXPECT_THAT(labels_of(painted, "invisible"), ElementsAre("Clear all flags of tile 1"))
      << "its pixels in 16 colours are not seen";
  painted.sheet(SheetId::tiles).flags[kSolidSign] = 0;
  painted.tile_shapes[kSolidSign].kind = TileShape::Kind::solid;
  EXPECT_THAT(labels_of(painted, "invisible"), ElementsAre("Remove the shape of tile 1"));

  level.roles.one_way = 6;
  level.sheet(SheetId::tiles).flags[kBallSign] |= 1 << 6;
  EXPECT_THAT(labels_of(level, "flag-idle"), ElementsAre("Clear the flags of tile 8 that change nothing"));
  level.roles.one_way = 0;
  EXPECT_THAT(labels_of(level, "shared-flag"), ElementsAre("Let flag 0 no longer stand for one-way"));
}

TEST(Fixes, ShapesCurvesAndTheSolver) {
  Level level = slope_level({"o....", "#####"});
  level.tile_shapes[200] = {.kind = TileShape::Kind::slope, .heights = {1}};
  EXPECT_THAT(labels_of(level, "bad-shape"), ElementsAre("Remove the shape of tile 200"));
  level.tile_shapes[200] = {};
  level.flag_shapes[5] = {.tiles = 9};
  EXPECT_THAT(labels_of(level, "bad-shape"), ElementsAre("Remove the shape of flag 5"));
  level.flag_shapes[5] = {};
  level.curves = {{"good", {Segment{{0, 0}, {8, 8}}, Curve::Faces::up}, ""},
                  {"", {Segment{{8, 0}, {0, 8}}, Curve::Faces::up}, ""}};
  EXPECT_THAT(labels_of(level, "bad-curve"), ElementsAre("Remove curve 1"));
  level.curves.pop_back();
  level.tuning.solver = SolverKind::article;
  EXPECT_THAT(labels_of(level, "curves-need-exact"), ElementsAre("Choose the exact solver for this level"));
  level.tile_shapes[1] = {.kind = TileShape::Kind::solid, .conveyor = 1};
  level.map.set({0, 0}, 1);
  EXPECT_THAT(labels_of(level, "conveyors-need-exact"),
              ElementsAre("Choose the exact solver for this level"));
}

TEST(Fixes, CratesAreLetMeet) {
  Level level = slope_level({"...", "###"});
  level.spawns = {{"", {4, 0}, {}, "", BodyKind::crate, {8, 8}}};
  level.tuning.solver = SolverKind::exact;
  EXPECT_THAT(labels_of(level, "needs-meet"), ElementsAre("Let bodies meet"));
  for (const SolverKind solver : {SolverKind::article, SolverKind::bump}) {
    level.tuning.solver = solver;
    EXPECT_THAT(labels_of(level, "needs-meet"), ElementsAre("Choose the exact solver, and let bodies meet"));
  }
}

TEST(Fixes, BodiesAreMovedOutOfTheGround) {
  Level level = slope_level({"......", "......", ".##ab.", "######"});
  level.spawns = {{"hero", {12, 19}, {}, "", BodyKind::player, {8, 8}}};
  EXPECT_THAT(labels_of(level, "spawn-in-solid"), ElementsAre("Move body \"hero\" up by 11 px to 12, 8 px"));
  // The body's middle is on the slope.
  level.spawns[0].position = {28, 15};
  level.spawns[0].name.clear();
  EXPECT_THAT(labels_of(level, "spawn-in-slope"), ElementsAre("Move player 1 up by 3 px to 28, 12 px"));
  level.spawns[0].position = {44, 1};
  EXPECT_THAT(labels_of(level, "spawn-outside"), ElementsAre("Move player 1 to 40, 1 px"));
}

TEST(Fixes, ABodyBelowTheMapsTopLeavesSideways) {
  Level level = slope_level({"#..", "#..", "###"});
  level.spawns = {{"", {6, 1}, {}, ""}};
  EXPECT_THAT(labels_of(level, "spawn-in-solid"), ElementsAre("Move ball 1 to 8, 1 px"));
}

TEST(Fixes, ABodyAboveTheMapGetsToTheNearestFreePlaceOnIt) {
  Level level = slope_level({"##.", "##.", "###"});
  level.spawns = {{"", {3, -5}, {}, ""}};
  EXPECT_THAT(labels_of(level, "spawn-in-solid"), ElementsAre("Move ball 1 to 16, 0 px"));
}

TEST(Fixes, ABallIsMovedOutOfASlope) {
  const Level level = slope_level({"....", "....", "./o.", "####"});
  EXPECT_THAT(labels_of(level, "spawn-in-slope"),
              ElementsAre("Move the ball of (2, 2) up to (2, 1), and put tile 10 in its place"));
}

TEST(Fixes, AllOfAKindAreOneEdit) {
  const Level level = slope_level({"o..........", "./../..e../", "###########"});
  const std::vector<Problem> problems = lint(level);
  int fixed = 0;
  const Edit edit = fix_all(level, level, {}, problems, *first_of(level, "slope-half-missing").rule, &fixed);
  EXPECT_EQ(fixed, 3);
  EXPECT_EQ(edit.label, "Fix 3 problems: slope without its right half");
  EXPECT_EQ(edit.changes.size(), 3u);
  Level after = level;
  apply_edit(after, edit);
  EXPECT_EQ(after.map.at({2, 1}), kFlaggedHalf);
  EXPECT_EQ(after.map.at({5, 1}), kFlaggedHalf);
  EXPECT_EQ(after.map.at({10, 1}), 0);
  for (const Problem& problem : lint(after)) EXPECT_NE(problem.rule->code, "slope-half-missing");
  revert_edit(after, edit);
  EXPECT_TRUE(after == level);
}

TEST(Fixes, CurvesAreRemovedFromTheLast) {
  Level level = slope_level({"o....", "#####"});
  const LevelCurve bad{"", {Segment{{8, 0}, {0, 8}}, Curve::Faces::up}, ""};
  level.curves = {bad, {"good", {Segment{{0, 0}, {8, 8}}, Curve::Faces::up}, ""}, bad};
  const Edit edit = fix_all(level, level, {}, lint(level), *first_of(level, "bad-curve").rule);
  apply_edit(level, edit);
  ASSERT_EQ(level.curves.size(), 1u);
  EXPECT_EQ(level.curves[0].name, "good");
}

TEST(Fixes, AProblemThatIsGoneIsNotFixed) {
  Level level = slope_level({"o....", "./...", "#####"});
  const Problem problem = first_of(level, "slope-half-missing");
  level.map.set({1, 1}, 0);
  EXPECT_THAT(fixes_for(level, level, {}, problem), IsEmpty());
}

}  // namespace talus::fixes_test
