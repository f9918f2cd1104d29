// Pictures of sheets and palettes through the dialogs.
#include <fstream>

#include "edit/map_rectangle.h"
#include "formats/pictures/png_sheet.h"
#include "harness.h"

namespace talus::picture_test {

class UiPicture : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    start();
  }
  // Writes a picture of one colour.
  std::string save_png(const std::string& name, int width, int height, Rgb color) {
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < width * height; ++i) bytes.insert(bytes.end(), {color.r, color.g, color.b});
    std::ofstream(path(name), std::ios::binary) << encode_png(width, height, 3, bytes.data());
    return path(name);
  }
  void open_picture(const std::string& name) {
    key(ctrl('i'));
    frames(3);
    click("files/entry/" + name);
    click("files/confirm");
    frames(3);
  }
  void choose_in_file_menu(const std::string& command) {
    click("menu/File");
    frames(2);
    click("menu/" + command);
    frames(3);
  }
  const TileImage& image(int tile) {
    return level().sheet(SheetId::tiles).images[static_cast<std::size_t>(tile)];
  }
};

constexpr KeyChord kReturnKey{'\r'}, kEscKey{27};

TEST_F(UiPicture, ThePreviewIsAppliedInOneUndo) {
  save_png("blue.png", 16, 8, default_palette()[9]);
  click(on_sheet(64));
  open_picture("blue.png");
  ASSERT_TRUE(session().png_import());
  EXPECT_EQ(session().png_import()->options.tile, 64) << "at the selection";
  EXPECT_EQ(session().png_import()->plan->pixels, 128);
  EXPECT_EQ(image(64), TileImage{}) << "nothing is done yet";
  click("import/apply");
  frames(3);
  EXPECT_FALSE(session().png_import());
  EXPECT_EQ(find("import/apply"), nullptr);
  EXPECT_EQ(image(65)[0], 9);
  EXPECT_EQ(session().history().edits().size(), 1u);
  key(ctrl('z'));
  EXPECT_EQ(image(65), TileImage{});
}

TEST_F(UiPicture, ADroppedPictureOpensTheImportDialog) {
  save_png("green.png", 8, 8, default_palette()[6]);
  session().apply(action::EditLevel{fill_rect(level(), {1, 1, 1, 1}, Stamp{1, 1, {1}})});
  drop(path("green.png"));
  frames(3);
  EXPECT_FALSE(session().question()) << "nothing would be lost";
  ASSERT_TRUE(session().png_import());
  EXPECT_EQ(session().png_import()->path, path("green.png"));
  EXPECT_EQ(tile_at({1, 1}), 1) << "the level is still open";
  click("import/apply");
  frames(3);
  EXPECT_EQ(image(1)[0], 6) << "the chosen tile, the first that is drawn";
}

TEST_F(UiPicture, ADroppedPictureThatIsTooLargeBecomesTiles) {
  save_png("large.png", 320, 160, default_palette()[6]);
  drop(path("large.png"));
  frames(3);
  EXPECT_FALSE(session().png_import());
  ASSERT_TRUE(session().tile_import());
  click("tiles/draw");
  frames(3);
  EXPECT_FALSE(session().tile_import());
  ASSERT_TRUE(session().png_import()) << "it is drawn on the sheet all the same";
  click("import/as_tiles");
  frames(3);
  ASSERT_TRUE(session().tile_import());
  click("tiles/apply");
  frames(3);
  ASSERT_EQ(level().tilesets.size(), 1u);
  EXPECT_EQ(level().tilesets[0].count, 200);
  EXPECT_EQ(level().map.tile_size(), (TileSize{16, 16}));
}

TEST_F(UiPicture, CancelChangesNothing) {
  save_png("blue.png", 8, 8, default_palette()[9]);
  open_picture("blue.png");
  ASSERT_NE(find("import/cancel"), nullptr);
  key(kEscKey);
  frames(3);
  EXPECT_EQ(find("import/cancel"), nullptr);
  EXPECT_FALSE(session().modified());
}

TEST_F(UiPicture, ThePlaceAndThePaletteAreChosen) {
  const Rgb odd{1, 200, 3};
  save_png("odd.png", 8, 8, odd);
  open_picture("odd.png");
  click("import/sprites");
  frames(2);
  const Widget* after = find("import/after");
  ASSERT_NE(after, nullptr);
  const float cell = (after->max.x - after->min.x) / kCartColumns;
  click(ImVec2{after->min.x + 3.5f * cell, after->min.y + 2.5f * cell});
  frames(2);
  EXPECT_EQ(session().png_import()->options.tile, 35);
  EXPECT_GT(session().png_import()->plan->largest_distance, 1);
  EXPECT_NE(find("import/match"), nullptr) << "it says that colours are not the picture's";
  click("import/take_palette");
  frames(2);
  EXPECT_EQ(session().png_import()->plan->largest_distance, 0);
  EXPECT_EQ(find("import/match"), nullptr);
  EXPECT_EQ(session().png_import()->plan->colors, 1);
  key(kReturnKey);
  frames(3);
  EXPECT_EQ(level().palette[0], odd);
  EXPECT_EQ(session().history().edits().size(), 1u)
      << "or none, if the sprite had changed only by its palette";
  key(ctrl('z'));
  EXPECT_EQ(level().palette[0], default_palette()[0]);
}

TEST_F(UiPicture, AnOddSizeIsFilledUpOrCutOff) {
  save_png("odd.png", 10, 9, default_palette()[9]);
  session().apply(action::SelectTiles{{SheetId::tiles, {0, 4, 1, 1}}});
  open_picture("odd.png");
  ASSERT_TRUE(session().png_import());
  EXPECT_EQ(session().png_import()->plan->width, 16) << "it begins filled up";
  click("import/cut_off");
  frames(2);
  EXPECT_EQ(session().png_import()->plan->width, 8);
  EXPECT_EQ(session().png_import()->plan->height, 8);
  click("import/fill_up");
  frames(2);
  EXPECT_EQ(session().png_import()->plan->height, 16);
  click("import/apply");
  frames(3);
  EXPECT_EQ(image(65)[1], 9);
  EXPECT_EQ(image(65)[2], 0);
  EXPECT_EQ(image(81)[1], 9);
  EXPECT_EQ(image(81)[8 + 1], 0);
}

TEST_F(UiPicture, TheDialogStaysInPlaceForEveryChoice) {
  save_png("odd.png", 16, 1, {1, 200, 3});
  open_picture("odd.png");
  const ImVec2 tiles = centre("import/tiles"), apply = centre("import/apply");
  for (const char* choice : {"import/tiles", "import/take_palette", "import/cut_off", "import/nearest",
                             "import/sprites", "import/fill_up", "import/palette"}) {
    click(choice);
    frames(3);
    EXPECT_EQ(centre("import/tiles").y, tiles.y) << choice;
    EXPECT_EQ(centre("import/tiles").x, tiles.x) << choice;
    EXPECT_EQ(centre("import/apply").y, apply.y) << choice;
  }
}

TEST_F(UiPicture, APictureThatDoesNotFitCannotBeApplied) {
  save_png("wide.png", 128, 8, default_palette()[9]);
  open_picture("wide.png");
  const Widget* after = find("import/after");
  ASSERT_NE(after, nullptr);
  click(ImVec2{(after->min.x + after->max.x) / 2, after->min.y + 4});
  frames(2);
  ASSERT_NE(find("import/error"), nullptr);
  EXPECT_EQ(session().png_import()->plan.error(),
            "The picture of 128x8 px does not fit at tile 8, where 64x128 px are left.");
  EXPECT_FALSE(find("import/apply")->enabled);
}

TEST_F(UiPicture, ABadFileIsReportedInTheFileDialog) {
  std::ofstream(path("bad.png"), std::ios::binary) << "no picture";
  save_png("wide.png", 1025, 8, {});
  open_picture("bad.png");
  ASSERT_NE(find("files/confirm"), nullptr) << "it stays open";
  click("files/entry/wide.png");
  click("files/confirm");
  frames(3);
  ASSERT_NE(find("files/confirm"), nullptr);
  EXPECT_FALSE(session().png_import());
  EXPECT_FALSE(session().modified());
}

TEST_F(UiPicture, SheetsAndPaletteAreExported) {
  choose_in_file_menu("picture/export_tiles");
  click("files/confirm");
  frames(3);
  const auto tiles = load_png(path("level-tiles.png"));
  ASSERT_TRUE(tiles) << tiles.error().message;
  EXPECT_EQ(tiles->width, 128);
  EXPECT_EQ(tiles->at(8, 0), level().palette[image(1)[0]]);
  choose_in_file_menu("picture/export_palette");
  click("files/confirm");
  frames(3);
  const auto palette = load_png(path("level-palette.png"));
  ASSERT_TRUE(palette) << palette.error().message;
  EXPECT_EQ(palette->at(15, 0), level().palette[15]);
  ASSERT_TRUE(session().message());
  EXPECT_EQ(session().message()->text, "Saved level-palette.png.");
}

TEST_F(UiPicture, AnExportedPaletteCanBeImported) {
  save_png("colors.png", 16, 1, {9, 8, 7});
  open_picture("colors.png");
  EXPECT_EQ(session().png_import()->options.part, PngPart::palette)
      << "a picture of 16 by 1 pixels can only be a palette";
  click("import/apply");
  frames(3);
  EXPECT_EQ(level().palette[15], (Rgb{9, 8, 7}));
}

}  // namespace talus::picture_test
