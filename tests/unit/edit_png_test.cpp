// How a picture would change a level.
#include <gtest/gtest.h>

#include "png_bytes.h"
#include "session/files/png_import.h"

namespace talus::edit_png_test {

constexpr Rgb kPureRed{255, 0, 0};

PngPicture filled(std::uint32_t width, std::size_t height, Rgb color) {
  return *read_png(rgb_png(width, std::vector<Rgb>(width * height, color)));
}

TEST(PngImport, DrawsInTheLevelsColours) {
  Level level;
  const Rgb nearly{level.palette[2].r, static_cast<std::uint8_t>(level.palette[2].g + 3), level.palette[2].b};
  const auto plan = plan_png_import(level, filled(16, 8, nearly), {PngPart::sprites, 18, false});
  ASSERT_TRUE(plan) << plan.error();
  EXPECT_EQ(plan->pixels, 128);
  EXPECT_EQ(plan->tiles, 2);
  EXPECT_EQ(plan->colors, 0);
  EXPECT_EQ(plan->tiles_recolored, 0);
  EXPECT_EQ(plan->largest_distance, 3);
  EXPECT_EQ(plan->approximated, 128);
  EXPECT_EQ(plan->farthest_from, nearly);
  EXPECT_EQ(plan->farthest_to, level.palette[2]);
  const Level before = level;
  apply_edit(level, plan->edit);
  EXPECT_EQ(level.sheet(SheetId::sprites).images[18][0], 2);
  EXPECT_EQ(level.sheet(SheetId::sprites).images[19][63], 2);
  EXPECT_EQ(level.sheet(SheetId::sprites).images[20], TileImage{});
  EXPECT_EQ(level.sheet(SheetId::sprites), plan->sheet);
  revert_edit(level, plan->edit);
  EXPECT_EQ(level, before);
}

TEST(PngImport, TakesThePaletteOver) {
  Level level;
  level.sheet(SheetId::sprites).images[3][0] = 0;  // every image contains colour 0, which becomes red
  const auto plan = plan_png_import(level, filled(8, 8, kPureRed), {PngPart::tiles, 0, true});
  ASSERT_TRUE(plan) << plan.error();
  EXPECT_EQ(plan->colors, 1);
  EXPECT_EQ(plan->tiles_recolored, 512);
  EXPECT_EQ(plan->pixels, 0) << "it is drawn in colour 0, as the tile is";
  EXPECT_EQ(plan->largest_distance, 0);
  apply_edit(level, plan->edit);
  EXPECT_EQ(level.palette[0], kPureRed);
}

TEST(PngImport, APaletteAloneChangesNoPixel) {
  Level level;
  const auto plan = plan_png_import(level, filled(3, 1, kPureRed), {PngPart::palette, 0, false});
  ASSERT_TRUE(plan) << plan.error();
  EXPECT_EQ(plan->colors, 3);
  EXPECT_EQ(plan->pixels, 0);
  apply_edit(level, plan->edit);
  EXPECT_EQ(level.palette[2], kPureRed);
  EXPECT_EQ(level.palette[3], default_palette()[3]);
}

TEST(PngImport, TheSamePictureChangesNothing) {
  Level level;
  level.sheet(SheetId::tiles).images[200].fill(7);
  const auto picture = read_png(write_png_part(level, PngPart::tiles));
  ASSERT_TRUE(picture);
  const auto plan = plan_png_import(level, *picture, {PngPart::tiles, 0, false});
  ASSERT_TRUE(plan) << plan.error();
  EXPECT_TRUE(plan->edit.empty());
  const auto taken = plan_png_import(level, *picture, {PngPart::tiles, 0, true});
  ASSERT_TRUE(taken) << taken.error();
  EXPECT_TRUE(taken->edit.empty()) << "its colours keep their places";
}

TEST(PngImport, FillsUpToWholeTilesWithColourZero) {
  Level level;
  level.sheet(SheetId::tiles).images[17].fill(5);
  const auto plan = plan_png_import(level, filled(10, 9, level.palette[2]), {.fit = PngFit::fill_up});
  ASSERT_TRUE(plan) << plan.error();
  EXPECT_EQ(plan->width, 16);
  EXPECT_EQ(plan->height, 16);
  EXPECT_EQ(plan->approximated, 0) << "counts only the picture's own pixels";
  const auto& images = plan->sheet.images;
  EXPECT_EQ(images[1][1], 2);
  EXPECT_EQ(images[1][2], 0);
  EXPECT_EQ(images[17][1], 2);
  EXPECT_EQ(images[17][8], 0) << "what was there goes";
  EXPECT_FALSE(plan_png_import(level, filled(8, 9, kPureRed), {.tile = 240, .fit = PngFit::fill_up}));
}

TEST(PngImport, CutsOffPartTilesAndTilesWithoutRoom) {
  const Level level;
  const auto size = [&](int width, int height, int tile) {
    const PngPicture picture =
        filled(static_cast<std::uint32_t>(width), static_cast<std::size_t>(height), level.palette[2]);
    const auto plan = plan_png_import(level, picture, {.tile = tile, .fit = PngFit::cut_off});
    return plan ? Cell{plan->width, plan->height} : Cell{};
  };
  EXPECT_EQ(size(10, 17, 0), (Cell{8, 16}));
  EXPECT_EQ(size(200, 130, 0), (Cell{128, 128}));
  EXPECT_EQ(size(200, 130, 254), (Cell{16, 8}));
  EXPECT_EQ(size(16, 16, 0), (Cell{16, 16}));
  const auto none = plan_png_import(level, filled(7, 16, kPureRed), {.fit = PngFit::cut_off});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error(), "The picture of 7x16 px has no whole tile of 8x8 px to take.");
}

TEST(PngImport, SaysWhatDoesNotFit) {
  const Level level;
  const auto error = [&](const PngPicture& picture, PngImportOptions options) {
    const auto plan = plan_png_import(level, picture, options);
    return plan ? "no error" : plan.error();
  };
  EXPECT_EQ(error(filled(12, 8, kPureRed), {}),
            "The picture is 12x8 px, which is not a whole number of tiles of 8x8 px.");
  EXPECT_EQ(error(filled(8, 9, kPureRed), {}),
            "The picture is 8x9 px, which is not a whole number of tiles of 8x8 px.");
  EXPECT_EQ(error(filled(16, 16, kPureRed), {PngPart::tiles, 15, false}),
            "The picture of 16x16 px does not fit at tile 15, where 8x128 px are left.");
  EXPECT_EQ(error(filled(16, 16, kPureRed), {PngPart::palette, 0, false}),
            "The picture is 16x16 px, but a palette must be 1 to 16 px side by side.");
}

}  // namespace talus::edit_png_test
