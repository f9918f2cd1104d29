// Floors that do not meet, gaps too small for a player, and problems of a single tile.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include <talus/formats/format.h>
#include "level/lint/rule_group.h"
#include "paths.h"
#include "slope_level.h"

namespace talus::lint_seam_test {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(LintSeams, FloorsThatMeetGiveNoProblem) {
  EXPECT_THAT(lint_lines(slope_level({"o............",  //
                                      "....ab##cd...", "#############"})),
              IsEmpty());
  EXPECT_THAT(lint_lines(slope_level({"o.........", "...ab##...", ".ab######.", "##########"})), IsEmpty());
}

TEST(LintSeams, WholeStepsAndLedgesAreIntended) {
  EXPECT_THAT(lint_lines(slope_level({"o....#...", ".....#ab.", "##..###..", "#########"})), IsEmpty());
}

TEST(LintSeams, AJumpOfTheFloorIsFound) {
  EXPECT_THAT(lint_lines(slope_level({"o....", ".a##.", "#####"})),
              ElementsAre("seam: floor jumps 4 px between (1, 1) and (2, 1)"));
  EXPECT_THAT(lint_lines(slope_level({"o....", "..e..", "#####"})),
              ElementsAre("seam: floor jumps 5 px between (2, 1) and (3, 2)",
                          "seam: floor jumps 5 px between (1, 2) and (2, 1)"));
  // The slope leads down to the floor, as its other half is missing.
  EXPECT_THAT(lint_lines(slope_level({"o....", ".a...", "#####"})),
              ElementsAre("seam: floor jumps 4 px between (1, 1) and (2, 2)"));
}

TEST(LintSeams, AFloorUnderAOneWaySlopeDoesNotJump) {
  Level level = slope_level({"o.....", ".ae...", "######"});
  level.tile_shapes[kSlopeA] = {.kind = TileShape::Kind::slope, .one_way = true, .heights = {0, 5}};
  EXPECT_THAT(lint_lines(level), ElementsAre("seam: floor jumps 5 px between (2, 1) and (3, 2)"));
}

TEST(LintSeams, AJumpIsFoundInFractionsOfAPixel) {
  Level level = slope_level({"o....", ".a##.", "#####"});
  level.tile_shapes[kSlopeA].heights = {0, 8 - 1.0 / 256};
  EXPECT_THAT(lint_lines(level), ElementsAre("seam: floor jumps 0.003906 px between (1, 1) and (2, 1)"));
  level.tile_shapes[kSlopeA].heights = {0, 8};
  EXPECT_THAT(lint_lines(level), IsEmpty());
}

TEST(LintSeams, SmallJumpsCanBeAllowed) {
  const Level level = slope_level({"o....", "..e..", "#####"});
  EXPECT_THAT(lint_lines(level, {4.75}).size(), 2u);
  EXPECT_THAT(lint_lines(level, {5}), IsEmpty());
}

TEST(LintSeams, AJumpOfTheCeilingIsFound) {
  EXPECT_THAT(lint_lines(slope_level({"#####", ".^...", "....o", "....."})),
              ElementsAre("seam-ceiling: ceiling jumps 3 px between (1, 1) and (2, 0)"));
}

TEST(LintSeams, AWideSlopeJumpsAtItsEnd) {
  Level level = slope_level({"o.......", ".a......", "########"});
  level.tile_shapes[kSlopeA] = {.kind = TileShape::Kind::slope, .tiles = 3, .heights = {0, 6}};
  level.sheet(SheetId::tiles).images[40].fill(1);
  for (const int x : {2, 3}) level.map.set({x, 1}, 40);
  EXPECT_THAT(lint_lines(level), ElementsAre("seam: floor jumps 6 px between (3, 1) and (4, 2)"));
}

TEST(LintSeams, ACurveMayContinueAFloor) {
  Level level = slope_level({"o....", ".a...", "##..."});
  level.map.set({2, 1}, kBlockE);
  level.tile_shapes[kBlockE].heights = {1, 1};  // 3 px lower
  EXPECT_THAT(lint_lines(level).size(), 1u);
  level.curves.push_back({"", {Segment{{16, 12}, {40, 12}}, Curve::Faces::up}, ""});
  EXPECT_THAT(lint_lines(level), IsEmpty());
}

std::string edge_at(const std::string& cell, int gap) {
  return "interior-edge: the ground above " + cell + " stays open by " + std::to_string(gap) +
         " px, too little for a body: edges inside it can catch what comes along";
}

TEST(LintEdges, AnEdgeInsideTheGroundHasItsOwnProblem) {
  // The block is 5 px high, and a full tile lies over it: the block's top and the tile's bottom are inside
  // the ground.
  EXPECT_THAT(lint_lines(slope_level({"o....", "..#..", "..e..", "#####"})),
              ElementsAre(edge_at("(2, 2)", 3)));
  // The same at both ends of a longer block, and where the block is closed all around.
  EXPECT_THAT(lint_lines(slope_level({"o.....", ".####.", ".eeee.", "######"})),
              ElementsAre(edge_at("(1, 2)", 3), edge_at("(4, 2)", 3)));
  EXPECT_THAT(lint_lines(slope_level({"o.....", ".####.", ".#ee#.", "######"})),
              ElementsAre(edge_at("(2, 2)", 3), edge_at("(3, 2)", 3)));
  // Without a tile above, the same block is a floor that jumps.
  EXPECT_THAT(lint_lines(slope_level({"o....", ".....", "..e..", "#####"})),
              ElementsAre("seam: floor jumps 5 px between (2, 2) and (3, 3)",
                          "seam: floor jumps 5 px between (1, 3) and (2, 2)"));
}

TEST(LintEdges, FloorsThatJumpInsideTheGroundAreIgnored) {
  Level level = slope_level({"o.....", ".####.", ".#eb#.", "######"});
  level.tile_shapes[kSlopeB].heights = {3, 3};
  EXPECT_THAT(lint_lines(level), ElementsAre(edge_at("(2, 2)", 3), edge_at("(3, 2)", 5)));
}

TEST(LintEdges, CornersAndTunnelsForSmallPlayersAreIntended) {
  EXPECT_THAT(lint_lines(slope_level({"o......", "#######", "...ab##", "#######"})), IsEmpty());
  Level level = slope_level({".....", "..#..", ".###.", ".eee.", "#####"});
  level.spawns = {{"", {0, 0}, {}, "", BodyKind::player, {3, 4}}};
  EXPECT_THAT(lint_lines(level), ElementsAre(edge_at("(1, 3)", 3), edge_at("(3, 3)", 3)));
  level.spawns[0].size = {3, 3};
  EXPECT_THAT(lint_lines(level), ElementsAre("seam: floor jumps 5 px between (3, 3) and (4, 4)",
                                             "seam: floor jumps 5 px between (0, 4) and (1, 3)"));
}

Level gap_level(const std::vector<std::string>& rows, Vec2 size) {
  Level level = slope_level(rows);
  level.spawns = {{"", {0, 0}, {}, "", BodyKind::player, size}};
  return level;
}

TEST(LintGaps, ATunnelIsTooLow) {
  const std::vector<std::string> rows = {"........", "..####..", "........", "########"};
  EXPECT_THAT(lint_lines(gap_level(rows, {8, 12})),
              ElementsAre("gap-too-small: the gap at (2, 2) is 8 px high, and a player is 12 px"));
  EXPECT_THAT(lint_lines(gap_level(rows, {8, 8})), IsEmpty());
  EXPECT_THAT(lint_lines(gap_level({"........", "..####..", ".....#..", "########"}, {8, 12})), IsEmpty());
  Level balls = slope_level(rows);
  balls.spawns = {{"", {0, 0}, {}, "", BodyKind::ball, {8, 12}}};
  EXPECT_THAT(lint_lines(balls), IsEmpty());
}

TEST(LintGaps, AShaftIsTooNarrow) {
  const std::vector<std::string> rows = {".....", ".....", "##.##", "##.##", ".....", ".....", "#####"};
  EXPECT_THAT(lint_lines(gap_level(rows, {10, 8})),
              ElementsAre("gap-too-small: the gap at (2, 2) is 8 px wide, and a player is 10 px"));
  EXPECT_THAT(lint_lines(gap_level(rows, {8, 8})), IsEmpty());
  EXPECT_THAT(lint_lines(gap_level({".....", ".....", "##.##", "#####"}, {10, 8})), IsEmpty());  // a pit
}

TEST(LintTiles, AFloorIsTooSteep) {
  Level level = slope_level({"o....", ".....", "..a..", "..#.."});
  level.tile_shapes[kSlopeA].heights = {0, 16};
  EXPECT_THAT(lint_lines(level), IsEmpty());
  level.tile_shapes[kSlopeA].heights = {0, 20};
  EXPECT_THAT(
      lint_lines(level),
      ElementsAre("too-steep: tile 2 rises 20 px in 8 px; more than 16 px is not a floor to stand on"));
  level.tuning.exact.steepest = 2.5;
  EXPECT_THAT(lint_lines(level), IsEmpty());
}

TEST(LintTiles, ATileHasNoPicture) {
  Level level = slope_level({"o....", ".....", "#####"});
  level.sheet(SheetId::tiles).images[kSolidSign].fill(0);
  EXPECT_THAT(lint_lines(level), ElementsAre("invisible: tile 1 is solid, but its picture is blank"));
  level.map.cells().tiles().assign(15, 0);
  level.spawns.push_back({});
  EXPECT_THAT(lint_lines(level), IsEmpty());  // it is not on the map
  level.map.cells().tiles().assign(15, kSolidSign);
  level.spawns[0].position = {0, -8};
  for (TileImage& image : level.sheet(SheetId::tiles).images) image.fill(0);
  EXPECT_THAT(lint_lines(level).size(), 1u);  // the spawn; nothing has a picture in such a level
}

// Dark ground, whose nearest colour of the palette is colour 0, is seen all the same.
TEST(LintTiles, InTrueColourWhatIsNotClearIsAPicture) {
  Level level = slope_level({"o....", ".....", "#####"});
  Sheet& sheet = level.sheet(SheetId::tiles);
  sheet.images[kSolidSign].fill(0);
  SheetPicture picture{16 * 8, sheet.layout().rows() * 8, {}};
  picture.rgba.assign(std::size_t{4} * picture.width * picture.height, 1);
  sheet.picture = std::make_shared<const SheetPicture>(picture);
  EXPECT_THAT(lint_lines(level), IsEmpty());
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) picture.rgba[4 * (y * picture.width + kSolidSign * 8 + x) + 3] = 0;
  picture.rgba[4 * (3 * picture.width) + 3] = 255;
  sheet.picture = std::make_shared<const SheetPicture>(picture);
  EXPECT_THAT(lint_lines(level), ElementsAre("invisible: tile 1 is solid, but its picture is blank"));
}

TEST(LintTiles, ASlopeIsDrawnButNotFlagged) {
  Level level = slope_level({"o......", "./-.a..", "#######"});
  level.tile_shapes[kSlopeA] = {};
  EXPECT_THAT(lint_lines(level), IsEmpty());
  level.sheet(SheetId::tiles).images[kSlopeA] = level.sheet(SheetId::tiles).images[kFlaggedSlope];
  EXPECT_THAT(lint_lines(level), ElementsAre("slope-unflagged: tile 2 is drawn like tile 9, an up-slope, but "
                                             "nothing makes it one"));
  level.tile_shapes[kSlopeA] = {.kind = TileShape::Kind::slope, .heights = {0, 8}};
  EXPECT_THAT(lint_lines(level).size(), 0u);
}

TEST(LintTiles, ARightHalfHasNoLeftOne) {
  EXPECT_THAT(lint_lines(slope_level({"o......", ".-.../-", "#######"})),
              ElementsAre("slope-left-missing: tile 10 at (1, 1) is drawn as the right half of tile 9, an "
                          "up-slope, but no slope is at its left: bodies fall through it"));
}

TEST(LintTiles, AFlagChangesNothing) {
  Level level = slope_level({"o#..-"});
  level.spawns.push_back({"", {16, 0}, {}, ""});
  level.sheet(SheetId::tiles).images[kFlaggedHalf].fill(1);
  level.roles.one_way = 6;
  level.sheet(SheetId::tiles).flags[kFlaggedHalf] = 1 << 6;
  EXPECT_THAT(lint_lines(level), ElementsAre("flag-idle: tile 10 has the flag of one-way, which changes "
                                             "nothing: it has no shape"));
}

TEST(LintSpawns, ABodyInAShapeOfItsOwn) {
  Level level = slope_level({"....", "....", ".ab.", "####"});
  level.spawns = {{"", {16, 12}, {}, "", BodyKind::player, {8, 8}}};  // b's floor is at 18 below its middle
  EXPECT_THAT(lint_lines(level), ElementsAre("spawn-in-slope: player 1 at 16, 12 px starts 2 px inside the "
                                             "shape of a tile"));
  for (const double y : {10.003, 10.0}) {  // the first by rounding
    level.spawns[0].position.y = y;
    EXPECT_THAT(lint_lines(level), IsEmpty()) << y;
  }
}

TEST(LintRules, EachHasAUniqueLabelAndCode) {
  for (const LintRule* rule : lint_rules()) {
    EXPECT_FALSE(rule->label.empty()) << rule->code;
    EXPECT_NE(group_of(*rule), nullptr) << rule->code;
    const auto same = std::count_if(lint_rules().begin(), lint_rules().end(),
                                    [&](const LintRule* other) { return other->code == rule->code; });
    EXPECT_EQ(same, 1) << rule->code;
  }
}

TEST(LintSeams, TheDemoHasOnlyTheProblemOfItsTour) {
  const auto demo = load_level(source_path("assets/demo.talus.json"));
  ASSERT_TRUE(demo);
  EXPECT_THAT(lint_lines(demo->level), ElementsAre("slope-unflagged: tile 7 is drawn like tile 3, an "
                                                   "up-slope, but nothing makes it one"));
}

// Their oddities are intended: ramps that end below a wall, and slopes of the article in a row.
TEST(LintSeams, HardCasesHaveFewProblems) {
  std::vector<std::string> lines;
  for (const auto& file : std::filesystem::directory_iterator(source_path("assets/hard_cases"))) {
    if (file.path().extension() != ".json") continue;
    const auto level = load_level(file.path().string());
    ASSERT_TRUE(level);
    for (const Problem& problem : lint(level->level)) {
      if (!problem.rule->code.starts_with("spawn-"))
        lines.push_back(file.path().filename().string().substr(0, 2) + " " + std::string(problem.rule->code) +
                        ": " + problem.message);
    }
  }
  EXPECT_THAT(
      lines,
      ElementsAre("12 too-steep: tile 12 rises 64 px in 8 px; more than 8 px is not a floor to stand on"));
}

}  // namespace talus::lint_seam_test
