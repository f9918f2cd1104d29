// The tools of the sprite canvas, the flags and the palette.
#include "edit/flag_lamps.h"
#include "edit/level_settings.h"
#include "edit/sprite_area.h"
#include "edit/sprite_clear.h"
#include "edit/sprite_fill.h"
#include "edit/sprite_turn.h"

#include <gtest/gtest.h>

#include "edit/sprite_shapes.h"

namespace talus::sprite_tools_test {

const SpriteArea kOne{SheetId::tiles, {1, 0, 1, 1}};     // tile 1
const SpriteArea kFour{SheetId::sprites, {2, 1, 2, 2}};  // sprites 18, 19, 34 and 35

Level with(Level level, const Edit& edit) {
  apply_edit(level, edit);
  return level;
}

// Pixels (0, 0), (1, 0) and (0, 1) of the area get the colours 1, 2 and 3, so that the picture has no
// symmetry.
Level with_corner(const SpriteArea& area) {
  Level level;
  level = with(level, draw_line(level, area, {0, 0}, {0, 0}, {1}));
  level = with(level, draw_line(level, area, {1, 0}, {1, 0}, {2}));
  return with(level, draw_line(level, area, {0, 1}, {0, 1}, {3}));
}

TEST(SpriteTools, AnAreaIsOnePictureOfItsTiles) {
  Level level;
  level = with(level, draw_line(level, kFour, {7, 8}, {8, 8}, {5}));
  EXPECT_EQ(level.sheet(SheetId::sprites).images[34][7], 5);
  EXPECT_EQ(level.sheet(SheetId::sprites).images[35][0], 5);
  EXPECT_EQ(pixel_at(level, kFour, 7, 8), 5);
  EXPECT_EQ(pixel_at(level, kFour, 7, 7), 0);
}

TEST(SpriteTools, LineHasBothEndsAndIsCutAtTheArea) {
  Level level;
  EXPECT_EQ(draw_line(level, kOne, {0, 0}, {7, 7}, {4}).changes.size(), 8u);
  level = with(level, draw_line(level, kOne, {-3, 2}, {20, 2}, {4}));
  for (int x = 0; x < 8; ++x) EXPECT_EQ(pixel_at(level, kOne, x, 2), 4);
  EXPECT_EQ(level.sheet(SheetId::tiles).images[0][23], 0) << "the neighbour must stay as it is";
  EXPECT_EQ(level.sheet(SheetId::tiles).images[2][16], 0);
}

TEST(SpriteTools, DrawingInTheSameColourIsAnEmptyEdit) {
  EXPECT_TRUE(draw_line(Level(), kOne, {0, 0}, {7, 0}, {0}).empty());
}

TEST(SpriteTools, FillStopsAtOtherColours) {
  Level level;
  level = with(level, draw_line(level, kOne, {3, 0}, {3, 7}, {9}));
  level = with(level, fill_pixels(level, kOne, {0, 0}, 6));
  EXPECT_EQ(pixel_at(level, kOne, 2, 7), 6);
  EXPECT_EQ(pixel_at(level, kOne, 3, 4), 9);
  EXPECT_EQ(pixel_at(level, kOne, 4, 0), 0);
}

TEST(SpriteTools, FillStaysInTheTilesOfTheArea) {
  Level level;
  const Edit edit = fill_pixels(level, kFour, {0, 0}, 6);
  EXPECT_EQ(edit.changes.size(), 256u);
  EXPECT_TRUE(fill_pixels(level, kFour, {16, 0}, 6).empty()) << "outside";
}

TEST(SpriteTools, ReplaceColorIgnoresConnection) {
  Level level = with_corner(kOne);
  level = with(level, draw_line(level, kOne, {7, 7}, {7, 7}, {1}));
  level = with(level, replace_color(level, kOne, 1, 8));
  EXPECT_EQ(pixel_at(level, kOne, 0, 0), 8);
  EXPECT_EQ(pixel_at(level, kOne, 7, 7), 8);
  EXPECT_EQ(pixel_at(level, kOne, 1, 0), 2);
}

TEST(SpriteTools, FlipHorizontalMirrorsTheWholeArea) {
  Level level = with_corner(kFour);
  level = with(level, turn_pixels(level, kFour, PixelTurn::flip_horizontal));
  EXPECT_EQ(pixel_at(level, kFour, 15, 0), 1);
  EXPECT_EQ(pixel_at(level, kFour, 14, 0), 2);
  EXPECT_EQ(pixel_at(level, kFour, 15, 1), 3);
  EXPECT_EQ(pixel_at(level, kFour, 0, 0), 0);
}

TEST(SpriteTools, FlipVerticalMirrorsTheWholeArea) {
  Level level = with_corner(kFour);
  level = with(level, turn_pixels(level, kFour, PixelTurn::flip_vertical));
  EXPECT_EQ(pixel_at(level, kFour, 0, 15), 1);
  EXPECT_EQ(pixel_at(level, kFour, 1, 15), 2);
  EXPECT_EQ(pixel_at(level, kFour, 0, 14), 3);
}

//   1 2 .        . 3 1
//   3 . .   ->   . . 2
//   . . .        . . .
TEST(SpriteTools, RotateIsClockwise) {
  Level level = with_corner(kFour);
  level = with(level, turn_pixels(level, kFour, PixelTurn::rotate));
  EXPECT_EQ(pixel_at(level, kFour, 15, 0), 1);
  EXPECT_EQ(pixel_at(level, kFour, 15, 1), 2);
  EXPECT_EQ(pixel_at(level, kFour, 14, 0), 3);
}

TEST(SpriteTools, FourRotationsGiveThePictureBack) {
  const Level level = with_corner(kFour);
  Level turned = level;
  for (int i = 0; i < 4; ++i) turned = with(turned, turn_pixels(turned, kFour, PixelTurn::rotate));
  EXPECT_TRUE(turned == level);
}

TEST(SpriteTools, ShiftedPixelsReenterAtTheOtherSide) {
  Level level = with_corner(kFour);
  level = with(level, turn_pixels(level, kFour, PixelTurn::shift_left));
  EXPECT_EQ(pixel_at(level, kFour, 15, 0), 1);
  EXPECT_EQ(pixel_at(level, kFour, 0, 0), 2);
  EXPECT_EQ(pixel_at(level, kFour, 15, 1), 3);
  level = with(level, turn_pixels(level, kFour, PixelTurn::shift_up));
  EXPECT_EQ(pixel_at(level, kFour, 15, 15), 1);
  EXPECT_EQ(pixel_at(level, kFour, 15, 0), 3);
  level = with(level, turn_pixels(level, kFour, PixelTurn::shift_right));
  level = with(level, turn_pixels(level, kFour, PixelTurn::shift_down));
  EXPECT_TRUE(level == with_corner(kFour));
}

TEST(SpriteTools, ClearPixelsLeavesTheFlagsAndWhatLiesBeside) {
  Level level = with_corner(kOne);
  level.sheet(SheetId::tiles).flags[1] = 7;
  level = with(level, clear_pixels(level, kOne, {-2, 0, 3, 1}, 9));
  EXPECT_EQ(pixel_at(level, kOne, 0, 0), 9);
  EXPECT_EQ(pixel_at(level, kOne, 1, 0), 2);
  EXPECT_EQ(pixel_at(level, kOne, 0, 1), 3);
  EXPECT_EQ(level.sheet(SheetId::tiles).flags[1], 7);
}

TEST(SpriteTools, SetFlagsGivesEachTileItsOwn) {
  Level level;
  level.sheet(SheetId::sprites).flags[35] = 0xff;
  level = with(level, set_flags(level, kFour, {1, 2, 4, 8}));
  const auto& flags = level.sheet(SheetId::sprites).flags;
  EXPECT_EQ(flags[18], 1);
  EXPECT_EQ(flags[19], 2);
  EXPECT_EQ(flags[34], 4);
  EXPECT_EQ(flags[35], 8);
}

TEST(SpriteTools, ClearFillsAndTakesTheFlagsToo) {
  Level level = with_corner(kOne);
  level = with(level, set_flag(level, kOne, 3, true));
  const Edit edit = clear_area(level, kOne, 2);
  const Level cleared = with(level, edit);
  for (int i = 0; i < 64; ++i) EXPECT_EQ(cleared.sheet(SheetId::tiles).images[1][i], 2);
  EXPECT_EQ(cleared.sheet(SheetId::tiles).flags[1], 0);
  Level back = cleared;
  revert_edit(back, edit);
  EXPECT_TRUE(back == level);
}

TEST(SpriteTools, LampShowsNoneSomeOrAll) {
  Level level;
  EXPECT_EQ(flag_lamp(level, kFour, 2), FlagLamp::none);
  level.sheet(SheetId::sprites).flags[35] = 1 << 2;
  EXPECT_EQ(flag_lamp(level, kFour, 2), FlagLamp::some);
  EXPECT_EQ(flag_lamp(level, kFour, 1), FlagLamp::none);
  for (int tile : {18, 19, 34}) level.sheet(SheetId::sprites).flags[tile] = 1 << 2;
  EXPECT_EQ(flag_lamp(level, kFour, 2), FlagLamp::all);
}

TEST(SpriteTools, SetFlagKeepsTheOtherFlags) {
  Level level;
  level.sheet(SheetId::sprites).flags[18] = 0x81;
  level = with(level, set_flag(level, kFour, 7, true));
  EXPECT_EQ(level.sheet(SheetId::sprites).flags[18], 0x81);
  EXPECT_EQ(level.sheet(SheetId::sprites).flags[19], 0x80);
  level = with(level, set_flag(level, kFour, 7, false));
  EXPECT_EQ(level.sheet(SheetId::sprites).flags[18], 0x01);
  EXPECT_EQ(level.sheet(SheetId::sprites).flags[19], 0);
}

TEST(SpriteTools, ToggleClearsIfAnyTileHasTheFlag) {
  Level level;
  level.sheet(SheetId::sprites).flags[34] = 1;
  level = with(level, toggle_flag(level, kFour, 0));
  EXPECT_EQ(flag_lamp(level, kFour, 0), FlagLamp::none);
  level = with(level, toggle_flag(level, kFour, 0));
  EXPECT_EQ(flag_lamp(level, kFour, 0), FlagLamp::all);
}

TEST(SpriteTools, SettersOfTheSameValueAreEmpty) {
  const Level level;
  EXPECT_TRUE(set_color(level, 4, level.palette[4]).empty());
  EXPECT_TRUE(rename_flag(level, 4, "").empty());
  EXPECT_TRUE(set_roles(level, level.roles).empty());
  EXPECT_TRUE(set_tuning(level, level.tuning).empty());
  EXPECT_TRUE(set_spawns(level, {}, "Place a spawn").empty());
}

TEST(SpriteTools, SettersSetTheirValue) {
  Level level;
  level = with(level, set_color(level, 4, {9, 8, 7}));
  level = with(level, rename_flag(level, 4, "ice"));
  EXPECT_EQ(level.palette[4], (Rgb{9, 8, 7}));
  EXPECT_EQ(level.flag_names[4], "ice");
  const Edit edit = set_spawns(level, {Spawn{}}, "Place a spawn");
  EXPECT_EQ(edit.label, "Place a spawn");
  EXPECT_EQ(with(level, edit).spawns.size(), 1u);
}

}  // namespace talus::sprite_tools_test
