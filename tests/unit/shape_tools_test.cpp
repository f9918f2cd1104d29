// The tool that lays slopes.
#include "edit/shape_tools.h"

#include <gtest/gtest.h>

namespace talus::shape_tools_test {

// Tile 1 is solid; 3 and 4 are the halves of the article's up-slope.
Level level_with_slopes() {
  Level level;
  level.map = TileMap(30, 17);
  Sheet& sheet = level.sheet(SheetId::tiles);
  for (int tile = 1; tile <= 4; ++tile) sheet.images[tile].fill(static_cast<std::uint8_t>(tile));
  sheet.flags[1] = 1;
  sheet.flags[3] = 4;
  return level;
}

Level after(Level level, const tl::expected<Edit, std::string>& edit) {
  apply_edit(level, edit.value());
  return level;
}

TEST(ShapeTools, SlopeUsesTheSlopesAndTheFullTileOfTheStamp) {
  const Level level = level_with_slopes();
  const Level laid = after(level, lay_slope(level, {16, 40}, {32, 32}, {3, 1, {3, 4, 1}}, 12));
  EXPECT_EQ(laid.map.at({2, 4}), 3);
  EXPECT_EQ(laid.map.at({3, 4}), 4);
  EXPECT_EQ(laid.map.at({2, 5}), 1);
  EXPECT_TRUE(laid.sheets == level.sheets);
}

TEST(ShapeTools, SlopeIsDrawnIfTheStampHasNone) {
  const Level level = level_with_slopes();
  const Level laid = after(level, lay_slope(level, {32, 32}, {16, 40}, {1, 1, {1}}, 12));
  const TileNumber drawn = laid.map.tile_at({2, 4});
  EXPECT_EQ(drawn, 5) << "the first blank one";
  EXPECT_EQ(laid.tile_shapes[drawn], (TileShape{.kind = TileShape::Kind::slope, .heights = {0, 4}}));
  EXPECT_EQ(laid.sheet(SheetId::tiles).images[drawn][7 * 8 + 1], 12) << "its edge";
  EXPECT_EQ(laid.map.at({2, 5}), 1);
}

TEST(ShapeTools, SlopeStaysInsideTheSelection) {
  const Level level = level_with_slopes();
  const CellRect selection{2, 0, 2, 17};
  const Level laid = after(level, lay_slope(level, {0, 48}, {64, 16}, {1, 1, {1}}, 12, selection));
  int shaped = 0, placed = 0;
  for (const TileShape& shape : laid.tile_shapes) shaped += shape.kind == TileShape::Kind::slope ? 1 : 0;
  for (int x = 0; x < 30; ++x) {
    for (int y = 0; y < 17; ++y) {
      if (laid.map.tile_at({x, y}) == 0) continue;
      EXPECT_TRUE(selection.contains({x, y})) << x << " " << y;
      placed += laid.map.tile_at({x, y}) != 1 ? 1 : 0;
    }
  }
  EXPECT_EQ(placed, 2);
  EXPECT_GE(shaped, 1);
  EXPECT_LE(shaped, placed);
  const Edit nothing = lay_slope(level, {0, 48}, {64, 16}, {1, 1, {1}}, 12, CellRect{20, 0, 2, 2}).value();
  EXPECT_TRUE(nothing.empty());
}

TEST(ShapeTools, SlopeThatCannotBeLaidSaysWhy) {
  Level level = level_with_slopes();
  EXPECT_EQ(lay_slope(level, {16, 40}, {16, 40}, {}, 12).error(), "drag from one end to the other");
  for (int tile = 1; tile < kCartTiles; ++tile) level.sheet(SheetId::tiles).images[tile].fill(3);
  EXPECT_EQ(lay_slope(level, {0, 8}, {8, 0}, {}, 12).error(),
            "there are too few blank tiles to draw the slope with");
}

}  // namespace talus::shape_tools_test
