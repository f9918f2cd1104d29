// Pictures of other kinds than PNG and Aseprite: tests/fuzz/seeds has one of each, with four squares of 4x4
// px in red, green, blue and clear or magenta.
#include "formats/pictures/any_picture.h"

#include <gmock/gmock.h>

#include <cstdlib>

#include "folder_test.h"
#include "paths.h"

namespace talus::any_picture_test {

using testing::HasSubstr;

std::string seed(const std::string& name) {
  return read_file(source_path("tests/fuzz/seeds/") + name).value_or("");
}

std::array<int, 4> pixel_of(const RgbaPicture& picture, int x, int y) {
  std::array<int, 4> pixel{};
  for (std::size_t i = 0; i < pixel.size(); ++i)
    pixel[i] =
        static_cast<std::uint8_t>(picture.bytes[4 * static_cast<std::size_t>(y * picture.width + x) + i]);
  return pixel;
}

// slack: of colours, as JPEG keeps them nearly.
void expect_squares(const std::string& name, std::array<int, 4> last, int slack = 0) {
  const std::string bytes = seed(name);
  EXPECT_EQ(size_of_picture(bytes), (TileSize{8, 8})) << name;
  const auto picture = read_picture(bytes);
  ASSERT_TRUE(picture) << name << ": " << picture.error().message;
  const std::array<std::array<int, 4>, 4> wanted = {
      {{200, 0, 0, 255}, {0, 200, 0, 255}, {0, 0, 200, 255}, last}};
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const auto pixel = pixel_of(*picture, x, y);
      const auto& of_square = wanted[static_cast<std::size_t>(y / 4 * 2 + x / 4)];
      const bool is_edge = slack > 0 && (x % 4 == 0 || x % 4 == 3 || y % 4 == 0 || y % 4 == 3);
      for (std::size_t i = 0; i < 4 && !is_edge; ++i)
        EXPECT_LE(std::abs(pixel[i] - of_square[i]), slack) << name << " at " << x << ", " << y;
    }
  }
}

TEST(AnyPicture, OfEveryKindIsRead) {
  const std::array<int, 4> clear = {0, 0, 0, 0}, magenta = {255, 0, 255, 255};
  for (const char* name : {"small.gif", "interlaced.gif", "small.tga"}) expect_squares(name, clear);
  expect_squares("small.bmp", magenta);
  for (const char* name : {"small.jpg", "progressive.jpg", "cmyk.jpg"}) expect_squares(name, magenta, 60);
}

TEST(AnyPicture, TooLargeOnesAreRefusedUnread) {
  for (const char* name : {"small.gif", "small.jpg", "small.bmp", "small.tga"}) {
    const auto picture = read_picture(seed(name), 7);
    ASSERT_FALSE(picture) << name;
    EXPECT_EQ(picture.error().message, "is 8x8 px, but may have at most 7x7 px") << name;
  }
  std::string large = seed("small.gif");
  large[7] = large[9] = '\x7f';
  EXPECT_EQ(size_of_picture(large), (TileSize{0x7f08, 0x7f08}));
  EXPECT_THAT(read_picture(large, kMaxSheetPicturePixels).error().message, HasSubstr("16777216"));
}

TEST(AnyPicture, DamagedOnesAreErrorsOrPartlyClear) {
  EXPECT_EQ(read_picture("<svg/>").error().message, "is no PNG, JPEG, BMP, GIF, TGA or picture of Aseprite");
  const std::string gif = seed("small.gif");
  EXPECT_THAT(read_picture(gif.substr(0, 13)).error().message, HasSubstr("is a damaged GIF"));
  const auto half = read_picture(gif.substr(0, gif.size() - 12));
  ASSERT_TRUE(half) << half.error().message;
  EXPECT_EQ(pixel_of(*half, 7, 7)[3], 0);
  EXPECT_FALSE(read_picture(seed("small.jpg").substr(0, 40)));
}

TEST(AnyPicture, AJpegWithMoreCodesThanItsTablesHoldIsAnError) {
  std::string jpeg = seed("small.jpg");
  const std::size_t counts = jpeg.find("\xff\xc4") + 5;
  for (std::size_t i = 0; i < 16; ++i) jpeg[counts + i] = '\xff';
  const auto picture = read_picture(jpeg);
  ASSERT_FALSE(picture);
  EXPECT_THAT(picture.error().message, HasSubstr("is a damaged JPEG"));
}

TEST(AnyPicture, ScansOfAJpegAreCounted) {
  const std::string jpeg = seed("progressive.jpg");
  std::string many = jpeg.substr(0, jpeg.size() - 2);
  for (int i = 0; i < 100; ++i) many += jpeg.substr(jpeg.find("\xff\xda"));
  EXPECT_EQ(read_picture(many).error().message, "is a JPEG of more than 100 scans");
}

class AnyPictureFiles : public FolderTest {};

TEST_F(AnyPictureFiles, AreThoseOfTilesets) {
  for (const char* name : {"small.gif", "small.jpg", "small.bmp", "small.tga"}) {
    put(name, seed(name));
    put("map.tmx", R"(<map orientation="orthogonal" width="1" height="1" tilewidth="4" tileheight="4">)"
                   R"(<tileset firstgid="1" name="t" tilewidth="4" tileheight="4" tilecount="4" columns="2">)"
                   R"(<image source=")" +
                       std::string(name) +
                       R"(" width="8" height="8" trans="ff00ff"/></tileset>)"
                       R"(<layer id="1" name="l"><data encoding="csv">3</data></layer></map>)");
    const auto loaded = load_level(path("map.tmx"));
    ASSERT_TRUE(loaded);
    EXPECT_THAT(loaded->dropped, testing::Not(testing::Contains(HasSubstr(", file ")))) << name;
    const Level& level = loaded->level;
    const Sheet& sheet = level.sheet(SheetId::tiles);
    const TileNumber blue = level.map.tile_at({0, 0});
    const Cell place = sheet.layout().place_of(blue);
    const int shown = sheet.picture != nullptr ? sheet.picture->at(4 * place.x + 1, 4 * place.y + 1)[2]
                                               : level.palette[sheet.images[blue][27]].b;
    EXPECT_GT(shown, 140) << name;
  }
}

}  // namespace talus::any_picture_test
