// The C header: cc compiles it without a warning, and its floors are those of the collision core.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include <talus/level/ground.h>
#include "collision/ground_queries.h"
#include "folder_test.h"
#include "paths.h"
#include "property/random_ground.h"
#include "unit/exported_level.h"
#include "unit/program_output.h"

namespace talus::export_c_test {

using ::testing::HasSubstr;

std::string header(const Level& level, const std::string& name = "cave.h") {
  const auto files = exported("c", level, name);
  return files ? files->files[0].bytes : files.error().message;
}

TEST(ExportC, NamesComeFromTheFiles) {
  EXPECT_THAT(header(Level(), "My-Cave 2.h"), HasSubstr("#ifndef MY_CAVE_2_INCLUDED\n"));
  EXPECT_THAT(header(Level(), "2.h"), HasSubstr("static const uint8_t level_2_map[LEVEL_2_HEIGHT]"));
  EXPECT_THAT(header(Level(), "-"), HasSubstr("#define LEVEL_WIDTH 240\n"));
  EXPECT_THAT(header(Level(), "H\u00f6hle 1 \u2013 \u2603.h"), HasSubstr("#define H_HLE_1_WIDTH 240\n"));
}

TEST(ExportC, HoldsFloorsAndSlopesIn256ths) {
  const std::string text = header(level_of_shapes({"25"}));
  EXPECT_THAT(text, HasSubstr("cave_map[CAVE_HEIGHT][CAVE_WIDTH] = {\n{2,5},\n};"));
  EXPECT_THAT(text, HasSubstr("\n{2,0,0,1,2,2,1,-256,2048},\n"));  // tile 2: down a px each px
  EXPECT_THAT(text, HasSubstr("\n{2,0,0,3,5,11,1,-85,2048},\n"));  // tile 5: three tiles wide
  EXPECT_THAT(text, HasSubstr("_ys[] = {0,0,2048,0,0,2048,2048,1024,512,1024,2048,2048,0,0,2048,"));
  EXPECT_THAT(text, HasSubstr("cave_floors[23][8] = {"));
  EXPECT_THAT(text, HasSubstr("\n{1920,1664,1408,1152,896,640,384,128},\n"));  // tile 2
  EXPECT_THAT(text, HasSubstr("#define CAVE_WIDEST 8\n#define CAVE_HIGHEST 8\n"));
}

TEST(ExportC, SaysWhatItsTablesHold) {
  const std::string text = header(Level());
  EXPECT_THAT(text, HasSubstr("bit n is flag n, of CAVE_FLAG_SOLID and the like. */\n"
                              "static const uint8_t cave_map["));
  for (const char* const table : {"cave_shape;", "cave_ys[]", "cave_floors["}) {
    const std::size_t at = text.find(table);
    ASSERT_NE(at, text.npos) << table;
    EXPECT_NE(text.rfind("/*", at), text.npos) << table;
  }
}

TEST(ExportC, TilesOfOneShapeShareItsRows) {
  Level level;
  level.map = TileMap(40, 20);
  for (const std::size_t tile : {3u, 7u, 200u}) level.tile_shapes[tile] = {.kind = TileShape::Kind::solid};
  const std::string text = header(level);
  EXPECT_THAT(text, HasSubstr("cave_shape_of[256] = {0,0,0,1,0,0,0,1,0,"));
  EXPECT_THAT(text, HasSubstr("cave_shapes[2] = {\n{0,0,0,0,0,0,0,0,0},\n{1,0,0,1,1,0,1,0,0},\n};\n"));
  EXPECT_THAT(text, HasSubstr("cave_floors[2][8] = {\n"));
  EXPECT_LT(text.size(), 9000u) << "it was 16 KB, mostly rows of tiles without floors";
}

TEST(ExportC, WithoutShapesThereIsNoFloor) {
  Level bare;
  bare.map = TileMap(1, 1);
  EXPECT_THAT(header(bare), HasSubstr("_ys[] = {0};"));
  EXPECT_THAT(header(bare), HasSubstr("#define CAVE_WIDEST 1\n#define CAVE_HIGHEST 1\n"));
}

TEST(ExportC, CurvesAreDroppedWithAWarning) {
  Level level;
  level.curves.push_back({"", {Segment{{0, 0}, {8, 0}}, Curve::Faces::up}, ""});
  EXPECT_EQ(exported("c", level, "cave.h")->dropped, std::vector<std::string>{"1 curve"});
  level.curves.push_back(level.curves[0]);
  EXPECT_EQ(exported("c", level, "cave.h")->dropped, std::vector<std::string>{"2 curves"});
}

// A curve that is not there has no speed.
TEST(ExportC, ConveyorsAreDroppedWithAWarning) {
  EXPECT_EQ(exported("c", level_of_conveyors(), "cave.h")->dropped,
            (std::vector<std::string>{"1 curve", "the speeds of 2 conveyors"}));
}

TEST(ExportC, AMapTooLongForFixedPointIsRefused) {
  Level level;
  level.map = TileMap(1 << 20, 1);
  EXPECT_THAT(header(level), HasSubstr("longer than 1048575 cells"));
}

// Compiles the header of a level into a program that prints floors.
class ExportCFloors : public FolderTest {
 protected:
  // The output of the program, or of the compiler if it printed something.
  std::string run(const Level& level, const std::vector<Vec2>& points) {
    put("cave.h", header(level));
    std::string input;
    for (const Vec2 p : points) input += std::to_string(fixed(p.x)) + " " + std::to_string(fixed(p.y)) + "\n";
    put("input", input);
    return output_of("cd '" + folder_.string() +
                     "' && cc -std=c99 -Wall -Wextra -pedantic -Werror -I. -o floors '" +
                     source_path("tests/games/c_header_main.c") + "' 2>&1 && ./floors <input");
  }

  // Compares floors at points in the air with those of the core. Returns the number of floors.
  int expect_floors_of_the_core(const Level& level, const std::vector<Vec2>& points, double error) {
    const Terrain ground{ground_of(level)};
    std::istringstream printed(run(level, points));
    std::string line;
    const std::string last_head(solver_name(level.tuning.solver));
    while (std::getline(printed, line) && !line.starts_with(last_head)) {
    }
    int floors = 0;
    for (const Vec2 p : points) {
      std::getline(printed, line);
      const auto floor = floor_below(ground, {p.x, p.y, 0, 0}, 1e6);
      if (overlaps_ground(ground, {p.x - 0.01, p.y - 0.01, 0.02, 0.02})) continue;
      const double y = std::stod(line) / 256;
      if (!floor) {
        EXPECT_EQ(line, std::to_string(INT32_MAX)) << p.x << "," << p.y;
        continue;
      }
      EXPECT_NEAR(y, floor->y, error) << p.x << "," << p.y;
      ++floors;
    }
    return floors;
  }

  static std::int64_t fixed(double px) { return std::llround(px * 256); }
};

TEST_F(ExportCFloors, TablesBodiesAndTuningAreRead) {
  Level level = level_of_shapes({"..", ".7"});
  level.sheet(SheetId::tiles).flags[7] = 129;
  level.sheet(SheetId::sprites).flags[255] = 3;
  const std::string tuning = "exact 0.074999999999999997 0 3.5\n";
  EXPECT_EQ(run(level, {{12, 0}, {4, 0}, {12, 9}}),
            "7 129 3 0\n  -1 0 0 0\n" + tuning + "2048\n2147483647\n2147483647\n");
  Spawn& spawn = level.spawns.emplace_back();
  spawn.name = "a\"?\?/b";
  spawn.position = {1.5, 0};
  spawn.kind = BodyKind::player;
  level.sheet(SheetId::tiles).flags[60] = 2;  // a ball
  level.map.set({1, 0}, 60);
  EXPECT_EQ(run(level, {}),
            "7 129 3 0\n ball 60 0 2048 0\na\"?\?/b player -1 1 384 0\n  -1 0 0 0\n" + tuning);
}

TEST_F(ExportCFloors, AreExactInTheDemo) {
  const Level level = load_level(source_path("assets/demo.talus.json"))->level;
  std::vector<Vec2> points;
  for (int y = 0; y < kScreenRows * kCartTileSize; y += 8)
    for (int x = 0; x < kScreenColumns * kCartTileSize; ++x) points.push_back({x + 0.5, y + 0.25});
  EXPECT_GT(expect_floors_of_the_core(level, points, 0), 500);
}

TEST_F(ExportCFloors, AreWithinA256thOnRandomGround) {
  Dice dice(6);
  int floors = 0;
  for (int round = 0; round < 5; ++round) {
    Level level = level_of_shapes(std::vector<std::string>(12, std::string(16, '.')));
    for (TileNumber& cell : level.map.cells().tiles())
      if (dice.one_in(4)) cell = static_cast<std::uint8_t>(dice.up_to(12));
    std::vector<Vec2> points;
    for (int i = 0; i < 1000; ++i)
      points.push_back({dice.up_to(127) + dice.up_to(254) / 256.0 + 1 / 256.0, dice.step(0, 96, 256)});
    floors += expect_floors_of_the_core(level, points, 1.0 / 256);
  }
  EXPECT_GT(floors, 1000);
}

}  // namespace talus::export_c_test
