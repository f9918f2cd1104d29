// The tools of the map.

#include <gtest/gtest.h>

#include "edit/map_fill.h"
#include "edit/map_rectangle.h"
#include "edit/map_stroke.h"
#include "edit/stamp.h"
#include "map_text.h"

namespace talus::map_tools_test {

using Rows = MapRows;
const Stamp kA{1, 1, {1}};
const Stamp kAb{2, 1, {1, 2}};
const Stamp kSquare{2, 2, {1, 2, 3, 4}};

TEST(MapTools, SpannedHasBothCornersInAnyOrder) {
  EXPECT_EQ(spanned({3, 1}, {1, 5}), (CellRect{1, 1, 3, 5}));
  EXPECT_EQ(spanned({2, 2}, {2, 2}), (CellRect{2, 2, 1, 1}));
}

TEST(MapTools, StampOfSheetNumbersTilesRowByRow) {
  EXPECT_EQ(stamp_of_sheet({}, {2, 1, 2, 2}), (Stamp{2, 2, {18, 19, 34, 35}}));
}

TEST(MapTools, StampOfSheetIsCutAtItsEdge) {
  EXPECT_EQ(stamp_of_sheet({}, {15, 15, 3, 3}), (Stamp{1, 1, {255}}));
  EXPECT_EQ(stamp_of_sheet({}, {-1, 0, 2, 1}), (Stamp{1, 1, {0}}));
  EXPECT_EQ(stamp_of_sheet({}, {16, 0, 1, 1}), Stamp{}) << "wholly outside";
}

TEST(MapTools, StampOfMapPicksAndIsCut) {
  const Level level = level_of_rows({"ab", "cd"});
  EXPECT_EQ(stamp_of_map(level, {0, 0, 2, 2}), kSquare);
  EXPECT_EQ(stamp_of_map(level, {1, 1, 5, 5}), (Stamp{1, 1, {4}}));
}

TEST(MapTools, PaintStampLeavesOutCellsOutsideTheMap) {
  const Level level = level_of_rows({"...", "..."});
  EXPECT_EQ(rows_after(level, paint_stamp(level, {1, 0}, kSquare)), (Rows{".ab", ".cd"}));
  EXPECT_EQ(rows_after(level, paint_stamp(level, {2, 1}, kSquare)), (Rows{"...", "..a"}));
  EXPECT_EQ(rows_after(level, paint_stamp(level, {-1, -1}, kSquare)), (Rows{"d..", "..."}));
}

TEST(MapTools, PaintingTheSameTilesIsAnEmptyEdit) {
  const Level level = level_of_rows({"a"});
  EXPECT_TRUE(paint_stamp(level, {0, 0}, kA).empty());
}

TEST(MapTools, StrokeIsALineWithoutGaps) {
  const Level level = level_of_rows({".....", ".....", "....."});
  EXPECT_EQ(rows_after(level, paint_stroke(level, {0, 0}, {0, 0}, {4, 2}, kA)),
            (Rows{"a....", ".aa..", "...aa"}));
}

//   anchor 1, stamp "ab": cells 1-2, 3-4 and 5-6 belong together, whatever cell of them the mouse is over
TEST(MapTools, StrokeTilesTheStampFromItsAnchor) {
  const Level level = level_of_rows({"........"});
  EXPECT_EQ(rows_after(level, paint_stroke(level, {1, 0}, {1, 0}, {4, 0}, kAb)), (Rows{".abab..."}));
  EXPECT_EQ(rows_after(level, paint_stroke(level, {5, 0}, {5, 0}, {2, 0}, kAb)), (Rows{".ababab."}));
}

TEST(MapTools, FillRectRepeatsTheStampFromTheCorner) {
  const Level level = level_of_rows({".....", ".....", "....."});
  EXPECT_EQ(rows_after(level, fill_rect(level, {1, 0, 3, 3}, kSquare)), (Rows{".aba.", ".cdc.", ".aba."}));
  EXPECT_EQ(rows_after(level, fill_rect(level, {-1, 0, 3, 1}, kAb)), (Rows{"ba...", ".....", "....."}))
      << "the corner counts even where it lies outside";
}

TEST(MapTools, FloodFillStopsAtOtherTilesAndCorners) {
  const Level level = level_of_rows({"..b..",  //
                                     ".b...",  //
                                     "b..b.",  //
                                     "..b.."});
  EXPECT_EQ(rows_after(level, flood_fill(level, {0, 0}, kA)), (Rows{"aab..", "ab...", "b..b.", "..b.."}));
  EXPECT_EQ(rows_after(level, flood_fill(level, {4, 0}, kA)), (Rows{"..baa", ".baaa", "baaba", "aabaa"}));
}

TEST(MapTools, FloodFillRepeatsTheStampFromTheClickedCell) {
  const Level level = level_of_rows({"....", "...."});
  EXPECT_EQ(rows_after(level, flood_fill(level, {1, 0}, kAb)), (Rows{"baba", "baba"}));
}

TEST(MapTools, FloodFillWithAStampThatHasTheOldTileEnds) {
  const Level level = level_of_rows({"aaaa"});
  EXPECT_EQ(rows_after(level, flood_fill(level, {0, 0}, kAb)), (Rows{"abab"}));
}

TEST(MapTools, FloodFillOutsideTheMapIsEmpty) {
  const Level level = level_of_rows({".."});
  EXPECT_TRUE(flood_fill(level, {2, 0}, kA).empty());
  EXPECT_TRUE(flood_fill(level, {0, -1}, kA).empty());
}

TEST(MapTools, EraseIsCutAtTheMapsEdge) {
  const Level level = level_of_rows({"abc", "abc"});
  EXPECT_EQ(rows_after(level, erase_cells(level, {1, -3, 9, 4})), (Rows{"a..", "abc"}));
  EXPECT_TRUE(erase_cells(level, {5, 5, 2, 2}).empty());
}

TEST(MapTools, ALargeEditHoldsTheMapInsteadOfEveryCell) {
  Level level;
  level.map = TileMap(100, 100);
  const Edit small = fill_rect(level, {0, 0, 16, 16}, kA);
  EXPECT_EQ(small.changes.size(), 256u);
  const Edit large = fill_rect(level, {0, 0, 100, 100}, kAb);
  ASSERT_EQ(large.changes.size(), 1u);
  const Level before = level;
  apply_edit(level, large);
  EXPECT_EQ(level.map.at({99, 99}), 2);
  revert_edit(level, large);
  EXPECT_TRUE(level == before);
}

// A recursive fill would run out of stack here.
TEST(MapTools, FloodFillsAMillionCells) {
  Level level;
  level.map = TileMap(4096, 256);
  const Edit edit = flood_fill(level, {2000, 100}, kA);
  apply_edit(level, edit);
  TileMap expected(4096, 256);
  for (TileNumber& tile : expected.cells().tiles()) tile = 1;
  EXPECT_TRUE(level.map == expected);
}

}  // namespace talus::map_tools_test
