// Sprites and palettes as text, to the last digit.
#include "edit/sprite_clipboard.h"

#include <gtest/gtest.h>

#include "sprite_picture.h"

namespace talus::sprite_clipboard_test {

const SpriteArea kClipTile{SheetId::tiles, {3, 0, 1, 1}};
const SpriteArea kClipFour{SheetId::sprites, {0, 0, 2, 2}};
const SpriteArea kClipWide{SheetId::tiles, {3, 0, 2, 1}};

Level level_with_numbered_tile() {
  Level level = with_picture(
      Level(), kClipTile, "123.....\n........\n........\n........\n........\n........\n........\n.......f\n");
  level.sheet(SheetId::tiles).flags[3] = 0x21;  // flags 0 and 5
  return level;
}
const std::string kClipTileText =
    "12300000"
    "00000000"
    "00000000"
    "00000000"
    "00000000"
    "00000000"
    "00000000"
    "0000000f"
    "12";

TEST(SpriteClipboard, TileIsADigitForEachPixelThenItsFlags) {
  EXPECT_EQ(tiles_to_text(level_with_numbered_tile(), kClipTile), kClipTileText);
}

// The first row of both tiles comes before the second row of either.
TEST(SpriteClipboard, SquareIsWrittenRowByRowThenTheFlagsOfEachTile) {
  Level level;
  Sheet& sheet = level.sheet(SheetId::sprites);
  sheet.images[0].fill(1);
  sheet.images[1].fill(2);
  sheet.images[16].fill(3);
  sheet.images[17].fill(0xa);
  sheet.flags[0] = 0x80;
  sheet.flags[17] = 0x0f;
  std::string text;
  for (int row = 0; row < 8; ++row) text += "1111111122222222";
  for (int row = 0; row < 8; ++row) text += "33333333aaaaaaaa";
  EXPECT_EQ(tiles_to_text(level, kClipFour), text +
                                                 "08"
                                                 "00"
                                                 "00"
                                                 "f0");
}

TEST(SpriteClipboard, PastePutsPixelsAndFlagsInOneEdit) {
  Level level;
  level.sheet(SheetId::tiles).images[3].fill(9);
  level.sheet(SheetId::tiles).flags[3] = 0xff;
  const Level before = level;
  std::string upper = "\n " + kClipTileText + "\r\n";
  for (char& c : upper) c = c == 'f' ? 'F' : c;
  const auto edit = paste_tiles(level, kClipTile, upper);
  ASSERT_TRUE(edit) << edit.error();
  apply_edit(level, *edit);
  EXPECT_EQ(picture_of(level, kClipTile), picture_of(level_with_numbered_tile(), kClipTile));
  EXPECT_EQ(level.sheet(SheetId::tiles).flags[3], 0x21);
  revert_edit(level, *edit);
  EXPECT_TRUE(level == before);
}

TEST(SpriteClipboard, ACopyIsPastedElsewhereUnchanged) {
  Level level;
  for (std::size_t i = 0; i < 64; ++i) {
    level.sheet(SheetId::tiles).images[3][i] = static_cast<std::uint8_t>(i * 7 % 16);
    level.sheet(SheetId::tiles).images[4][i] = static_cast<std::uint8_t>(i * 5 % 16);
  }
  level.sheet(SheetId::tiles).flags[4] = 0x5a;
  const std::string text = tiles_to_text(level, kClipWide);
  EXPECT_EQ(text.substr(0, 10), "tiles 2x1\n");
  const SpriteArea other{SheetId::sprites, {7, 9, 2, 1}};
  const auto edit = paste_tiles(level, other, text);
  ASSERT_TRUE(edit) << edit.error();
  apply_edit(level, *edit);
  EXPECT_EQ(picture_of(level, other), picture_of(level, kClipWide));
  EXPECT_EQ(level.sheet(SheetId::sprites).flags[9 * 16 + 8], 0x5a);
}

TEST(SpriteClipboard, AnotherSizeIsAnErrorThatNamesBoth) {
  const auto edit = paste_tiles(Level(), kClipFour, kClipTileText);
  ASSERT_FALSE(edit);
  EXPECT_EQ(edit.error(), "The clipboard holds 1x1 tiles, and 2x2 are selected: select 1x1 to paste them.");
  const SpriteArea four_wide{SheetId::tiles, {0, 0, 4, 1}};
  EXPECT_FALSE(paste_tiles(Level(), four_wide, tiles_to_text(Level(), kClipFour))) << "as many tiles";
}

TEST(SpriteClipboard, OtherTextIsAnError) {
  const std::string error = "The clipboard holds no sprites: copy some here or in TIC-80 first.";
  std::string no_digit = kClipTileText;
  no_digit[5] = 'g';
  const std::string three(3 * 66, '0');  // no square
  for (const std::string& text :
       {std::string(), std::string("hello"), kClipTileText + "0", kClipTileText.substr(1), no_digit, three,
        std::string("tiles 2x2\n") + kClipTileText, std::string("tiles 0x1\n"), "tiles 1x\n" + kClipTileText,
        std::string("pixels 9x1\n12")}) {
    const auto edit = paste_tiles(Level(), kClipTile, text);
    ASSERT_FALSE(edit) << text;
    EXPECT_EQ(edit.error(), error) << text;
  }
}

TEST(SpriteClipboard, PixelsAreWrittenAsSizeAndDigits) {
  const PixelBlock block{3, 2, {1, 2, 3, 10, 15, 0}};
  EXPECT_EQ(pixels_to_text(block), "pixels 3x2\n123af0");
  EXPECT_EQ(pixels_from_text("pixels 3x2\n123\nAF0\n"), block);
  for (const char* text :
       {"", "pixels", "pixels 3x2", "pixels 3x2\n123af", "pixels 3x2\n123af00", "pixels 3",
        "pixels -3x2\n123af0", "pixels 0x2\n", "pixels 999999999999x2\n1", "123af0", "pixels 129x1\n1"})
    EXPECT_FALSE(pixels_from_text(text)) << text;
}

// TIC-80's own palette, as it copies it.
TEST(SpriteClipboard, PaletteIsNinetySixDigits) {
  const std::string sweetie =
      "1a1c2c5d275db13e53ef7d57ffcd75a7f07038b76425717929366f3b5dc941a6f673eff7f4f4f494b0c2566c86333c57";
  EXPECT_EQ(palette_to_text(default_palette()), sweetie);
  Level level;
  level.palette = {};
  const Level before = level;
  const auto edit = paste_palette(level, 3, sweetie.substr(0, 48) + "\n " + sweetie.substr(48));
  ASSERT_TRUE(edit) << edit.error();
  apply_edit(level, *edit);
  EXPECT_EQ(level.palette, default_palette());
  revert_edit(level, *edit);
  EXPECT_TRUE(level == before);
}

TEST(SpriteClipboard, SixDigitsSetTheChosenColour) {
  Level level;
  const auto edit = paste_palette(level, 3, "0180FF");
  ASSERT_TRUE(edit);
  apply_edit(level, *edit);
  Palette expected = default_palette();
  expected[3] = {0x01, 0x80, 0xff};
  EXPECT_EQ(level.palette, expected);
}

TEST(SpriteClipboard, OtherTextIsNoPalette) {
  for (const std::string& text :
       {std::string(), std::string("12345"), std::string("12345g"), std::string(95, '0'), kClipTileText}) {
    const auto edit = paste_palette(Level(), 0, text);
    ASSERT_FALSE(edit) << text;
    EXPECT_EQ(edit.error(),
              "The clipboard holds no palette: it must be 96 hex digits, as TIC-80 copies it, or 6 for one "
              "colour.");
  }
}

}  // namespace talus::sprite_clipboard_test
