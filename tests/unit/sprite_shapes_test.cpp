// Lines, rectangles and ellipses of pixels.
#include "edit/sprite_shapes.h"

#include <gtest/gtest.h>

#include "sprite_picture.h"

namespace talus::sprite_shapes_test {

const SpriteArea kShapeTile{SheetId::tiles, {5, 0, 1, 1}};

std::string shape_drawn_by(const Edit& edit) {
  Level level;
  apply_edit(level, edit);
  EXPECT_TRUE(level.sheet(SheetId::tiles).images[4] == TileImage{}) << "beside the canvas";
  return picture_of(level, kShapeTile);
}

TEST(SpriteShapes, BrushIsCentredOnThePixel) {
  EXPECT_EQ(brush_at({4, 4}, 1), (CellRect{4, 4, 1, 1}));
  EXPECT_EQ(brush_at({4, 4}, 2), (CellRect{4, 4, 2, 2}));
  EXPECT_EQ(brush_at({4, 4}, 3), (CellRect{3, 3, 3, 3}));
  EXPECT_EQ(brush_at({4, 4}, 4), (CellRect{3, 3, 4, 4}));
}

TEST(SpriteShapes, LineWithABrushIsAsThickAndCutAtTheEdge) {
  EXPECT_EQ(shape_drawn_by(draw_line(Level(), kShapeTile, {-3, 0}, {4, 0}, {7, 2})),
            "777777..\n777777..\n........\n........\n........\n........\n........\n........\n");
  const Edit edit = draw_line(Level(), kShapeTile, {2, 2}, {5, 5}, {1, 4});
  EXPECT_EQ(shape_drawn_by(edit),
            "........\n.1111...\n.11111..\n.111111.\n.1111111\n..111111\n...11111\n....1111\n");
  EXPECT_EQ(edit.changes.size(), 37u) << "each pixel once";
}

TEST(SpriteShapes, RectangleIsAnOutlineOrFilled) {
  EXPECT_EQ(shape_drawn_by(draw_rectangle(Level(), kShapeTile, {6, 5}, {1, 2}, {3, 1}, false)),
            "........\n........\n.333333.\n.3....3.\n.3....3.\n.333333.\n........\n........\n");
  EXPECT_EQ(shape_drawn_by(draw_rectangle(Level(), kShapeTile, {1, 2}, {6, 5}, {3, 1}, true)),
            "........\n........\n.333333.\n.333333.\n.333333.\n.333333.\n........\n........\n");
  EXPECT_EQ(shape_drawn_by(draw_rectangle(Level(), kShapeTile, {-4, -4}, {1, 20}, {3, 1}, false)),
            ".3......\n.3......\n.3......\n.3......\n.3......\n.3......\n.3......\n.3......\n");
}

TEST(SpriteShapes, EllipseTouchesTheSidesOfItsBox) {
  EXPECT_EQ(shape_drawn_by(draw_ellipse(Level(), kShapeTile, {0, 0}, {7, 7}, {5, 1}, false)),
            "..5555..\n.5....5.\n5......5\n5......5\n5......5\n5......5\n.5....5.\n..5555..\n");
  EXPECT_EQ(shape_drawn_by(draw_ellipse(Level(), kShapeTile, {7, 5}, {0, 2}, {5, 1}, true)),
            "........\n........\n.555555.\n55555555\n55555555\n.555555.\n........\n........\n");
  EXPECT_EQ(shape_drawn_by(draw_ellipse(Level(), kShapeTile, {3, 3}, {3, 3}, {5, 1}, false)),
            "........\n........\n........\n...5....\n........\n........\n........\n........\n");
}

TEST(SpriteShapes, OutlineTakesTheBrush) {
  EXPECT_EQ(shape_drawn_by(draw_rectangle(Level(), kShapeTile, {1, 1}, {6, 6}, {2, 2}, false)),
            "........\n.2222222\n.2222222\n.22...22\n.22...22\n.22...22\n.2222222\n.2222222\n");
}

TEST(SpriteShapes, StraightLinesAreLevelUprightOrDiagonal) {
  EXPECT_EQ(straightened({2, 2}, {9, 3}), (Cell{9, 2}));
  EXPECT_EQ(straightened({2, 2}, {3, -9}), (Cell{2, -9}));
  EXPECT_EQ(straightened({2, 2}, {-2, 5}), (Cell{-2, 6}));
  EXPECT_EQ(squared({2, 2}, {7, 3}), (Cell{7, 7}));
  EXPECT_EQ(squared({2, 2}, {1, -4}), (Cell{-4, -4}));
}

}  // namespace talus::sprite_shapes_test
