// The files that a map of Tiled names: which of them are read, and what errors say of them.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>

#include <talus/formats/format.h>
#include "folder_test.h"
#include "png_bytes.h"

namespace talus::linked_files_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class LinkedFiles : public FolderTest {
 protected:
  void SetUp() override { fs::create_directories(path("maps")); }
  // What is said of a map with this picture, or with this tileset.
  std::string said_of_picture(const std::string& name) const {
    return error_with(
        R"(<tileset firstgid="1" name="t" tilewidth="8" tileheight="8" tilecount="1" columns="1">)"
        R"(<image source=")" +
        name + R"(" width="8" height="8"/></tileset>)");
  }
  std::string error_with_tileset(const std::string& name) const {
    return error_with(R"(<tileset firstgid="1" source=")" + name + R"("/>)");
  }
  std::string error_with(const std::string& tileset) const {
    put("maps/map.tmx",
        R"(<map version="1.10" orientation="orthogonal" width="1" height="1" tilewidth="8" tileheight="8">)" +
            tileset +
            R"(<layer id="1" name="l" width="1" height="1"><data encoding="csv">1</data></layer></map>)");
    const auto loaded = load_level(path("maps/map.tmx"), {.outside = outside_});
    if (!loaded) return to_string(loaded.error(), "map");
    for (const std::string& phrase : loaded->dropped)
      if (phrase.find(", file ") != phrase.npos) return phrase;
    return "";
  }

  std::vector<std::string> outside_ = {"/"};  // also where everything may be read
};

TEST_F(LinkedFiles, AreReadOnlyIfTheyAreRegularFiles) {
  ASSERT_EQ(::mkfifo(path("maps/pipe").c_str(), 0600), 0);
  fs::create_symlink("pipe", path("maps/link"));
  fs::create_symlink("/dev/zero", path("maps/endless"));
  for (const char* name :
       {"pipe", "link", "endless", "/dev/zero", "/etc/passwd", "file:///etc/passwd", "C:\\x"}) {
    EXPECT_THAT(said_of_picture(name), HasSubstr("the picture of the tileset")) << name;
    EXPECT_NE(error_with_tileset(name), "") << name;
  }
}

TEST_F(LinkedFiles, OtherContentIsNotQuotedInTheError) {
  put("secret", "hunter2:x:0:0\n");
  put("secret.json", R"({"hunter2": "hunter2", "type": "hunter2"})");
  put("secret.bad", R"({"tilewidth": hunter2})");
  put("secret.xml", "<hunter2>hunter2</hunter2><map hunter2=>");
  fs::create_symlink("../secret", path("maps/link"));
  for (const char* name : {"link", "../secret", "../secret.json", "../secret.bad", "../secret.xml"}) {
    EXPECT_THAT(said_of_picture(name), testing::AllOf(HasSubstr("the picture"), Not(HasSubstr("hunter2"))))
        << name;
    EXPECT_THAT(error_with_tileset(name), testing::AllOf(HasSubstr("error"), Not(HasSubstr("hunter2"))))
        << name;
  }
}

TEST_F(LinkedFiles, OutsideOfTheFolderAreReadIfThatIsAllowed) {
  fs::create_directories(path("art"));
  put("art/t.png", rgb_png(8, std::vector<Rgb>(64, Rgb{200, 0, 0})));
  put("art/t.tsx",
      R"(<tileset name="t" tilewidth="8" tileheight="8" tilecount="1" columns="1"><image source="t.png"/></tileset>)");
  fs::create_symlink("../art/t.png", path("maps/link.png"));
  outside_ = {};
  for (const char* name : {"../art/t.png", "link.png", "../maps/../art/t.png"}) {
    EXPECT_THAT(said_of_picture(name),
                HasSubstr(std::string("file ") + name + ": lies outside of the folder"));
    const auto loaded = load_level(path("maps/map.tmx"));
    EXPECT_THAT(loaded->refused, testing::ElementsAre(name));
    EXPECT_THAT(loaded->linked, testing::IsEmpty()) << "nobody watches it";
  }
  EXPECT_THAT(error_with_tileset("../art/t.tsx"), HasSubstr("../art/t.tsx: lies outside of the folder"));
  outside_ = {fs::canonical(path("art")).string()};
  for (const char* name : {"../art/t.png", "link.png"}) EXPECT_EQ(said_of_picture(name), "");
  EXPECT_EQ(error_with_tileset("../art/t.tsx"), "");
  EXPECT_EQ(load_level(path("maps/map.tmx"), {.outside = outside_})->linked.size(), 2u);
  outside_ = {fs::canonical(path("maps")).string() + "/art"};
  EXPECT_THAT(said_of_picture("../art/t.png"), HasSubstr("lies outside")) << "another folder of that name";
}

TEST_F(LinkedFiles, OutsideOfTheFolderAreSavedIfTheyWereRead) {
  fs::create_directories(path("art"));
  put("art/t.tsx",
      "<tileset name=\"t\" tilewidth=\"8\" tileheight=\"8\" tilecount=\"1\" columns=\"1\">\n"
      " <image source=\"t.png\" width=\"8\" height=\"8\"/>\n</tileset>\n");
  outside_ = {};
  error_with_tileset("../art/t.tsx");
  const std::string map = bytes_of("maps/map.tmx"), tileset = bytes_of("art/t.tsx");
  const auto save_solid = [&] {
    auto loaded = load_level(path("maps/map.tmx"), {.outside = outside_});
    loaded->level.tile_shapes[loaded->level.map.tile_at({0, 0})] = {.kind = TileShape::Kind::solid};
    return save_level(loaded->level, *loaded->format, loaded->path, loaded->companion).has_value();
  };
  ASSERT_TRUE(save_solid());
  EXPECT_EQ(bytes_of("maps/map.tmx"), map);
  EXPECT_EQ(bytes_of("art/t.tsx"), tileset) << "the companion has it";
  fs::remove(path("maps/map.tmx.talus.json"));
  outside_ = {fs::canonical(path("art")).string()};
  ASSERT_TRUE(save_solid());
  EXPECT_EQ(bytes_of("maps/map.tmx"), map);
  EXPECT_THAT(bytes_of("art/t.tsx"), HasSubstr("<object"));
}

}  // namespace talus::linked_files_test
