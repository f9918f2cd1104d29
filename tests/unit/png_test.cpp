// PNG pictures of sheets and palettes, and the colours that pictures are given.
#include <gtest/gtest.h>

#include "formats/pictures/png_sheet.h"
#include "png_bytes.h"

namespace talus::png_test {

using namespace std::string_literals;

constexpr Rgb kRed{255, 0, 0}, kGreen{0, 255, 0}, kBlue{0, 0, 255};

std::string png_error(const std::string& bytes) {
  const auto picture = read_png(bytes);
  if (picture) return "no error";
  return picture.error().place + (picture.error().place.empty() ? "" : ": ") + picture.error().message;
}

Level drawn_level() {
  Level level;
  level.sheet(SheetId::tiles).images[0][0] = 2;
  level.sheet(SheetId::tiles).images[17][63] = 15;
  level.sheet(SheetId::sprites).images[255][63] = 5;
  return level;
}

TEST(Png, ReadsColoursAndOpacity) {
  const auto picture = read_png(png_of(3, 6, {"\xff\0\0\xff"s + "\x01\x02\x03\x7f"s + "\x01\x02\x03\x80"s}));
  ASSERT_TRUE(picture) << picture.error().message;
  EXPECT_EQ(picture->width, 3);
  EXPECT_EQ(picture->height, 1);
  EXPECT_EQ(picture->at(0, 0), kRed);
  EXPECT_FALSE(picture->is_transparent(0, 0));
  EXPECT_TRUE(picture->is_transparent(1, 0));
  EXPECT_EQ(picture->at(1, 0), Rgb{});
  EXPECT_EQ(picture->at(2, 0), (Rgb{1, 2, 3}));
  EXPECT_TRUE(picture->palette.empty());
}

TEST(Png, KeepsThePaletteOfIndices) {
  const auto picture = read_png(png_of(2, 3, {"\x01\x00"s, "\x01\x01"s}, {kBlue, kRed, kGreen}));
  ASSERT_TRUE(picture) << picture.error().message;
  EXPECT_EQ(picture->palette, (std::vector<Rgb>{kBlue, kRed, kGreen}));
  EXPECT_EQ(picture->at(0, 0), kRed);
  EXPECT_EQ(picture->at(1, 0), kBlue);
  const auto true_color = read_png(png_of(1, 2, {"\0\xff\0"s}, {kBlue}));
  ASSERT_TRUE(true_color);
  EXPECT_TRUE(true_color->palette.empty()) << "the palette is only a suggestion: no pixel uses it";
}

TEST(Png, SaysWhatIsWrongWithAFile) {
  const std::string good = rgb_png(8, std::vector<Rgb>(64, kRed));
  EXPECT_EQ(png_error(""), "is not a PNG picture");
  EXPECT_EQ(png_error("GIF89a"), "is not a PNG picture");
  EXPECT_EQ(png_error(good.substr(0, 40)), "byte 33: the picture ends in the middle of a chunk");
  EXPECT_EQ(png_error(png_of(1025, 2, {std::string(3075, '\0')})),
            "is 1025x1 px, but may have at most 1024x1024 px");
  EXPECT_EQ(png_error(png_header(100000, 100000, 2)),
            "is 100000x100000 px, but may have at most 1024x1024 px");
  EXPECT_EQ(png_error(png_header(0, 8, 2)), "is an empty picture");
  EXPECT_EQ(png_error("\x89PNG\r\n\x1a\n"s + png_chunk("IEND", "")),
            "byte 8: the header of the picture is missing, repeated or damaged");
  EXPECT_EQ(png_error(png_header(8, 8, 2) + png_chunk("IEND", "")), "is a damaged PNG picture: no IDAT");
  EXPECT_EQ(png_error(png_header(8, 8, 2) + png_chunk("IDAT", "") + png_chunk("IEND", "")),
            "is a damaged PNG picture: no IDAT");
  EXPECT_EQ(png_error(png_of(1, 3, {"\x02"s}, {kBlue, kRed})),
            "has a pixel whose colour is not in its palette");
  EXPECT_EQ(png_error(png_header(8, 8, 2) + png_chunk("IDAT", std::string(200'001, '\0'))),
            "has more data than a picture of its size can have");
}

TEST(Png, ListsOfColoursDoNotRepeat) {
  const std::string indexed = png_header(1, 1, 3), colour = png_chunk("PLTE", "\xff\0\0"s),
                    opacity = png_chunk("tRNS", "\xff"),
                    pixels = png_chunk("IDAT", zipped("\0\0"s)) + png_chunk("IEND", "");
  ASSERT_EQ(png_error(indexed + colour + opacity + pixels), "no error");
  EXPECT_EQ(png_error(indexed + colour + png_chunk("PLTE", "") + pixels),
            "byte 48: the picture has a second palette");
  EXPECT_EQ(png_error(indexed + colour + opacity + opacity + pixels),
            "byte 61: the picture has a second list of opacities");
  EXPECT_EQ(png_error(indexed + colour + png_chunk("tRNS", std::string(257, '\xff')) + pixels),
            "byte 48: the picture has more than 256 opacities");
}

TEST(Png, SaysWhyPixelsCannotBeUnpacked) {
  const auto with_pixels = [](const std::string& packed) {
    return png_error(png_header(1, 2, 2) + png_chunk("IDAT", packed) + png_chunk("IEND", ""));
  };
  const std::string rows(8, '\0'), good = zipped(rows), at = "is a damaged PNG picture: ";
  ASSERT_EQ(with_pixels(good), "no error");
  EXPECT_EQ(with_pixels(good.substr(0, good.size() - 1)),
            at + "its pixels cannot be unpacked, the end is missing");
  EXPECT_EQ(with_pixels("x" + good), at + "its pixels cannot be unpacked, incorrect header check");
  std::string wrong_sum = good;
  wrong_sum.back() ^= 1;
  EXPECT_EQ(with_pixels(wrong_sum), at + "its pixels cannot be unpacked, incorrect data check");
  EXPECT_EQ(with_pixels(zipped(rows.substr(1))), at + "not enough pixels");
}

TEST(Png, EveryCutOffFileIsAnError) {
  const std::string good = png_of(8, 3, std::vector<std::string>(8, "\0\1\0\1\0\1\0\1"s), {kRed, kBlue});
  ASSERT_TRUE(read_png(good));
  const std::size_t end_chunk = 12;  // the pixels are complete without IEND
  for (std::size_t size = 0; size < good.size() - end_chunk; ++size)
    EXPECT_FALSE(read_png(good.substr(0, size))) << size;
}

TEST(Png, EveryChangedByteIsReadOrRefused) {
  const std::string good = png_of(8, 3, std::vector<std::string>(8, "\0\1\0\1\0\1\0\1"s), {kRed, kBlue});
  int read = 0;
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (const int value : {0, 1, 2, 4, 6, 8, 16, 127, 128, 255}) {
      std::string changed = good;
      changed[at] = static_cast<char>(value);
      const auto picture = read_png(changed);
      if (!picture) {
        EXPECT_NE(picture.error().message, "");
        continue;
      }
      ++read;
      const auto count = static_cast<std::size_t>(picture->width) * static_cast<std::size_t>(picture->height);
      EXPECT_EQ(picture->pixels.size(), count);
      EXPECT_EQ(match_colors(*picture, default_palette()).indices.size(), count);
    }
  }
  EXPECT_GT(read, 100) << "checksums are not looked at";
}

TEST(PngSheet, ShowsTheSheetInItsColours) {
  const Level level = drawn_level();
  const auto tiles = read_png(write_png_part(level, PngPart::tiles));
  ASSERT_TRUE(tiles) << tiles.error().message;
  EXPECT_EQ(tiles->width, 128);
  EXPECT_EQ(tiles->height, 128);
  EXPECT_EQ(tiles->at(0, 0), level.palette[2]);
  EXPECT_EQ(tiles->at(15, 15), level.palette[15]) << "tile 17 is the second of the second row";
  EXPECT_EQ(tiles->at(16, 15), level.palette[0]);
  const auto sprites = read_png(write_png_part(level, PngPart::sprites));
  ASSERT_TRUE(sprites);
  EXPECT_EQ(sprites->at(127, 127), level.palette[5]);
}

TEST(PngSheet, ShowsThePaletteInARow) {
  const Level level;
  const auto picture = read_png(write_png_part(level, PngPart::palette));
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->width, 16);
  EXPECT_EQ(picture->height, 1);
  for (int i = 0; i < 16; ++i) EXPECT_EQ(picture->at(i, 0), level.palette[static_cast<std::size_t>(i)]);
}

TEST(PngColours, TakeTheNearestColourAndTheFirstOfEquals) {
  Palette palette{};
  palette[1] = {10, 0, 0};
  palette[2] = {10, 0, 0};
  palette[3] = {20, 0, 0};
  const auto picture = read_png(rgb_png(4, {{9, 0, 0}, {15, 0, 0}, {23, 4, 0}, {1, 0, 0}}));
  ASSERT_TRUE(picture);
  const MatchedPicture matched = match_colors(*picture, palette);
  EXPECT_EQ(matched.indices, (std::vector<std::uint8_t>{1, 1, 3, 0}));
  EXPECT_EQ(matched.approximated, 4);
  EXPECT_EQ(matched.largest_distance, 5) << "of (15, 0, 0), and of (23, 4, 0) too";
  EXPECT_EQ(matched.farthest, (Cell{1, 0}));
}

TEST(PngColours, TransparentPixelsGetColourZero) {
  const auto picture = read_png(png_of(1, 6, {"\xff\xff\xff\0"s}));
  ASSERT_TRUE(picture);
  const MatchedPicture matched = match_colors(*picture, default_palette());
  EXPECT_EQ(matched.indices, (std::vector<std::uint8_t>{0}));
  EXPECT_EQ(matched.approximated, 0);
  EXPECT_EQ(matched.largest_distance, 0);
}

TEST(PngColours, TakeAPaletteInItsOrder) {
  const auto picture = read_png(png_of(1, 3, {"\0"s}, {kBlue, kRed}));
  ASSERT_TRUE(picture);
  const auto taken = palette_for(*picture, default_palette());
  ASSERT_TRUE(taken);
  EXPECT_EQ((*taken)[0], kBlue);
  EXPECT_EQ((*taken)[1], kRed);
  EXPECT_EQ((*taken)[2], default_palette()[2]);
}

TEST(PngColours, WithoutAPaletteTheLevelsOwnStay) {
  const Rgb known = default_palette()[1];
  const auto picture = read_png(rgb_png(4, {kRed, known, kGreen, kRed}));
  ASSERT_TRUE(picture);
  const auto taken = palette_for(*picture, default_palette());
  ASSERT_TRUE(taken);
  EXPECT_EQ((*taken)[0], kRed);
  EXPECT_EQ((*taken)[1], known);
  EXPECT_EQ((*taken)[2], kGreen);
  EXPECT_EQ((*taken)[3], default_palette()[3]);
}

TEST(PngColours, MoreThanSixteenAreAnError) {
  std::vector<Rgb> pixels;
  for (int i = 0; i < 17; ++i) pixels.push_back({static_cast<std::uint8_t>(i), 0, 0});
  const auto seventeen = read_png(rgb_png(17, pixels));
  ASSERT_TRUE(seventeen);
  const auto refused = palette_for(*seventeen, Palette{});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "has more than 16 colours, too many for the palette of a level");
  pixels.pop_back();
  const auto sixteen = read_png(rgb_png(16, pixels));
  ASSERT_TRUE(sixteen);
  const auto taken = palette_for(*sixteen, default_palette());
  ASSERT_TRUE(taken);
  EXPECT_EQ((*taken)[15], (Rgb{15, 0, 0}));
}

TEST(PngColours, APaletteIsOneRowOfPixels) {
  const auto two = read_png(rgb_png(2, {kRed, kRed}));
  ASSERT_TRUE(two);
  const auto palette = palette_in(*two, default_palette());
  ASSERT_TRUE(palette);
  EXPECT_EQ((*palette)[1], kRed);
  EXPECT_EQ((*palette)[2], default_palette()[2]);
  const auto high = read_png(rgb_png(1, {kRed, kRed}));
  ASSERT_TRUE(high);
  const auto refused = palette_in(*high, default_palette());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "is 1x2 px, but a palette must be 1 to 16 px side by side");
}

}  // namespace talus::png_test
