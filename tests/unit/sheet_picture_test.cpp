// Tiles in true colour: read from pictures of Tiled, kept by native levels, shown and exported.
#include <gmock/gmock.h>

#include <talus/level/limits.h>
#include <talus/level/tile_turns.h>
#include "export/lua_level.h"
#include "export/map_png.h"
#include "exported_level.h"
#include "folder_test.h"
#include "formats/pictures/png_picture.h"
#include "formats/pictures/png_sheet.h"
#include "level/edit.h"
#include "native_text.h"
#include "session/session.h"

namespace talus::sheet_picture_test {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr TileSize kTile{4, 2};

// Of two tiles side by side: each pixel has a colour of its own, and the last one is half opaque.
SheetPicture two_tiles() {
  SheetPicture picture{8, 2, {}};
  for (int i = 0; i < 16; ++i) {
    const auto part = static_cast<std::uint8_t>(i * 16);
    picture.rgba.insert(picture.rgba.end(), {part, static_cast<std::uint8_t>(255 - part), 7, 255});
  }
  picture.rgba.back() = 128;
  return picture;
}

Level level_in_true_colour() {
  Level level;
  level.map = TileMap(2, 1, kTile);
  level.set_tile_layout({2, 2});
  level.sheet(SheetId::tiles).picture = std::make_shared<const SheetPicture>(two_tiles());
  level.map.set({0, 0}, 1);
  return level;
}

std::string png_of(const SheetPicture& picture) {
  return encode_png(picture.width, picture.height, 4, picture.rgba.data());
}

class SheetPictureTest : public FolderTest {};

TEST_F(SheetPictureTest, IsKeptByNativeLevels) {
  const Level level = level_in_true_colour();
  const std::string text = native_of_level(level);
  EXPECT_THAT(text, HasSubstr("\"talus\": 3"));
  const Level again = level_of_native(text);
  EXPECT_TRUE(again == level);
  EXPECT_EQ(again.sheet(SheetId::tiles).picture->rgba, two_tiles().rgba);
  Level other = level;
  other.sheet(SheetId::tiles).picture = nullptr;
  EXPECT_FALSE(other == level);
}

TEST_F(SheetPictureTest, OfAnotherSizeIsRefused) {
  const auto with_picture = [](const std::string& lines) {
    return native_with(R"("tile_size": [4, 2], "sheet_size": [2, 2], "picture": )" + lines);
  };
  expect_native_error(with_picture("7"), "key picture", "must be a list of strings with a PNG in Base64");
  expect_native_error(with_picture(R"(["?"])"), "key picture",
                      "has a character that is not a digit of Base64");
  expect_native_error(with_picture(R"(["aaaa"])"), "key picture", "is not a PNG picture");
  std::string text = native_of_level(level_in_true_colour());
  const std::string size = "\"sheet_size\": [2, 2]";
  ASSERT_NE(text.find(size), std::string::npos) << text;
  text.replace(text.find(size), size.size(), "\"sheet_size\": [2, 4]");
  expect_native_error(text, "key picture", "has 8x2 px, but that of 2x2 tiles must have 8x4 px");
}

// A map of one row of cells, whose tileset has the picture of two tiles.
std::string map_text(const std::string& cells, int width) {
  return "<map orientation=\"orthogonal\" width=\"" + std::to_string(width) +
         "\" height=\"1\" tilewidth=\"4\" tileheight=\"2\"><tileset firstgid=\"1\" name=\"t\" "
         "tilewidth=\"4\" "
         "tileheight=\"2\" tilecount=\"2\" columns=\"2\"><image source=\"t.png\" width=\"8\" "
         "height=\"2\"/></tileset>"
         "<layer name=\"l\"><data encoding=\"csv\">" +
         cells + "</data></layer></map>";
}

TEST_F(SheetPictureTest, HasThePixelsOfATileset) {
  put("t.png", png_of(two_tiles()));
  put("map.tmx", map_text("1,2,1073741826", 3));
  const auto loaded = load_level(path("map.tmx"));
  ASSERT_TRUE(loaded) << to_string(loaded.error(), "map");
  const Sheet& sheet = loaded->level.sheet(SheetId::tiles);
  ASSERT_NE(sheet.picture, nullptr);
  EXPECT_EQ(sheet.picture->width, sheet.columns * 4);
  const SheetPicture source = two_tiles();
  const auto pixel = [](const SheetPicture& of, int x, int y) {
    const std::uint8_t* c = of.at(x, y);
    return std::vector<int>{c[0], c[1], c[2], c[3]};
  };
  const auto shown = [&](int cell, int x, int y) {
    const MapCell content = loaded->level.map.at({cell, 0});
    const Cell place = sheet.layout().place_of(content.tile),
               from = pixel_before_turn({x, y}, content.turn, {4, 2});
    return pixel(*sheet.picture, 4 * place.x + from.x, 2 * place.y + from.y);
  };
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 4; ++x) {
      EXPECT_EQ(shown(0, x, y), pixel(source, x, y));
      EXPECT_EQ(shown(1, x, y), pixel(source, 4 + x, y));
      EXPECT_EQ(shown(2, x, y), pixel(source, 4 + x, 1 - y)) << "upside down";
    }
  }
  EXPECT_THAT(loaded->dropped, testing::Not(testing::Contains(HasSubstr("colour"))));
}

TEST_F(SheetPictureTest, IsNotNeededForSixteenColours) {
  SheetPicture plain{32, 8, {}};
  for (int i = 0; i < 32 * 8; ++i) {
    const bool is_clear = i % 32 < 8;
    const Rgb color = default_palette()[static_cast<std::size_t>(i % 32 / 8)];  // colour 0 is not drawn
    plain.rgba.insert(plain.rgba.end(),
                      {color.r, color.g, color.b, static_cast<std::uint8_t>(is_clear ? 0 : 255)});
  }
  put("t.png", png_of(plain));
  put("map.tmx",
      "<map orientation=\"orthogonal\" width=\"1\" height=\"1\" tilewidth=\"8\" tileheight=\"8\"><tileset "
      "firstgid=\"1\" name=\"t\" tilewidth=\"8\" tileheight=\"8\" tilecount=\"4\" columns=\"4\"><image "
      "source=\"t.png\" width=\"32\" height=\"8\"/></tileset><layer name=\"l\"><data "
      "encoding=\"csv\">3</data></layer></map>");
  const auto loaded = load_level(path("map.tmx"));
  ASSERT_TRUE(loaded) << to_string(loaded.error(), "map");
  EXPECT_EQ(loaded->level.sheet(SheetId::tiles).picture, nullptr);
}

TEST_F(SheetPictureTest, IsWhatMapsAndSheetsAreExportedAs) {
  const Level level = level_in_true_colour();
  const auto sheet = read_rgba(write_map_tiles(level));
  ASSERT_TRUE(sheet);
  const std::vector<std::uint8_t> rgba = two_tiles().rgba;
  EXPECT_EQ(sheet->bytes, std::string(rgba.begin(), rgba.end()));
  const auto map = read_png(*map_png(level));
  ASSERT_TRUE(map);
  EXPECT_EQ(map->at(0, 0), (Rgb{64, 191, 7})) << "tile 1";
  EXPECT_EQ(map->at(4, 1), (Rgb{128, 127, 7})) << "tile 0";
  const Rgb under = level.palette[0];
  EXPECT_EQ(map->at(3, 1).r, (240 * 128 + under.r * 127 + 127) / 255) << "half opaque";
  EXPECT_THAT(lua_level(level, LuaForm::readable), HasSubstr("true_colour"));
}

TEST_F(SheetPictureTest, HidesPixelsOf16ColoursFromEdits) {
  Session session(level_in_true_colour());
  session.apply(action::EditLevel{{"Draw pixels", {PixelChange{SheetId::tiles, 0, 0, 0, 3}}}});
  EXPECT_FALSE(session.modified());
  ASSERT_TRUE(session.message());
  EXPECT_EQ(session.message()->text,
            "Draw pixels: not done, because the tiles are in true colour: the pixel tools paint them.");
  session.apply(action::EditLevel{{"Draw pixels", {PixelChange{SheetId::sprites, 0, 0, 0, 3}}}});
  EXPECT_TRUE(session.modified()) << "sprites have 16 colours";
}

TEST_F(SheetPictureTest, GoesWithItsLayout) {
  Level level = level_in_true_colour();
  level.set_tile_layout({2, 2});
  EXPECT_NE(level.sheet(SheetId::tiles).picture, nullptr);
  level.set_tile_layout({2, 4});
  EXPECT_EQ(level.sheet(SheetId::tiles).picture, nullptr);
}

}  // namespace talus::sheet_picture_test
