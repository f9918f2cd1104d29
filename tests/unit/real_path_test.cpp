// Where paths lead, and what may be written there.
#include "formats/files/real_path.h"

#include <sys/stat.h>

#include "export/export_bounds.h"
#include "folder_test.h"

namespace talus::real_path_test {

namespace fs = std::filesystem;

class RealPath : public FolderTest {
 protected:
  void SetUp() override {
    root_ = fs::canonical(folder_).string();
    fs::create_directories(path("in/deep"));
    fs::create_directories(path("out"));
  }
  std::string real(const std::string& name) const { return real_path(path(name)).value_or("(none)"); }
  std::string below(const std::string& name) const { return root_ + "/" + name; }
  void link(const std::string& name, const std::string& target) const {
    fs::create_symlink(target, path(name));
  }

  std::string root_;
};

TEST_F(RealPath, FollowsEveryLinkEvenDanglingOnes) {
  EXPECT_EQ(real("in/./deep/../x"), below("in/x"));
  EXPECT_EQ(real("none/at/all"), below("none/at/all"));
  link("in/dangling", "../out/none");
  EXPECT_EQ(real("in/dangling"), below("out/none"));
  EXPECT_EQ(real("in/dangling/x"), below("out/none/x"));
  link("in/folder", path("out"));
  link("in/chain", "folder");
  EXPECT_EQ(real("in/chain/../x"), below("x")) << ".. starts at the link's target, as for the system";
  link("in/circle", "circle");
  EXPECT_EQ(real_path(path("in/circle")).error().message, "leads through links in a circle");
  link("level", "in/level.json");
  EXPECT_EQ(real_folder_of(path("level")).value(), root_) << "where the link lies";
}

TEST_F(RealPath, AFolderDoesNotContainItsNeighbours) {
  EXPECT_TRUE(is_within("/a/b", "/a/b"));
  EXPECT_TRUE(is_within("/a/b/c", "/a/b"));
  EXPECT_TRUE(is_within("/a", "/"));
  EXPECT_FALSE(is_within("/a/bc", "/a/b"));
  EXPECT_FALSE(is_within("/a", "/a/b"));
}

TEST_F(RealPath, LinksCannotLeaveTheAllowedFolder) {
  const ExportBounds bounds = bounds_of_level(path("in/level.talus.json"));
  const auto place = [&](const std::string& name) { return place_within(bounds, path(name), true); };
  link("in/leaves", "../out");
  link("in/stays", "deep");
  link("in/dangling", "../init.lua");
  EXPECT_EQ(place("in/stays/x").value(), below("in/deep/x")) << "written without a link";
  EXPECT_FALSE(place("in/leaves/x"));
  EXPECT_FALSE(place("in/../x"));
  EXPECT_FALSE(place_within(bounds, "/etc/x", true));
  EXPECT_EQ(place("in/dangling").error().message,
            path("in/dangling") + " leads to " + below("init.lua") + ", which is outside of " + below("in"));
  ASSERT_EQ(::mkfifo(path("in/pipe").c_str(), 0600), 0);
  EXPECT_EQ(place("in/pipe").error().message,
            path("in/pipe") + " is a device or a pipe, but must be a regular file");
  EXPECT_FALSE(place_within(bounds_of_level(""), path("in/x"), true))
      << "a level without a file has no folder";
}

TEST_F(RealPath, OnlyATypedPathMayBeAnywhere) {
  link("in/cave.tmj", "../out/cave.tmj");
  link("in/cave-tiles.png", "../out/tiles.png");
  const ExportBounds bounds = bounds_of_output(path("in/cave.tmj"), false);
  EXPECT_TRUE(place_within(bounds, path("in/cave.tmj"), true));
  EXPECT_FALSE(place_within(bounds, path("in/cave-tiles.png"), false));
  link("in/game", "../out");
  EXPECT_TRUE(place_within(bounds_of_output(path("in/game"), true), path("in/game/level.lua"), false));
}

TEST_F(RealPath, OtherNamesOfTheSameFileAreRecognised) {
  put("in/a", "x");
  link("in/b", "a");
  fs::create_hard_link(path("in/a"), path("out/c"));
  EXPECT_TRUE(is_same_file(path("in/b"), path("out/c")));
  EXPECT_TRUE(is_same_file(path("in/../in/a"), path("in/a")));
  EXPECT_FALSE(is_same_file(path("in/a"), path("none")));
}

TEST(LastName, OfFoldersIsTheirName) {
  EXPECT_EQ(last_name("a/b.tmx"), "b.tmx");
  EXPECT_EQ(last_name("a/maps/"), "maps");
  EXPECT_EQ(last_name("/"), "/");
  EXPECT_EQ(last_name(""), "");
}

}  // namespace talus::real_path_test
