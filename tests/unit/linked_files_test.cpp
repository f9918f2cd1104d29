// The files that a map of Tiled names: which of them are read, and what errors say of them.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>

#include <talus/formats/format.h>
#include "folder_test.h"

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
    const auto loaded = load_level(path("maps/map.tmx"));
    if (!loaded) return to_string(loaded.error(), "map");
    return loaded->dropped.empty() ? "" : loaded->dropped.front();
  }
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

}  // namespace talus::linked_files_test
