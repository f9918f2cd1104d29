// The list of formats: in which format a file is read and written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <talus/formats/format.h>
#include "folder_test.h"

namespace talus::format_test {

TEST(Formats, ErrorsNameTheFileAndThePlace) {
  EXPECT_EQ(to_string({"line 3", "is bad"}, "a.lua"), "a.lua:line 3: error: is bad");
  EXPECT_EQ(to_string({"", "is bad"}, "a.lua"), "a.lua: error: is bad");
}

TEST(Formats, AreFoundByIdAndByName) {
  EXPECT_EQ(find_format("tic")->id, "tic");
  EXPECT_EQ(find_format("tic-text")->id, "tic-text");
  EXPECT_EQ(find_format("native")->id, "native");
  EXPECT_EQ(find_format("png"), nullptr);
  EXPECT_EQ(format_for_file("dir.tic/a.LUA")->id, "tic-text");
  EXPECT_EQ(format_for_file("a.tic")->id, "tic");
  EXPECT_EQ(format_for_file("a.talus.json")->id, "native");
  EXPECT_EQ(format_for_file("a.json")->id, "native");
  EXPECT_EQ(format_for_file("a.png"), nullptr);
  EXPECT_EQ(format_for_file("tic"), nullptr);
}

TEST(Formats, TheContextIsTheExtension) {
  EXPECT_EQ(context_for_file("x/y.talus.JSON").extension, "json");
  EXPECT_EQ(context_for_file("x.y/z").extension, "");
  EXPECT_EQ(context_for_file("z").extension, "");
}

TEST(Formats, TheContentDecidesBeforeTheName) {
  const std::string text = "x\n-- <MAP>\n-- </MAP>\n", native = R"({"talus": 1})", cart("\x04\x01\0\0m", 5);
  for (const std::string extension : {"", "tic", "lua", "json", "txt"}) {
    EXPECT_EQ(read_level(text, {extension})->format->id, "tic-text") << extension;
    EXPECT_EQ(read_level(native, {extension})->format->id, "native") << extension;
    EXPECT_EQ(read_level(cart, {extension})->format->id, "tic") << extension;
  }
}

TEST(Formats, TheNameDecidesIfTheContentDoesNot) {
  EXPECT_EQ(read_level("print()", {"lua"})->format->id, "tic-text");
  EXPECT_EQ(read_level("print()", {"tic"}).error().place, "byte 0");
  EXPECT_EQ(read_level("print()", {"json"}).error().place, "line 1, column 1");
  EXPECT_EQ(read_level("print()", {"txt"}).error().message,
            "is in none of these formats: LDtk project; Tiled map, JSON; Tiled map, XML; Talus level; TIC-80 "
            "cartridge; "
            "TIC-80 PNG cartridge; TIC-80 text project");
}

class FormatFiles : public FolderTest {};

TEST_F(FormatFiles, SaveAndLoad) {
  const std::string file = path("level.tic");
  Level level;
  level.map.set({2, 3}, 4);
  const SavedLevel saved = save_level(level, *format_for_file(file), file).value();
  EXPECT_THAT(saved.dropped, testing::ElementsAre());
  EXPECT_EQ(saved.companion.path, "");
  const LoadedLevel loaded = load_level(file).value();
  EXPECT_EQ(loaded.format->id, "tic");
  EXPECT_EQ(loaded.level.map, level.map);
  EXPECT_EQ(loaded.path, file);
  std::filesystem::remove(file);
  EXPECT_EQ(load_level(file).error().message, "cannot be opened: No such file or directory");
}

TEST_F(FormatFiles, AFailedSaveWritesNothing) {
  const std::string file = path("level.lua");
  Level level;
  level.map = TileMap(300, 1);
  EXPECT_FALSE(save_level(level, *format_for_file(file), file));
  EXPECT_FALSE(exists("level.lua"));
}

}  // namespace talus::format_test
