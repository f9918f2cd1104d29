// Tilesets: parts of the sheet of tiles with a name, some of which show a PNG on disk.
#include <gmock/gmock.h>

#include <filesystem>

#include "cli_answer.h"
#include "folder_test.h"
#include "formats/native/native.h"
#include "formats/pictures/png_picture.h"
#include "formats/tilesets/new_tileset.h"
#include "formats/tilesets/tile_cut.h"
#include "formats/tilesets/tileset_pixels.h"
#include "level/edit.h"
#include "level/tile_words.h"

namespace talus::tilesets_test {

using testing::HasSubstr;
namespace fs = std::filesystem;

// A picture of 2x2 tiles of 16x16 px with 1 px around and between them; each tile has a colour of its own.
std::string tiles_png(int rows = 2) {
  const int width = 35, height = 1 + 17 * rows;
  std::vector<std::uint8_t> rgba(static_cast<std::size_t>(4 * width * height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (x % 17 == 0 || y % 17 == 0) continue;
      std::uint8_t* pixel = &rgba[static_cast<std::size_t>(4 * (y * width + x))];
      pixel[0] = static_cast<std::uint8_t>(100 * (x / 17) + 50);
      pixel[1] = static_cast<std::uint8_t>(100 * (y / 17) + 50);
      pixel[3] = 255;
    }
  }
  return encode_png(width, height, 4, rgba.data());
}

RgbaPicture picture_of(const std::string& png) { return *read_rgba(png); }

Level level_with_sets() {
  Level level;
  level.map = TileMap(4, 3, {16, 16});
  level.set_tile_layout({4, 16});
  level.tilesets = {{.name = "grass", .first = 0, .count = 6, .columns = 2},
                    {.name = "rock", .first = 8, .count = 8, .columns = 4}};
  return level;
}

Level read_back(const Level& level) { return *read_native(write_native(level, {})->bytes, {}); }

TEST(Tilesets, KnowTheirTiles) {
  const Level level = level_with_sets();
  const SheetLayout layout = level.sheet(SheetId::tiles).layout();
  EXPECT_FALSE(problem_of(level.tilesets, layout));
  EXPECT_EQ(tileset_with(level.tilesets, layout, 5), 0);
  EXPECT_EQ(tileset_with(level.tilesets, layout, 2), -1) << "beside the rectangle";
  EXPECT_EQ(tileset_with(level.tilesets, layout, 6), -1);
  EXPECT_EQ(tileset_with(level.tilesets, layout, 15), 1);
  EXPECT_TRUE(problem_of(level.tilesets, SheetLayout{4, 15}));
  EXPECT_TRUE(problem_of({level.tilesets[1], level.tilesets[0]}, layout));
  EXPECT_TRUE(problem_of({{.first = 6, .count = 3, .columns = 3}}, layout)) << "wider than the sheet";
}

TEST(Tilesets, AreStoredInANativeLevel) {
  Level level = level_with_sets();
  level.tilesets[1].extra = R"({"author":"me"})";
  const std::string text = write_native(level, {})->bytes;
  EXPECT_THAT(text, HasSubstr("\"talus\": 5"));
  EXPECT_EQ(read_back(level), level);
  level.tilesets.clear();
  EXPECT_THAT(write_native(level, {})->bytes, HasSubstr("\"talus\": 3"));
}

TEST(Tilesets, BadOnesAreRefusedWithTheirPlace) {
  const auto error = [](const std::string& sets) {
    const auto read = read_native(R"({"talus": 5, "tilesets": )" + sets + "}", {});
    return read ? "" : to_string(read.error(), "a");
  };
  EXPECT_THAT(error("3"), HasSubstr("key tilesets"));
  EXPECT_THAT(error(R"([{"first": 0, "count": 1}])"), HasSubstr("tilesets[0].columns"));
  EXPECT_THAT(error(R"([{"first": 250, "count": 9, "columns": 1}])"), HasSubstr("[0] must have tiles"));
  EXPECT_THAT(error(R"([{"first": 0, "count": 9, "columns": 1, "image": "a.png", "margin": -1}])"),
              HasSubstr("tilesets[0].margin"));
}

TEST(Tilesets, ARenamedOneIsUndone) {
  Level level = level_with_sets();
  const Level before = level;
  std::vector<Tileset> renamed = level.tilesets;
  renamed[0].name = "moss";
  const Edit edit{"Rename tileset", {TilesetsChange{level.tilesets, renamed}}};
  apply_edit(level, edit);
  EXPECT_EQ(level.tilesets[0].name, "moss");
  revert_edit(level, edit);
  EXPECT_EQ(level, before);
}

TEST(TileCut, GuessesGapsBetweenTiles) {
  EXPECT_EQ(guess_cut(picture_of(tiles_png())), (TileCut{{16, 16}, 1, 1}));
  const std::vector<std::uint8_t> plain(4 * 64 * 48, 255);
  EXPECT_EQ(guess_cut(picture_of(encode_png(64, 48, 4, plain.data()))), (TileCut{{16, 16}}));
  EXPECT_EQ(guess_cut(picture_of(encode_png(54, 36, 4, plain.data()))), (TileCut{{18, 18}}));
}

TEST(TileCut, CountsTilesAndWhatIsLeftOver) {
  const CutGrid grid = grid_of({{16, 16}}, 35, 33);
  EXPECT_EQ(grid.columns, 2);
  EXPECT_EQ(grid.rows, 2);
  EXPECT_EQ(grid.rest_x, 3);
  EXPECT_EQ(grid.rest_y, 1);
  EXPECT_EQ(problem_of({{16, 16}}, 35, 33), "");
  EXPECT_THAT(problem_of({{0, 16}}, 35, 33), HasSubstr("1 to 256"));
  EXPECT_THAT(problem_of({{64, 64}}, 35, 33), HasSubstr("No tile"));
  EXPECT_THAT(problem_of({{16, 16}, -1}, 35, 33), HasSubstr("Spacing"));
  EXPECT_THAT(problem_of({{1, 1}}, 4000, 1), HasSubstr("at most 2048"));
}

class LinkedTilesets : public FolderTest {
 protected:
  void SetUp() override {
    fs::create_directories(path("art"));
    fs::create_directories(path("levels"));
  }
  Level linked() const {
    Level level = level_with_sets();
    level.set_tile_layout({4, 14});
    level.tilesets = {{.name = "art",
                       .first = 8,
                       .count = 6,
                       .columns = 2,
                       .link = TilesetLink{path("art/tiles.png"), {{16, 16}, 1, 1}}}};
    return level;
  }
};

TEST_F(LinkedTilesets, TheFileHasThePathAndNotThePixels) {
  put("art/tiles.png", tiles_png());
  const Level level = linked();
  ASSERT_TRUE(save_level(level, *find_format("native"), path("a.talus.json")));
  const std::string text = bytes_of("a.talus.json");
  EXPECT_THAT(text, HasSubstr("\"image\": \"art/tiles.png\""));
  EXPECT_THAT(text, testing::Not(HasSubstr("\"picture\"")));
  const auto loaded = load_level(path("a.talus.json"));
  ASSERT_TRUE(loaded);
  EXPECT_THAT(loaded->linked, testing::Contains(HasSubstr("tiles.png")));
  const auto& picture = loaded->level.sheet(SheetId::tiles).picture;
  ASSERT_NE(picture, nullptr);
  EXPECT_EQ(picture->at(16, 3 * 16)[0], 150) << "tile 13 is the last one";
  EXPECT_EQ(picture->at(16, 3 * 16)[1], 150);
  // Saving it again gives the same bytes.
  ASSERT_TRUE(save_level(loaded->level, *find_format("native"), path("a.talus.json")));
  EXPECT_EQ(bytes_of("a.talus.json"), text);
}

TEST_F(LinkedTilesets, AMissingPictureIsNumberedBoxes) {
  ASSERT_TRUE(save_level(linked(), *find_format("native"), path("a.talus.json")));
  const auto loaded = load_level(path("a.talus.json"));
  ASSERT_TRUE(loaded);
  EXPECT_TRUE(loaded->level.tilesets[0].link->is_missing);
  ASSERT_EQ(loaded->dropped.size(), 1u);
  EXPECT_THAT(loaded->dropped[0], HasSubstr("art/tiles.png"));
  EXPECT_EQ(loaded->level.sheet(SheetId::tiles).picture->at(0, 2 * 16)[3], 255);
}

TEST_F(LinkedTilesets, NothingOutsideOfTheFolderIsRead) {
  put("art/tiles.png", tiles_png());
  put("levels/a.talus.json", R"({"talus": 5, "tile_size": [16, 16], "sheet_size": [4, 14], "tilesets":
      [{"first": 8, "count": 6, "columns": 2, "image": "../art/tiles.png", "tile_size": [16, 16]}]})");
  const auto loaded = load_level(path("levels/a.talus.json"));
  ASSERT_TRUE(loaded);
  EXPECT_TRUE(loaded->level.tilesets[0].link->is_missing);
  EXPECT_TRUE(loaded->linked.empty());
  EXPECT_THAT(loaded->dropped, testing::ElementsAre(HasSubstr("lies outside of the folder")));
  // Saved elsewhere, a level keeps the pixels of a picture that it cannot link to.
  Level level = linked();
  const RgbaPicture picture = picture_of(tiles_png());
  const ShownTileset shown{0, level.tilesets[0].link->cut, &picture};
  ASSERT_TRUE(draw_tilesets({&shown, 1}, level));
  const auto saved = save_level(level, *find_format("native"), path("levels/b.talus.json"));
  ASSERT_TRUE(saved);
  EXPECT_EQ(saved->dropped.size(), 1u);
  const auto copy = load_level(path("levels/b.talus.json"));
  EXPECT_FALSE(copy->level.tilesets[0].link);
  EXPECT_EQ(copy->level.sheet(SheetId::tiles), level.sheet(SheetId::tiles));
}

TEST_F(LinkedTilesets, AllowedOnesOutsideOfTheFolderAreReadAndStayLinks) {
  put("art/tiles.png", tiles_png());
  put("levels/a.talus.json", R"({"talus": 5, "tile_size": [16, 16], "sheet_size": [4, 14], "tilesets":
      [{"first": 8, "count": 6, "columns": 2, "image": "../art/tiles.png", "tile_size": [16, 16]}]})");
  const auto unread = load_level(path("levels/a.talus.json"));
  ASSERT_TRUE(unread);
  EXPECT_THAT(unread->refused, testing::ElementsAre("../art/tiles.png"));
  const auto loaded = load_level(path("levels/a.talus.json"), {.outside = {path("art")}});
  ASSERT_TRUE(loaded);
  EXPECT_FALSE(loaded->level.tilesets[0].link->is_missing);
  EXPECT_TRUE(loaded->refused.empty());
  for (const Level& level : {unread->level, loaded->level}) {
    ASSERT_TRUE(save_level(level, *find_format("native"), path("levels/a.talus.json")));
    EXPECT_THAT(bytes_of("levels/a.talus.json"), HasSubstr(R"("image": "../art/tiles.png")"));
  }
  ASSERT_TRUE(save_level(loaded->level, *find_format("native"), path("b.talus.json")));
  EXPECT_THAT(bytes_of("b.talus.json"), HasSubstr(R"("image": "art/tiles.png")"))
      << "it is inside of this folder";
}

TEST_F(LinkedTilesets, APictureWithMoreRowsGivesMoreTiles) {
  put("art/tiles.png", tiles_png(3));
  ASSERT_TRUE(save_level(linked(), *find_format("native"), path("a.talus.json")));
  const auto loaded = load_level(path("a.talus.json"));
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->level.tile_count(), 18);
  EXPECT_EQ(loaded->level.tilesets[0].count, 10);
  EXPECT_EQ(loaded->level.sheet(SheetId::tiles).picture->at(0, 4 * 16)[1], 250);
}

Level level_of(const std::string& png, const TileCut& cut) {
  const RgbaPicture picture = picture_of(png);
  return *level_of_tiles({.picture = picture, .cut = cut, .name = "art"}, 10, 5);
}

TEST(NewTileset, AFileNameThatIsNotUtf8CanBeSaved) {
  const RgbaPicture picture = picture_of(tiles_png());
  const Level level = *level_of_tiles({.picture = picture, .cut = {{16, 16}, 1, 1}, .name = "t\xff"}, 10, 5);
  EXPECT_EQ(level.tilesets[0].name, "t\\xff");
  EXPECT_TRUE(write_native(level, {}));
}

TEST(NewTileset, ALevelHasTheTilesBelowABlankRow) {
  const Level level = level_of(tiles_png(), {{16, 16}, 1, 1});
  EXPECT_EQ(level.map.tile_size(), (TileSize{16, 16}));
  EXPECT_EQ(level.map.width(), 10);
  EXPECT_EQ(level.tile_count(), 6);
  ASSERT_EQ(level.tilesets.size(), 1u);
  EXPECT_EQ(level.tilesets[0], (Tileset{.name = "art", .first = 2, .count = 4, .columns = 2}));
  const Sheet& sheet = level.sheet(SheetId::tiles);
  EXPECT_EQ(sheet.picture, nullptr) << "four colours are those of the level";
  EXPECT_EQ(sheet.images[0], TileImage{});
  EXPECT_EQ(level.palette[sheet.images[5][0]], (Rgb{150, 150, 0}));
  EXPECT_EQ(read_back(level), level);
}

TEST(NewTileset, AnAddedOneLiesBelowAndKeepsWhatIsThere) {
  Level level = level_of(tiles_png(), {{16, 16}, 1, 1});
  level.map.set({3, 2}, 5);
  level.sheet(SheetId::tiles).flags[5] = 1;
  const RgbaPicture wide = picture_of(tiles_png());
  // Cut into tiles of 8 px it is wider than the sheet.
  const Level more = *with_tileset(level, {.picture = wide, .cut = {{8, 8}}, .name = "small"});
  ASSERT_EQ(more.tilesets.size(), 2u);
  EXPECT_EQ(more.sheet(SheetId::tiles).columns, 4);
  EXPECT_EQ(more.tilesets[0], (Tileset{.name = "art", .first = 4, .count = 6, .columns = 2}));
  EXPECT_EQ(more.tilesets[1], (Tileset{.name = "small", .first = 12, .count = 16, .columns = 4}));
  EXPECT_FALSE(problem_of(more.tilesets, more.sheet(SheetId::tiles).layout()));
  EXPECT_EQ(more.map.at({3, 2}), 9);
  EXPECT_EQ(more.sheet(SheetId::tiles).flags[9], 1);
  EXPECT_EQ(more.sheet(SheetId::tiles).picture->at(16, 32)[0], 150);
  EXPECT_EQ(read_back(more), more);
  // Without the first one again, the other moves up.
  const Level less = without_tileset(more, 0);
  ASSERT_EQ(less.tilesets.size(), 1u);
  EXPECT_EQ(less.tilesets[0].first, 4);
  EXPECT_EQ(less.map.at({3, 2}), 0);
  EXPECT_FALSE(problem_of(less.tilesets, less.sheet(SheetId::tiles).layout()));
  EXPECT_EQ(without_tileset(more, 1).tilesets[0], more.tilesets[0]);
}

TEST_F(LinkedTilesets, TalusNewMakesALevelOfAPicture) {
  put("art/tiles.png", tiles_png());
  const CliAnswer made = cli_answer(
      {"new", "--tiles", path("art/tiles.png"), "--link", "--size", "12x6", "-o", path("a.talus.json")});
  EXPECT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr("4 tiles of 16x16 px, spacing 1, margin 1"));
  const auto loaded = load_level(path("a.talus.json"));
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->level.map.width(), 12);
  ASSERT_TRUE(loaded->level.tilesets[0].link);
  EXPECT_EQ(loaded->level.sheet(SheetId::tiles).picture->at(0, 16)[0], 50);
  EXPECT_THAT(cli_answer({"new", "--tiles", path("art/tiles.png"), "--tile-size", "64x64", "-o",
                          path("b.talus.json")})
                  .err,
              HasSubstr("no tile of this size fits"));
  EXPECT_THAT(
      cli_answer({"new", "--tiles", path("art/tiles.png"), "--link", "-o", path("levels/b.talus.json")}).err,
      HasSubstr("is not below the folder of the level"));
  EXPECT_FALSE(exists("levels/b.talus.json"));
}

TEST(TileWords, FindByNumberTilesetFlagAndShape) {
  Level level = level_with_sets();
  level.flag_names[5] = "Water";
  level.sheet(SheetId::tiles).flags[9] = 1 << 5;
  level.sheet(SheetId::tiles).flags[4] = 1;  // solid
  level.tile_shapes[12] = {.kind = TileShape::Kind::slope, .one_way = true, .heights = {0, 16}};
  const auto found = [&](const char* text) {
    std::vector<int> tiles;
    const auto all = find_tiles(level, text);
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i]) tiles.push_back(static_cast<int>(i));
    return tiles;
  };
  using testing::ElementsAre;
  EXPECT_THAT(found("1"), ElementsAre(1));
  EXPECT_THAT(found("#12"), ElementsAre(12));
  EXPECT_THAT(found("grass"), ElementsAre(0, 1, 4, 5));
  EXPECT_THAT(found("flag:water"), ElementsAre(9));
  EXPECT_THAT(found("flag:5"), ElementsAre(9));
  EXPECT_THAT(found("solid"), ElementsAre(4));
  EXPECT_THAT(found("Rock SLOPE"), ElementsAre(12));
  EXPECT_THAT(found("one-way"), ElementsAre(12));
  EXPECT_THAT(found("grass slope"), ElementsAre());
  EXPECT_THAT(found("set:gra"), ElementsAre(0, 1, 4, 5));
  EXPECT_THAT(found("flag:grass"), ElementsAre());
  EXPECT_TRUE(find_tiles(level, "  ").empty());
}

}  // namespace talus::tilesets_test
