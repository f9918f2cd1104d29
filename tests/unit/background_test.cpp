// What is seen where a map shows nothing: in files, pictures, exports, edits and merges.
#include <gmock/gmock.h>

#include "edit/level_settings.h"
#include "exported_level.h"
#include "folder_test.h"
#include "formats/native/native.h"
#include "formats/pictures/png_picture.h"
#include "level/merge.h"
#include "overlay/small_picture.h"
#include "tiled_files.h"

namespace talus::background_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

using Pixel = std::array<int, 4>;

Pixel pixel_of(const RgbaPicture& picture, int x) {
  Pixel pixel{};
  for (std::size_t i = 0; i < pixel.size(); ++i)
    pixel[i] = static_cast<std::uint8_t>(picture.bytes[4 * static_cast<std::size_t>(x) + i]);
  return pixel;
}

class Background : public FolderTest {
 protected:
  // One row of two cells of 2x1 px: nothing, and a tile with a faint and an opaque pixel of one colour. map,
  // layer: attributes.
  void put_map(const std::string& map, const std::string& layer = "") const {
    const std::vector<std::uint8_t> pixels = {40, 0, 0, 64, 40, 0, 0, 255};
    put("t.png", encode_png(2, 1, 4, pixels.data()));
    put("m.tmx", "<map orientation=\"orthogonal\" width=\"2\" height=\"1\" tilewidth=\"2\" tileheight=\"1\"" +
                     map +
                     "><tileset firstgid=\"1\" name=\"t\" tilewidth=\"2\" tileheight=\"1\" tilecount=\"1\" "
                     "columns=\"1\"><image source=\"t.png\" width=\"2\" height=\"1\"/></tileset>"
                     "<layer name=\"l\" width=\"2\" height=\"1\"" +
                     layer + "><data encoding=\"csv\">0,1</data></layer></map>");
  }
  LoadedLevel load(const std::string& name) const {
    auto loaded = load_level(path(name));
    EXPECT_TRUE(loaded) << to_string(loaded.error(), name);
    return loaded ? *loaded : LoadedLevel{Level(), nullptr};
  }
  void save(const LoadedLevel& loaded, const Level& level, const std::string& name) const {
    ASSERT_TRUE(save_level(level, *loaded.format, path(name), loaded.companion));
  }
  // The first row of the picture of a level.
  static std::vector<Pixel> row_of(const Level& level) {
    const auto picture = read_rgba(exported_file("png", level), kMaxSheetPictureSide * 4);
    std::vector<Pixel> row;
    for (int x = 0; picture && x < picture->width; ++x) row.push_back(pixel_of(*picture, x));
    return row;
  }
};

// As Tiled draws them.
TEST_F(Background, PicturesStayClearAndFaint) {
  constexpr Pixel kClear{};
  put_map("");
  EXPECT_THAT(row_of(load("m.tmx").level),
              ElementsAre(kClear, kClear, Pixel{40, 0, 0, 64}, Pixel{40, 0, 0, 255}));
  put_map("", " tintcolor=\"#80ffffff\" opacity=\"0.5\"");
  EXPECT_THAT(row_of(load("m.tmx").level)[3], ElementsAre(20, 0, 0, 64)) << "Tiled darkens a clear tint";
  put_map(" backgroundcolor=\"#ff0080\"");
  EXPECT_THAT(row_of(load("m.tmx").level),
              ElementsAre(kClear, kClear, Pixel{40, 0, 0, 64}, Pixel{40, 0, 0, 255}))
      << "Tiled does not draw it into pictures";
}

// The colours of the tiles are in a palette of a file, whose first one is seen.
TEST_F(Background, IsNoColourOfTheTiles) {
  const std::vector<std::uint8_t> pixels = {224, 248, 208, 255, 224, 248, 208, 255};
  put_map("");
  put("t.png", encode_png(2, 1, 4, pixels.data()));
  const Level level = load("m.tmx").level;
  EXPECT_EQ(level.background, Rgba());
  EXPECT_EQ(level.palette[0], default_palette()[0]);
  EXPECT_EQ(row_of(level)[0], Pixel());
  EXPECT_EQ(row_of(level)[2], (Pixel{224, 248, 208, 255}));
  const Exported game = tiled_export_of(level, "tmx", "x.tmx");
  EXPECT_THAT(game.files[0].bytes, Not(HasSubstr("backgroundcolor")));
  for (const ExportedFile& file : game.files) put(file.name.empty() ? "x.tmx" : file.name, file.bytes);
  EXPECT_EQ(load("x.tmx").level.background, Rgba());
  EXPECT_EQ(row_of(load("x.tmx").level), row_of(level));
}

TEST_F(Background, IsSavedIntoMapsOfTiled) {
  put_map(" backgroundcolor=\"#FF0080\"");
  const std::string text = bytes_of("m.tmx");
  const LoadedLevel loaded = load("m.tmx");
  save(loaded, loaded.level, "m.tmx");
  EXPECT_EQ(bytes_of("m.tmx"), text) << "as it was written";
  const auto with = [&](const std::string& color) {
    std::string changed = text;
    return changed.replace(text.find("#FF0080"), 7, color);
  };
  Level level = loaded.level;
  level.background = Rgba{1, 2, 3, 128};
  save(loaded, level, "m.tmx");
  EXPECT_EQ(bytes_of("m.tmx"), with("#80010203"));
  EXPECT_EQ(load("m.tmx").level.background, level.background);
  level.background = Rgba();
  save(loaded, level, "m.tmx");
  EXPECT_THAT(bytes_of("m.tmx"), Not(HasSubstr("backgroundcolor")));
  EXPECT_EQ(load("m.tmx").level.background, Rgba());
  level.background.reset();
  save(loaded, level, "m.tmx");
  EXPECT_EQ(bytes_of("m.tmx"), with("#1a1c2c"));
  EXPECT_EQ(load("m.tmx").level.background, std::nullopt) << "which the companion says";
}

TEST_F(Background, IsSavedIntoMapsInJson) {
  const auto map = [](const std::string& member) {
    return R"({"type": "map", "orientation": "orthogonal", "width": 1, "height": 1, "tilewidth": 8,
 "tileheight": 8)" +
           member +
           R"(, "tilesets": [], "layers": [{"type": "tilelayer", "name": "l", "width": 1, "height": 1,
 "data": [0]}]})";
  };
  put("m.tmj", map(R"(, "backgroundcolor": "#abc")"));
  const LoadedLevel loaded = load("m.tmj");
  EXPECT_EQ(loaded.level.background, (Rgba{0xaa, 0xbb, 0xcc, 255}));
  save(loaded, loaded.level, "m.tmj");
  EXPECT_EQ(bytes_of("m.tmj"), map(R"(, "backgroundcolor": "#abc")"));
  Level level = loaded.level;
  level.background = Rgba{1, 2, 3, 255};
  save(loaded, level, "m.tmj");
  EXPECT_EQ(bytes_of("m.tmj"), map(R"(, "backgroundcolor": "#010203")"));
  level.background = Rgba();
  save(loaded, level, "m.tmj");
  EXPECT_EQ(bytes_of("m.tmj"), map(""));
}

std::string bytes_of_native(const Level& level) { return write_native(level, {})->bytes; }

TEST(BackgroundOfALevel, IsAKeyOfNativeFiles) {
  const Level none;
  EXPECT_EQ(bytes_of_native(none).find("background"), std::string::npos) << "files keep their bytes";
  for (const Rgba color : {Rgba{1, 2, 0xab, 255}, Rgba{1, 2, 3, 0}, Rgba{9, 8, 7, 0x80}}) {
    Level level;
    level.background = color;
    EXPECT_NE(level, none);
    const auto again = read_native(bytes_of_native(level), {});
    ASSERT_TRUE(again);
    EXPECT_EQ(again->background, color);
    EXPECT_EQ(*again, level);
  }
  Level level;
  level.background = Rgba{1, 2, 0xab, 0x80};
  EXPECT_THAT(bytes_of_native(level), HasSubstr("\"background\": \"#800102ab\""));
  for (const char* wrong : {"1", "\"010203\"", "\"#123\"", "\"#12345\"", "\"#12345g\"", "null"}) {
    const auto read = read_native("{\"talus\": 8, \"background\": " + std::string(wrong) + "}", {});
    ASSERT_FALSE(read) << wrong;
    EXPECT_EQ(read.error().place, "key background");
  }
}

TEST(BackgroundOfALevel, IsInExports) {
  Level level;
  level.map = TileMap(1, 1);
  EXPECT_THAT(exported_file("json", level), HasSubstr("\"background\":[26,28,44,255]"));
  EXPECT_THAT(exported_file("lua", level), HasSubstr("background={26,28,44,255}"));
  level.background = Rgba{1, 2, 3, 128};
  EXPECT_THAT(exported_file("json", level), HasSubstr("\"background\":[1,2,3,128]"));
  EXPECT_THAT(tiled_export_of(level, "sti", "m.lua").files[0].bytes,
              HasSubstr("backgroundcolor = {1, 2, 3, 128}"));
  EXPECT_THAT(tiled_export_of(level, "tmx", "m.tmx").files[0].bytes,
              HasSubstr("backgroundcolor=\"#80010203\""));
  level.background = Rgba();
  for (const char* id : {"json", "lua"}) EXPECT_THAT(exported_file(id, level), Not(HasSubstr("background")));
  for (const char* id : {"sti", "tmx", "tmj"})
    EXPECT_THAT(tiled_export_of(level, id, "m").files[0].bytes, Not(HasSubstr("backgroundcolor"))) << id;
}

// Colour 0 of a cart is opaque, and its picture has no opacity.
TEST(BackgroundOfALevel, IsColour0IfItHasNone) {
  Level level;
  level.map = TileMap(1, 1);
  const std::string png = exported_file("png", level);
  EXPECT_EQ(png[25], 2) << "the kind of a PNG in RGB";
  level.palette[0] = {7, 8, 9};
  EXPECT_EQ(background_of(level), (Rgba{7, 8, 9, 255}));
  EXPECT_EQ(read_png(exported_file("png", level))->at(3, 3), (Rgb{7, 8, 9}));
  const SheetPicture small = small_picture(level, 4, 4);
  EXPECT_THAT(small.rgba, ElementsAre(7, 8, 9, 255));
  level.background = Rgba();
  EXPECT_THAT(small_picture(level, 4, 4).rgba, ElementsAre(0, 0, 0, 0));
}

TEST(BackgroundOfALevel, CanBeUndoneAndMerged) {
  const Level base;
  Level level = base;
  const Edit edit = set_background(base, Rgba{1, 2, 3, 4});
  apply_edit(level, edit);
  EXPECT_EQ(level.background, (Rgba{1, 2, 3, 4}));
  Level theirs = base;
  theirs.palette[3] = {};
  const MergedLevel merged = merge_levels(base, level, theirs, MergeSide::theirs);
  EXPECT_EQ(merged.level.background, level.background);
  EXPECT_TRUE(merged.conflicts.empty());
  theirs.background = Rgba();
  EXPECT_THAT(merge_levels(base, level, theirs, MergeSide::mine).conflicts, ElementsAre("the background"));
  revert_edit(level, edit);
  EXPECT_EQ(level, base);
  EXPECT_TRUE(set_background(base, std::nullopt).empty());
}

}  // namespace talus::background_test
