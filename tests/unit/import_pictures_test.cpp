// Pictures of Tiled's tilesets: of many sizes, of single tiles, and missing ones.
#include <gmock/gmock.h>

#include <talus/formats/format.h>
#include "folder_test.h"
#include "formats/import/numbered_box.h"
#include "level/tile_color.h"
#include "png_bytes.h"

namespace talus::import_pictures_test {

using testing::Contains;
using testing::ElementsAre;

// Of default_palette().
const Rgb kRed = default_palette()[2], kGreen = default_palette()[5], kBlue = default_palette()[9];

class ImportPictures : public FolderTest {
 protected:
  // A map of these cells in one row, which are 16x16 px.
  LoadedLevel read(const std::string& tilesets, const std::string& cells) const {
    const auto width = 1 + std::count(cells.begin(), cells.end(), ',');
    put("map.tmx", "<map orientation=\"orthogonal\" width=\"" + std::to_string(width) +
                       "\" height=\"1\" tilewidth=\"16\" tileheight=\"16\">" + tilesets +
                       "<layer name=\"l\"><data encoding=\"csv\">" + cells + "</data></layer></map>");
    auto loaded = load_level(path("map.tmx"), {.used_tiles = true});
    EXPECT_TRUE(loaded) << to_string(loaded.error(), "map");
    return loaded ? *loaded : LoadedLevel{Level(), nullptr};
  }
  static Rgb color(const Level& level, int cell, int x, int y) {
    const auto tile = level.map.tile_at({cell, 0});
    const auto at = static_cast<std::size_t>(8 * y + x);
    return level.palette[level.sheet(SheetId::tiles).images[tile][at]];
  }
  // A picture of columns of one colour each, of that width and height.
  static std::string columns(const std::vector<Rgb>& colors, int width, int height) {
    std::vector<Rgb> pixels;
    for (int y = 0; y < height; ++y) {
      for (const Rgb& color : colors) pixels.insert(pixels.end(), static_cast<std::size_t>(width), color);
    }
    return rgb_png(static_cast<std::uint32_t>(width) * static_cast<std::uint32_t>(colors.size()), pixels);
  }
};

std::string tileset(const std::string& attributes, const std::string& content, int first = 1) {
  return "<tileset firstgid=\"" + std::to_string(first) + "\" name=\"t\" " + attributes + ">" + content +
         "</tileset>";
}
const std::string kSmall = "tilewidth=\"16\" tileheight=\"16\" tilecount=\"4\" columns=\"2\"";

TEST_F(ImportPictures, WhereNothingIsDrawnNoColourOfTheTilesIsSeen) {
  const Rgb first{10, 200, 30}, second{200, 10, 30};
  put("t.png", columns({first, second}, 16, 16));
  const std::string set = tileset("tilewidth=\"16\" tileheight=\"16\" tilecount=\"2\" columns=\"2\"",
                                  "<image source=\"t.png\" width=\"32\" height=\"16\"/>");
  const Level level = read(set, "0,1,2").level;
  EXPECT_EQ(level.palette[0], default_palette()[0]);
  EXPECT_TRUE(is_blank(level, level.map.tile_at({0, 0})));
  for (const int cell : {1, 2}) {
    const std::uint64_t all = ~std::uint64_t{0};
    EXPECT_EQ(drawn_pixels(level, level.map.tile_at({cell, 0})), all);
    EXPECT_EQ(color(level, cell, 0, 0), cell == 1 ? first : second);
  }
}

TEST_F(ImportPictures, AreLimitedByTheirPixels) {
  put("t.png", columns({kRed, kGreen}, 2048, 2));
  const std::string set = tileset("tilewidth=\"16\" tileheight=\"2\" tilecount=\"256\" columns=\"256\"",
                                  "<image source=\"t.png\" width=\"4096\" height=\"2\"/>");
  const LoadedLevel loaded = read(set, "1,256");
  EXPECT_EQ(color(loaded.level, 0, 0, 7), kRed);
  EXPECT_EQ(color(loaded.level, 1, 0, 7), kGreen);
  put("t.png", columns({kRed}, 4097, 1));
  EXPECT_THAT(read(set, "1").dropped, testing::Not(Contains(testing::HasSubstr("t.png"))));
}

// Wider than a sheet may be: its tiles lie otherwise on theirs.
TEST_F(ImportPictures, MayBeLongerThanASheet) {
  put("t.png", columns({kRed, kGreen}, 16'384, 16));
  const std::string set = tileset("tilewidth=\"16\" tileheight=\"16\" tilecount=\"2048\" columns=\"2048\"",
                                  "<image source=\"t.png\" width=\"32768\" height=\"16\"/>");
  const LoadedLevel loaded = read(set, "1,2048");
  EXPECT_EQ(loaded.dropped, std::vector<std::string>());
  EXPECT_EQ(color(loaded.level, 0, 0, 7), kRed);
  EXPECT_EQ(color(loaded.level, 1, 0, 7), kGreen);
  const auto all = load_level(path("map.tmx"));
  ASSERT_TRUE(all);
  EXPECT_GE(all->level.tile_count(), 2048);
  EXPECT_EQ(color(all->level, 1, 0, 7), kGreen);
}

// It was the first colour of the picture, however bright.
TEST_F(ImportPictures, LeaveTheBackgroundToTheMap) {
  std::vector<Rgb> stripes(16, kRed);
  for (std::size_t i = 0; i < stripes.size(); i += 2) stripes[i] = kGreen;
  put("t.png", columns(stripes, 1, 16));
  const auto background = [this](const std::string& attribute) {
    put("map.tmx",
        "<map orientation=\"orthogonal\" width=\"1\" height=\"1\" tilewidth=\"16\" tileheight=\"16\"" +
            attribute + ">" +
            tileset("tilewidth=\"16\" tileheight=\"16\" tilecount=\"1\" columns=\"1\"",
                    "<image source=\"t.png\" width=\"16\" height=\"16\"/>") +
            "<layer name=\"l\"><data encoding=\"csv\">1</data></layer></map>");
    const auto loaded = load_level(path("map.tmx"));
    EXPECT_NE(loaded->level.sheet(SheetId::tiles).picture, nullptr);
    for (const std::string& phrase : loaded->dropped)
      EXPECT_EQ(phrase.find("backgroundcolor"), std::string::npos);
    EXPECT_EQ(loaded->level.palette[0], default_palette()[0]);
    return loaded->level.background;
  };
  EXPECT_EQ(background(" backgroundcolor=\"#0a7f64\""), (Rgba{0x0a, 0x7f, 0x64, 255}));
  EXPECT_EQ(background(""), Rgba());
}

// A picture that grew after the tileset was written; Tiled numbers its tiles anew.
TEST_F(ImportPictures, TellHowManyColumnsTheyHave) {
  put("t.png", columns({kRed, kGreen, kBlue}, 16, 32));
  const std::string set = tileset(kSmall, "<image source=\"t.png\" width=\"32\" height=\"32\"/>");
  const LoadedLevel loaded = read(set, "1,2,3,4");
  EXPECT_EQ(color(loaded.level, 2, 4, 4), kBlue);
  EXPECT_EQ(color(loaded.level, 3, 4, 4), kRed);
}

TEST_F(ImportPictures, ThatAreMissingLeaveNumberedBoxes) {
  const std::string set = tileset("tilewidth=\"16\" tileheight=\"16\" tilecount=\"400\" columns=\"20\"",
                                  "<image source=\"sub\\none.png\"/>");
  const LoadedLevel loaded = read(set, "1,2,346");
  EXPECT_THAT(loaded.dropped, ElementsAre("the picture of the tileset \"t\", file sub/none.png: cannot be "
                                          "opened: No such file or directory"));
  const int ids[] = {0, 1, 345};
  for (int cell = 0; cell < 3; ++cell) {
    for (int i = 0; i < 64; ++i)
      EXPECT_EQ(color(loaded.level, cell, i % 8, i / 8), color_of_box(ids[cell], i % 8, i / 8)) << i;
  }
  EXPECT_EQ(loaded.level.palette, default_palette());
  put("none.png", "JPEG");
  EXPECT_THAT(read(tileset(kSmall, "<image source=\"none.png\"/>"), "1").dropped,
              ElementsAre("the picture of the tileset \"t\", file none.png: is no PNG, JPEG, BMP, GIF, TGA "
                          "or picture of Aseprite"));
}

TEST(TiledBoxes, ShowTheLastTwoDigits) {
  std::string text;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) text += color_of_box(1247, x, y) == default_palette()[12] ? '#' : '.';
    text += '\n';
  }
  EXPECT_EQ(text,
            "........\n"
            "#.#.###.\n"
            "#.#...#.\n"
            "###..#..\n"
            "..#..#..\n"
            "..#..#..\n"
            "........\n"
            "........\n");
  EXPECT_NE(color_of_box(47, 0, 0), color_of_box(147, 0, 0)) << "the hundreds have their colours";
}

TEST_F(ImportPictures, TheTransparentColourIsNotDrawn) {
  put("t.png", columns({kRed, kGreen}, 8, 16));
  const std::string image = "<image source=\"t.png\" trans=\"";
  const auto corner = [&](const std::string& trans) {
    const LoadedLevel loaded =
        read(tileset(kSmall, "<image source=\"t.png\" trans=\"" + trans + "\"/>"), "1");
    return loaded.level.sheet(SheetId::tiles).images[1][0];
  };
  EXPECT_EQ(corner("b13e53"), 0);
  EXPECT_EQ(corner("#B13E53"), 0);
  EXPECT_EQ(corner("b13e5"), 2) << "no colour";
  EXPECT_EQ(corner("b13e54"), 2);
}

// Old versions of Tiled said neither columns nor the number of tiles, and some no size of the picture.
TEST_F(ImportPictures, SayTheirSizeIfTheFileDoesNot) {
  put("t.png", columns({kRed, kGreen, kBlue}, 16, 32));
  const LoadedLevel loaded =
      read(tileset("tilewidth=\"16\" tileheight=\"16\"", "<image source=\"t.png\"/>"), "3,4,6,7");
  EXPECT_EQ(color(loaded.level, 0, 0, 0), kBlue);
  EXPECT_EQ(color(loaded.level, 1, 0, 0), kRed);
  EXPECT_EQ(loaded.level.map.at({3, 0}), 0);
  EXPECT_THAT(loaded.dropped, Contains("tile 7 in cells, which no tileset has"));
}

TEST_F(ImportPictures, ATilesetWithoutAFileIsMissing) {
  const LoadedLevel loaded =
      read("<tileset firstgid=\"1\" source=\"none.tsx\"/>" + tileset(kSmall, "", 100), "0,7,3");
  EXPECT_EQ(color(loaded.level, 1, 0, 1), color_of_box(6, 0, 1));
  EXPECT_THAT(loaded.dropped, Contains("the tileset, file none.tsx: does not exist"));
}

TEST_F(ImportPictures, EachTileOfACollectionHasItsOwn) {
  put("red.png", columns({kRed}, 16, 16));
  put("both.png", columns({kGreen, kBlue}, 16, 16));
  const LoadedLevel loaded = read(
      tileset("tilewidth=\"16\" tileheight=\"16\" tilecount=\"4\" columns=\"0\"",
              "<tile id=\"0\"><image width=\"16\" height=\"16\" source=\"red.png\"/></tile>"
              "<tile id=\"7\"><image source=\"none.png\"/></tile>"
              "<tile id=\"3\" x=\"16\" y=\"0\" width=\"16\" height=\"16\"><image width=\"32\" "
              "height=\"16\" source=\"both.png\"/></tile>"
              "<tile id=\"2\"><image source=\"red.png\"/><objectgroup><object x=\"0\" y=\"8\" width=\"16\" "
              "height=\"8\"/></objectgroup></tile>"),
      "1,3,4,8");
  EXPECT_EQ(color(loaded.level, 0, 0, 0), kRed);
  EXPECT_EQ(color(loaded.level, 1, 7, 7), kRed);
  EXPECT_EQ(color(loaded.level, 2, 0, 0), kBlue);
  EXPECT_EQ(color(loaded.level, 3, 0, 1), color_of_box(7, 0, 1));
  EXPECT_EQ(loaded.level.tile_shapes[loaded.level.map.tile_at({1, 0})].heights, (std::vector<double>{8, 8}));
  EXPECT_THAT(loaded.dropped, Contains("a picture of the tileset \"t\", file none.png: cannot be opened: "
                                       "No such file or directory"));
  EXPECT_EQ(loaded.linked.size(), 3u) << "red.png is read once, none.png is looked for";
}

// Two red columns of 8 px, and a green one; the tile has 24x32 px, and its collision box is 4 px high, from
// 20 px above its bottom.
TEST_F(ImportPictures, LargerTilesShowThePartInTheirCell) {
  put("t.png", columns({kRed, kRed, kGreen}, 8, 32));
  const std::string box = "<objectgroup><object x=\"0\" y=\"20\" width=\"16\" height=\"12\"/></objectgroup>";
  const std::string size = "tilewidth=\"24\" tileheight=\"32\" tilecount=\"1\" columns=\"1\"";
  const std::string content = "<image source=\"t.png\"/><tile id=\"0\">" + box + "</tile>";
  const LoadedLevel loaded = read(tileset(size, content), "1,2147483649");
  EXPECT_EQ(color(loaded.level, 0, 7, 0), kRed);
  EXPECT_EQ(color(loaded.level, 1, 0, 0), kGreen) << "mirrored";
  EXPECT_EQ(color(loaded.level, 1, 4, 0), kRed);
  EXPECT_EQ(loaded.level.tile_shapes[loaded.level.map.tile_at({0, 0})].heights,
            (std::vector<double>{12, 12}));
  EXPECT_EQ(loaded.level.large_tiles.size(), 2u) << "the mirrored one, too";
  const LoadedLevel moved = read(tileset(size, "<tileoffset x=\"-8\" y=\"4\"/>" + content), "1");
  EXPECT_EQ(color(moved.level, 0, 3, 0), kRed);
  EXPECT_EQ(color(moved.level, 0, 4, 0), kGreen);
}

TEST_F(ImportPictures, SmallerTilesStandAtTheBottomLeft) {
  put("t.png", columns({kGreen}, 8, 8));
  const LoadedLevel loaded =
      read(tileset("tilewidth=\"8\" tileheight=\"8\" tilecount=\"1\" columns=\"1\"",
                   "<image source=\"t.png\"/><tile id=\"0\"><objectgroup><object x=\"0\" y=\"4\" "
                   "width=\"8\" height=\"4\"/></objectgroup></tile>"),
           "1");
  EXPECT_EQ(color(loaded.level, 0, 0, 4), kGreen);
  EXPECT_EQ(color(loaded.level, 0, 3, 7), kGreen);
  EXPECT_NE(color(loaded.level, 0, 4, 4), kGreen);
  EXPECT_NE(color(loaded.level, 0, 0, 3), kGreen);
  EXPECT_EQ(loaded.level.tile_shapes[1].points, (std::vector<Vec2>{{0, 12}, {8, 12}, {8, 16}, {0, 16}}))
      << "half of the cell";
}

TEST_F(ImportPictures, AMapOfObjectsAloneHasEmptyGround) {
  put("objects.tmx",
      "<map orientation=\"orthogonal\" width=\"3\" height=\"2\" tilewidth=\"16\" tileheight=\"16\">"
      "<objectgroup name=\"o\"><object type=\"ball\" x=\"1\" y=\"2\"/></objectgroup></map>");
  const auto loaded = load_level(path("objects.tmx"));
  ASSERT_TRUE(loaded) << to_string(loaded.error(), "map");
  EXPECT_THAT(loaded->level.map.cells().tiles(), ElementsAre(0, 0, 0, 0, 0, 0));
  EXPECT_EQ(loaded->level.spawns.size(), 1u);
}

}  // namespace talus::import_pictures_test
