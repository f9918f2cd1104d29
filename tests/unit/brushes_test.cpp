// Named brushes and random painting, and how files keep them.
#include "edit/brush_tools.h"

#include <gtest/gtest.h>

#include <set>

#include "edit/auto_tile.h"
#include "native_text.h"

namespace talus::brushes_test {

const Stamp kFour{2, 2, {7, 8, 9, 10}};

Level empty_map(int width, int height) {
  Level level;
  level.map = TileMap(width, height);
  return level;
}

TEST(RandomTile, IsTheSameForACellAndASeed) {
  EXPECT_EQ(random_tile(kFour, {3, 4}, 1), random_tile(kFour, {3, 4}, 1));
  EXPECT_EQ(random_tile({1, 1, {5}}, {3, 4}, 1), 5);
  std::vector<int> row;
  for (int x = 0; x < 8; ++x) row.push_back(random_tile(kFour, {x, 0}, 1).tile);
  EXPECT_EQ(row, (std::vector<int>{8, 10, 10, 9, 9, 8, 7, 10})) << "files and tests rely on the very tiles";
}

TEST(RandomTile, TakesEachTileEquallyOften) {
  std::array<int, 4> counts{};
  int unlike_the_next_seed = 0;
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 100; ++x) {
      ++counts[static_cast<std::size_t>(random_tile(kFour, {x, y}, 1).tile - 7)];
      unlike_the_next_seed += random_tile(kFour, {x, y}, 1) != random_tile(kFour, {x, y}, 2) ? 1 : 0;
    }
  }
  for (const int count : counts) EXPECT_NEAR(count, 2500, 200);
  EXPECT_NEAR(unlike_the_next_seed, 7500, 200);
}

TEST(RandomTile, AStrokeStaysInsideTheSelection) {
  Level level = empty_map(6, 3);
  apply_edit(level, paint_random_stroke(level, {0, 1}, {5, 1}, kFour, 1, CellRect{2, 0, 2, 3}));
  for (int x = 0; x < 6; ++x)
    EXPECT_EQ(level.map.tile_at({x, 1}), x == 2 || x == 3 ? random_tile(kFour, {x, 1}, 1) : 0) << x;
}

TEST(RandomTile, AStrokePaintsEachCellOnceAndUndoesExactly) {
  Level level = empty_map(6, 3);
  const Edit edit = paint_random_stroke(level, {0, 1}, {9, 1}, kFour, 1);
  apply_edit(level, edit);
  for (int x = 0; x < 6; ++x) EXPECT_EQ(level.map.tile_at({x, 1}), random_tile(kFour, {x, 1}, 1));
  EXPECT_EQ(level.map.at({0, 0}), 0);
  EXPECT_TRUE(paint_random_stroke(level, {5, 1}, {0, 1}, kFour, 1).empty()) << "the same tiles again";
  revert_edit(level, edit);
  EXPECT_EQ(level, empty_map(6, 3));
}

TEST(RandomTile, ARectangleIsFilledAndCutAtTheMap) {
  Level level = empty_map(3, 3);
  apply_edit(level, fill_rect_at_random(level, {1, 1, 50, 50}, kFour, 9));
  EXPECT_EQ(level.map.at({0, 1}), 0);
  EXPECT_EQ(level.map.tile_at({2, 2}), random_tile(kFour, {2, 2}, 9));
  EXPECT_TRUE(fill_rect_at_random(level, {3, 0, 2, 2}, kFour, 9).empty());
}

TEST(Brushes, AStampComesBackAsItWas) {
  const Brush brush = brush_of_stamp(kFour, "bush", true);
  EXPECT_EQ(brush, (Brush{"bush", 2, 2, {7, 8, 9, 10}, true, {}}));
  EXPECT_EQ(stamp_of_brush(brush), kFour);
}

TEST(Brushes, AHugeStampIsCutToTheLimit) {
  Stamp stamp{300, 2, std::vector<MapCell>(600, 1)};
  stamp.tiles[300] = 2;
  const Brush brush = brush_of_stamp(stamp, "", false);
  EXPECT_EQ(brush.w, kMaxBrushSide);
  EXPECT_EQ(brush.tiles.size(), 512u);
  EXPECT_EQ(brush.tiles[256], 2) << "the second row";
}

TEST(Brushes, AreAddedRenamedAndDeleted) {
  Level level;
  EXPECT_EQ(free_brush_name(level), "Brush 1");
  apply_edit(level, add_brush(level, brush_of_stamp(kFour, "Brush 2", false)));
  EXPECT_EQ(free_brush_name(level), "Brush 3") << "2 is taken";
  const Edit rename = rename_brush(level, 0, "bush");
  apply_edit(level, rename);
  EXPECT_EQ(level.brushes[0].name, "bush");
  EXPECT_TRUE(rename_brush(level, 0, "bush").empty());
  EXPECT_TRUE(rename_brush(level, 1, "none").empty());
  EXPECT_TRUE(remove_brush(level, -1).empty());
  const Edit removal = remove_brush(level, 0);
  apply_edit(level, removal);
  EXPECT_TRUE(level.brushes.empty());
  revert_edit(level, removal);
  revert_edit(level, rename);
  EXPECT_EQ(level.brushes, (std::vector<Brush>{brush_of_stamp(kFour, "Brush 2", false)}));
}

TEST(Brushes, ALongNameIsCutBetweenCharacters) {
  Level level;
  level.brushes = {brush_of_stamp(kFour, "", false)};
  std::string name(999, 'a');
  apply_edit(level, rename_brush(level, 0, name + "\xC3\xA9"));  // e with an accent, two bytes
  EXPECT_EQ(level.brushes[0].name, name);
}

TEST(Brushes, AFullListRefusesAnotherBrush) {
  Level level;
  level.brushes.resize(kMaxBrushes);
  EXPECT_TRUE(add_brush(level, {}).empty());
}

// --- Files

void expect_brush_error(const std::string& members, const std::string& place, const std::string& message) {
  expect_native_error(native_with(members), place, message);
}

TEST(NativeBrushes, ComeBackAsTheyWereWithUnknownKeys) {
  Level level;
  level.brushes = {brush_of_stamp(kFour, "bush", true),
                   {"", 3, 1, {0, 255, 0}, false, R"({"colour":"red"})"}};
  level.auto_tiles.of(GroundPart::inside) = 16;
  level.auto_tiles.of(GroundPart::slope_down_right) = 255;
  const std::string text = native_of_level(level);
  const Level read = level_of_native(text);
  EXPECT_EQ(read, level);
  EXPECT_EQ(native_of_level(read), text);
  EXPECT_NE(text.find(R"(
  "brushes": [
    {
      "name": "bush",
      "random": true,
      "rows": [
        "0708",
        "090a"
      ]
    },
    {
      "name": "",
      "rows": [
        "..ff.."
      ],
      "colour": "red"
    }
  ],)"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find(R"("auto_tiles": {"inside": 16, "slope_down_right": 255})"), std::string::npos) << text;
}

TEST(NativeBrushes, AnEmptyListIsNotWritten) {
  const std::string text = native_of_level(Level());
  EXPECT_EQ(text.find("brushes"), std::string::npos);
  EXPECT_EQ(text.find("auto_tiles"), std::string::npos);
}

TEST(NativeBrushes, PartsOfNewerVersionsAreKept) {
  const std::string text = R"({"talus": 1, "auto_tiles": {"inside": 3, "inner_corner": 4}})";
  const std::string again = native_of_level(level_of_native(text));
  EXPECT_NE(again.find(R"("auto_tiles": {"inside": 3, "inner_corner": 4})"), std::string::npos) << again;
}

TEST(NativeBrushes, ErrorsNameThePlace) {
  expect_brush_error(R"("brushes": {})", "key brushes", "must be a list of up to 1000 brushes");
  expect_brush_error(R"("brushes": [3])", "key brushes[0]", "must be an object");
  expect_brush_error(R"("brushes": [{"rows": ["01"]}, {"name": 5, "rows": ["01"]}])", "key brushes[1].name",
                     "must be a string of up to 1000 bytes");
  expect_brush_error(R"("brushes": [{}])", "key brushes[0].rows", "is missing");
  expect_brush_error(R"("brushes": [{"rows": []}])", "key brushes[0].rows",
                     "must be a list of 1 to 256 rows");
  expect_brush_error(R"("brushes": [{"rows": ["0"]}])", "key brushes[0].rows",
                     "must have rows of 1 to 256 cells, with two characters each");
  expect_brush_error(R"("brushes": [{"rows": ["01", "0102"]}])", "key brushes[0].rows",
                     "must have rows of the same length");
  expect_brush_error(R"("brushes": [{"rows": ["0g"]}])", "key brushes[0].rows",
                     "has a cell that is not two hexadecimal digits");
  expect_brush_error(R"("brushes": [{"random": 1, "rows": ["01"]}])", "key brushes[0].random",
                     "must be true or false");
  expect_brush_error(R"("auto_tiles": 1)", "key auto_tiles", "must be an object");
  expect_brush_error(R"("auto_tiles": {"top": 0})", "key auto_tiles.top",
                     "must be a tile number from 1 to 255");
  expect_brush_error(R"("auto_tiles": {"top": 256})", "key auto_tiles.top",
                     "must be a tile number from 1 to 255");
}

}  // namespace talus::brushes_test
