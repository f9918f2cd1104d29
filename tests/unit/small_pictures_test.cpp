// Small pictures of levels: in lists of recent files, and in the world of a project of LDtk.
#include <gmock/gmock.h>

#include "folder_test.h"
#include "ldtk_text.h"
#include "overlay/small_picture.h"
#include "platform/recent_pictures.h"
#include "png_bytes.h"
#include "session/session.h"

namespace talus::small_pictures_test {

std::array<int, 3> color_at(const SheetPicture& picture, int x, int y) {
  const std::uint8_t* at = picture.at(x, y);
  return {at[0], at[1], at[2]};
}
std::array<int, 3> of(Rgb color) { return {color.r, color.g, color.b}; }

// 4x2 cells: tile 1, red, at (0, 0); tile 2, green, at (3, 1) of a second layer of half opacity.
Level two_layers() {
  Level level;
  level.palette = default_palette();
  level.sheet(SheetId::tiles).images[1].fill(2);
  level.sheet(SheetId::tiles).images[2].fill(5);
  level.map = TileMap(4, 2);
  level.map.set({0, 0}, 1);
  TileLayer above;
  above.name = "above";
  above.opacity = 0.5;
  above.cells = std::make_shared<const MapCells>(std::vector<TileNumber>{0, 0, 0, 0, 0, 0, 0, 2});
  level.layers.list.push_back(above);
  return level;
}

TEST(SmallPicture, ShowsVisibleLayersOverOneAnother) {
  Level level = two_layers();
  const SheetPicture picture = small_picture(level, 96, 54);
  EXPECT_EQ(picture.width, 4);
  EXPECT_EQ(picture.height, 2);
  const auto back = of(level.palette[0]);
  EXPECT_EQ(color_at(picture, 0, 0), of(level.palette[2]));
  EXPECT_EQ(color_at(picture, 1, 0), back);
  EXPECT_NEAR(color_at(picture, 3, 1)[1], (back[1] + level.palette[5].g) / 2, 2);
  level.layers.list[1].visible = false;
  EXPECT_EQ(color_at(small_picture(level, 96, 54), 3, 1), back);
}

TEST(SmallPicture, IsNeverLargerThanAsked) {
  Level level;
  level.map = TileMap(1000, 10);
  const SheetPicture picture = small_picture(level, 96, 54);
  EXPECT_EQ(picture.width, 63);
  EXPECT_EQ(picture.height, 1);
  EXPECT_EQ(small_picture(level, 1, 1).width, 1);
}

class RecentPicturesTest : public FolderTest {};

TEST_F(RecentPicturesTest, AreKeptAsLongAsTheirFileIsRecent) {
  const RecentPictures pictures(path("pictures"));
  const SheetPicture picture = small_picture(two_layers(), 96, 54);
  pictures.keep(picture, "/a.tmx", {"/a.tmx"});
  pictures.keep(picture, "/b.tmx", {"/b.tmx", "/a.tmx"});
  ASSERT_NE(pictures.find("/a.tmx"), nullptr);
  EXPECT_EQ(*pictures.find("/b.tmx"), picture);
  EXPECT_EQ(pictures.find("/c.tmx"), nullptr);
  pictures.keep(picture, "/c.tmx", {"/c.tmx", "/b.tmx"});
  EXPECT_EQ(pictures.find("/a.tmx"), nullptr);
}

TEST_F(RecentPicturesTest, OthersInTheirPlaceAreNotShown) {
  const RecentPictures pictures(path("pictures"));
  pictures.keep(small_picture(two_layers(), 96, 54), "/a.tmx", {"/a.tmx"});
  const std::string place = std::filesystem::directory_iterator(path("pictures"))->path().filename();
  for (const std::string& bytes : {std::string(), std::string("damaged"), rgb_png(321, std::vector<Rgb>(321)),
                                   rgb_png(1, std::vector<Rgb>(181)), std::string(600'000, 'x')}) {
    put("pictures/" + place, bytes);
    EXPECT_EQ(pictures.find("/a.tmx"), nullptr) << bytes.size();
  }
}

class WorldPictures : public FolderTest {};

TEST_F(WorldPictures, AreThoseOfTheLevels) {
  put("t.png", rgb_png(8, std::vector<Rgb>(64, Rgb{200, 0, 0})));
  const std::string level = ldtk_tiles(4, 2, ldtk_tile(8, 8, 0));
  put("p.ldtk", ldtk_project(ldtk_level(level, "A") + "," + ldtk_level("", "B")));
  const LevelImport import = first_level_import(path("p.ldtk"));
  ASSERT_GE(import.pictures.size(), 1u);
  ASSERT_NE(import.pictures[0], nullptr);
  EXPECT_EQ(import.pictures[0]->width, 4);
  EXPECT_EQ(color_at(*import.pictures[0], 1, 1), (std::array<int, 3>{200, 0, 0}));
}

}  // namespace talus::small_pictures_test
