// Pictures out of and into levels on the command line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <talus/formats/format.h>
#include "cli_answer.h"
#include "folder_test.h"
#include "formats/pictures/png_picture.h"
#include "png_bytes.h"

namespace talus::cli_png_test {

class CliPng : public FolderTest {
 protected:
  std::string level_path() const {
    Level level;
    level.sheet(SheetId::tiles).images[1].fill(9);
    EXPECT_TRUE(save_level(level, *find_format("native"), path("level.talus.json")));
    return path("level.talus.json");
  }
};

TEST_F(CliPng, ExportsEachPart) {
  const std::string level = level_path(), png = path("tiles.png");
  EXPECT_EQ(cli_answer({"export", level, "--to", "tiles-png", "-o", png}).status, kExitGood);
  const auto tiles = load_png(png);
  ASSERT_TRUE(tiles) << tiles.error().message;
  EXPECT_EQ(tiles->at(8, 0), default_palette()[9]);
  const CliAnswer palette = cli_answer({"export", level, "--to", "palette-png", "-o", "-"});
  EXPECT_EQ(palette.status, kExitGood);
  const auto colors = read_png(palette.out);
  ASSERT_TRUE(colors);
  EXPECT_EQ(colors->width, 16);
  const CliAnswer sprites = cli_answer({"export", level, "--to", "sprites-png", "-o", "-"});
  ASSERT_TRUE(read_png(sprites.out));
}

TEST_F(CliPng, AnOutputMustHaveAPicturesName) {
  const CliAnswer answer = cli_answer({"export", level_path(), "--to", "tiles-png", "-o", path("a.tic")});
  EXPECT_EQ(answer.status, kExitBad);
  EXPECT_EQ(answer.err,
            path("a.tic") + ": error: is not a name for a PNG picture of the tiles: it must end with .png\n");
}

TEST_F(CliPng, TakesAPictureIntoALevel) {
  const std::string level = level_path(),
                    png = put("in.png", rgb_png(8, std::vector<Rgb>(64, default_palette()[5])));
  const CliAnswer answer =
      cli_answer({"import", png, "--into", level, "--part", "sprites", "--tile", "7", "-o", level});
  EXPECT_EQ(answer.status, kExitGood) << answer.err;
  EXPECT_EQ(answer.out, level + ": 64 pixels of 1 tiles and 0 colours changed; largest colour distance 0\n");
  const auto loaded = load_level(level);
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->level.sheet(SheetId::sprites).images[7][5], 5);
  EXPECT_EQ(loaded->level.sheet(SheetId::tiles).images[1][0], 9);
}

TEST_F(CliPng, ABadPictureLeavesTheLevelAlone) {
  const std::string level = level_path(), out = path("unwritten.talus.json");
  const std::string png = put("bad.png", rgb_png(9, std::vector<Rgb>(9)));
  const CliAnswer size = cli_answer({"import", png, "--into", level, "-o", out});
  EXPECT_EQ(size.status, kExitBad);
  EXPECT_EQ(size.err,
            png + ": error: the picture is 9x1 px, which is not a whole number of tiles of 8x8 px\n");
  EXPECT_EQ(size.out, "");
  EXPECT_FALSE(exists("unwritten.talus.json"));
  const CliAnswer none = cli_answer({"import", level, "--into", level, "-o", out});
  EXPECT_EQ(none.err, level + ": error: is not a PNG picture\n");
  EXPECT_EQ(cli_answer({"import", png, "--tile", "3", "-o", out}).status, kExitUsage) << "into what?";
}

TEST_F(CliPng, ImportsACartInAPicture) {
  const std::string png = path("cart.png"), out = path("cart.talus.json");
  const std::string picture = rgb_png(1, {{1, 2, 3}});
  const std::string cart("\x04\x03\0\0\0\0\7", 7);  // tile 7 at (2, 0)
  put("cart.png",
      picture.substr(0, picture.size() - 12) + png_chunk("caRt", zipped(cart)) + png_chunk("IEND", ""));
  const CliAnswer answer = cli_answer({"import", png, "-o", out});
  EXPECT_EQ(answer.status, kExitGood) << answer.err;
  const auto loaded = load_level(out);
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->level.map.at({2, 0}), 7);
  put("cart.png", picture);
  const CliAnswer none = cli_answer({"import", png, "-o", out});
  EXPECT_EQ(none.status, kExitBad);
  EXPECT_EQ(none.err, png +
                          ": error: is a picture without a TIC-80 cartridge; to take its pixels, use File > "
                          "Import a picture or talus import --into\n");
}

}  // namespace talus::cli_png_test
