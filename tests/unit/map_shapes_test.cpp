// Lines, rectangles, ellipses and fills of the map, inside a selection and without one.
#include <gtest/gtest.h>

#include "edit/map_ellipse.h"
#include "edit/map_fill.h"
#include "edit/map_rectangle.h"
#include "edit/map_replace.h"
#include "edit/map_stroke.h"
#include "edit/raster.h"
#include "map_text.h"

namespace talus::map_shapes_test {

const Stamp kShapeA{1, 1, {1}};
const Stamp kShapeAb{2, 1, {1, 2}};

TEST(MapShapes, EllipseTouchesAllSidesAndIsSymmetric) {
  const Level level = level_of_rows(MapRows(5, "......."));
  EXPECT_EQ(rows_after(level, fill_ellipse(level, {0, 0, 7, 5}, kShapeA)),
            (MapRows{".aaaaa.", "aaaaaaa", "aaaaaaa", "aaaaaaa", ".aaaaa."}));
  EXPECT_EQ(rows_after(level, fill_ellipse(level, {1, 1, 4, 4}, kShapeA)),
            (MapRows{".......", "..aa...", ".aaaa..", ".aaaa..", "..aa..."}));
  EXPECT_EQ(rows_after(level, fill_ellipse(level, {2, 2, 1, 1}, kShapeA))[2], "..a....");
}

TEST(MapShapes, ThinEllipseHasNoGaps) {
  for (const auto& [w, h] : {std::pair(1, 9), {2, 30}, {3, 41}, {4, 100}}) {
    const std::vector<Span> spans = ellipse_spans(w, h);
    ASSERT_EQ(spans.size(), static_cast<std::size_t>(h));
    for (const Span& span : spans) {
      EXPECT_LE(span.first, span.last) << w << "x" << h << " row " << span.y;
      EXPECT_EQ(span.first + span.last, w - 1) << "symmetric";
    }
  }
}

TEST(MapShapes, OutlineOfAnEllipseIsClosedAndHollow) {
  const Level level = level_of_rows(MapRows(7, "........."));
  EXPECT_EQ(
      rows_after(level, outline_ellipse(level, {0, 0, 9, 7}, kShapeA)),
      (MapRows{"..aaaaa..", ".a.....a.", "a.......a", "a.......a", "a.......a", ".a.....a.", "..aaaaa.."}));
}

TEST(MapShapes, OutlineOfARectangleLeavesItsInside) {
  const Level level = level_of_rows({".....", ".....", ".....", "....."});
  EXPECT_EQ(rows_after(level, outline_rect(level, {1, 0, 4, 4}, kShapeA)),
            (MapRows{".aaaa", ".a..a", ".a..a", ".aaaa"}));
  EXPECT_EQ(rows_after(level, outline_rect(level, {0, 1, 5, 1}, kShapeAb))[1], "ababa");
  EXPECT_EQ(rows_after(level, outline_rect(level, {2, 0, 1, 3}, kShapeA)),
            (MapRows{"..a..", "..a..", "..a..", "....."}));
  EXPECT_EQ(rows_after(level, outline_rect(level, {-1, -1, 3, 3}, kShapeA)),
            (MapRows{".a...", "aa...", ".....", "....."}))
      << "what is outside is left out";
}

TEST(MapShapes, ShapesStayInsideTheSelection) {
  const Level level = level_of_rows({".....", ".....", "....."});
  const CellRect selection{1, 1, 2, 2};
  EXPECT_EQ(rows_after(level, fill_rect(level, {0, 0, 5, 2}, kShapeAb, selection)),
            (MapRows{".....", ".ba..", "....."}))
      << "the pattern begins at the rectangle's corner all the same";
  EXPECT_EQ(rows_after(level, paint_stroke(level, {0, 1}, {0, 1}, {4, 1}, kShapeA, selection)),
            (MapRows{".....", ".aa..", "....."}));
  EXPECT_EQ(rows_after(level, outline_rect(level, {0, 0, 3, 3}, kShapeA, selection)),
            (MapRows{".....", "..a..", ".aa.."}));
  EXPECT_EQ(rows_after(level, fill_ellipse(level, {0, 0, 5, 3}, kShapeA, selection)),
            (MapRows{".....", ".aa..", ".aa.."}));
}

TEST(MapShapes, FillDoesNotGoAroundOutsideTheSelection) {
  const Level level = level_of_rows({".....", ".b.b.", ".b.b."});
  EXPECT_EQ(rows_after(level, flood_fill(level, {0, 2}, kShapeA, CellRect{0, 1, 5, 2})),
            (MapRows{".....", "ab.b.", "ab.b."}))
      << "the other columns are reached only outside the selection";
  EXPECT_TRUE(flood_fill(level, {0, 0}, kShapeA, CellRect{0, 1, 5, 2}).empty());
}

TEST(MapShapes, ReplaceChangesTheTileEverywhereWithThePattern) {
  const Level level = level_of_rows({"c.c..", ".ccc."});
  EXPECT_EQ(rows_after(level, replace_tile(level, 3, {1, 1}, kShapeAb)), (MapRows{"b.b..", ".aba."}));
  EXPECT_EQ(rows_after(level, replace_tile(level, 3, {0, 0}, kShapeA, CellRect{0, 1, 3, 9})),
            (MapRows{"c.c..", ".aac."}));
}

}  // namespace talus::map_shapes_test
