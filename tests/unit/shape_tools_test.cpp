// The tool that lays slopes.
#include "edit/shape_tools.h"

#include <gtest/gtest.h>

namespace talus::shape_tools_test {

// Tile 1 is solid; 3 and 4 are the two halves of the article's up-slope.
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

TEST(ShapeTools, SlopeIsLaidOfTheStampsSlopesWithItsFullTileBelow) {
  const Level level = level_with_slopes();
  const Level laid = after(level, lay_slope(level, {16, 40}, {32, 32}, {3, 1, {3, 4, 1}}, 12));
  EXPECT_EQ(laid.map.at({2, 4}), 3);
  EXPECT_EQ(laid.map.at({3, 4}), 4);
  EXPECT_EQ(laid.map.at({2, 5}), 1);
  EXPECT_TRUE(laid.sheets == level.sheets);
}

TEST(ShapeTools, SlopeIsDrawnWhereTheStampHasNone) {
  const Level level = level_with_slopes();
  const Level laid = after(level, lay_slope(level, {32, 32}, {16, 40}, {1, 1, {1}}, 12));
  const std::uint8_t drawn = laid.map.at({2, 4});
  EXPECT_EQ(drawn, 5) << "the first blank one";
  EXPECT_EQ(laid.tile_shapes[drawn], (TileShape{.kind = TileShape::Kind::slope, .heights = {0, 4}}));
  EXPECT_EQ(laid.sheet(SheetId::tiles).images[drawn][7 * 8 + 1], 12) << "its edge";
  EXPECT_EQ(laid.map.at({2, 5}), 1);
}

TEST(ShapeTools, SlopeThatCannotBeLaidSaysWhy) {
  Level level = level_with_slopes();
  EXPECT_EQ(lay_slope(level, {16, 40}, {16, 40}, {}, 12).error(), "drag from one end to the other");
  for (int tile = 1; tile < kTileCount; ++tile) level.sheet(SheetId::tiles).images[tile].fill(3);
  EXPECT_EQ(lay_slope(level, {0, 8}, {8, 0}, {}, 12).error(),
            "there are too few blank tiles to draw the slope with");
}

}  // namespace talus::shape_tools_test
