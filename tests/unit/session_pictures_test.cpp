// Pictures that are opened in a session.
#include <gtest/gtest.h>

#include "folder_test.h"
#include "png_bytes.h"
#include "session/session.h"

namespace talus::session_pictures_test {

namespace act = action;

class SessionPictures : public FolderTest {
 protected:
  // Writes a red picture of this size, and returns its path.
  std::string red_png(const std::string& name, std::uint32_t width, std::size_t height) const {
    return put(name, rgb_png(width, std::vector<Rgb>(width * height, {255, 0, 0})));
  }
};

TEST_F(SessionPictures, WaitForApplyOrCancel) {
  Session session;
  session.apply(act::SelectTiles{{SheetId::sprites, {2, 1, 1, 1}}});
  const std::string red = red_png("good.png", 8, 16);
  session.apply(act::OpenPng{red});
  ASSERT_TRUE(session.png_import());
  EXPECT_EQ(session.png_import()->path, red);
  EXPECT_EQ(session.png_import()->options, (PngImportOptions{PngPart::sprites, 18, false, PngFit::fill_up}));
  EXPECT_FALSE(session.modified());
  session.apply(act::CancelPngImport{});
  EXPECT_FALSE(session.png_import());
  session.apply(act::ApplyPngImport{});
  EXPECT_FALSE(session.modified()) << "there is none";
  session.apply({act::OpenPng{red}, act::SetPngImport{{PngPart::tiles, 5, true}}, act::ApplyPngImport{}});
  EXPECT_FALSE(session.png_import());
  EXPECT_EQ(session.level().palette[0], (Rgb{255, 0, 0}));
  EXPECT_EQ(session.history().edits().size(), 1u);
  session.apply(act::Undo{});
  EXPECT_EQ(session.level(), Level());
}

TEST_F(SessionPictures, GoToTheFirstTileIfTheyDoNotFit) {
  Session session;
  session.apply(act::SelectTiles{{SheetId::tiles, {15, 0, 1, 1}}});
  session.apply(act::OpenPng{red_png("wide.png", 16, 8)});
  ASSERT_TRUE(session.png_import());
  EXPECT_EQ(session.png_import()->options.tile, 0) << "beside tile 15 is no room";
  session.apply(act::SetPngImport{{PngPart::tiles, 15, false}});
  EXPECT_FALSE(session.png_import()->plan);
  session.apply(act::ApplyPngImport{});
  EXPECT_TRUE(session.png_import()) << "what is wrong can be changed";
  EXPECT_FALSE(session.modified());
}

TEST_F(SessionPictures, AreFittedWhateverTheirSize) {
  Session session;
  session.apply(act::SelectTiles{{SheetId::tiles, {15, 0, 1, 1}}});
  session.apply(act::OpenPng{red_png("odd.png", 10, 10)});
  ASSERT_TRUE(session.png_import());
  EXPECT_EQ(session.png_import()->options, (PngImportOptions{PngPart::tiles, 0, false, PngFit::fill_up}))
      << "filled up, it has no room beside tile 15";
  EXPECT_TRUE(session.png_import()->plan);
  session.apply({act::CancelPngImport{}, act::OpenPng{red_png("large.png", 130, 8)}});
  ASSERT_TRUE(session.png_import());
  EXPECT_EQ(session.png_import()->options.fit, PngFit::cut_off);
  EXPECT_TRUE(session.png_import()->plan);
}

TEST_F(SessionPictures, OpenAsTilesIfTheSheetIsTooSmall) {
  Session session;
  session.apply(act::OpenFile{red_png("fits.png", 128, 128)});
  EXPECT_TRUE(session.png_import());
  EXPECT_FALSE(session.tile_import());
  session.apply({act::CancelPngImport{}, act::OpenFile{red_png("palette.png", 200, 1)}});
  EXPECT_TRUE(session.png_import()) << "one row of pixels is a palette";
  for (const int width : {129, 1025}) {
    session.apply({act::CancelPngImport{}, act::OpenFile{red_png("large.png", width, 16)}});
    EXPECT_FALSE(session.png_import());
    ASSERT_TRUE(session.tile_import());
    EXPECT_EQ(session.tile_import()->width(), width);
    session.apply(act::CancelTiles{});
  }
  EXPECT_EQ(session.level(), Level());
}

TEST_F(SessionPictures, BadPicturesAreReportedInOneSentence) {
  Session session;
  const std::string wide = red_png("wide.png", 1025, 8);
  session.apply(act::OpenPng{wide});
  EXPECT_FALSE(session.png_import());
  ASSERT_TRUE(session.message());
  EXPECT_TRUE(session.message()->is_error);
  EXPECT_EQ(session.message()->text, wide + ": error: is 1025x8 px, but may have at most 1024x1024 px");
  session.apply(act::OpenPng{"/no/such.png"});
  EXPECT_EQ(session.message()->text.find("/no/such.png: error: "), 0u);
  session.apply(act::ExportPng{PngPart::tiles, "/no/such/folder/x.png"});
  EXPECT_TRUE(session.message()->is_error);
}

}  // namespace talus::session_pictures_test
