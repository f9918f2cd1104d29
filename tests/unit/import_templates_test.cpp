// Objects of Tiled that take from templates.
#include <gmock/gmock.h>

#include <talus/formats/format.h>
#include "folder_test.h"

namespace talus::import_templates_test {

using testing::ElementsAre;

class ImportTemplates : public FolderTest {
 protected:
  void SetUp() override { std::filesystem::create_directories(path("templates")); }
  // A map with these objects, read from a file.
  LoadedLevel read(const std::string& objects, const std::string& tileset = "") const {
    put("map.tmx",
        "<map orientation=\"orthogonal\" width=\"4\" height=\"4\" tilewidth=\"16\" tileheight=\"16\">" +
            tileset + "<layer name=\"l\"><data encoding=\"csv\"></data></layer>\n<objectgroup name=\"o\">" +
            objects + "</objectgroup></map>");
    auto loaded = load_level(path("map.tmx"));
    EXPECT_TRUE(loaded) << to_string(loaded.error(), "map");
    return loaded ? *loaded : LoadedLevel{Level(), nullptr};
  }
};

TEST_F(ImportTemplates, GiveWhatTheObjectDoesNotSay) {
  put("templates/ball.tx",
      "<?xml version=\"1.0\"?>\n<template><object name=\"b\" type=\"ball\" width=\"6\" height=\"8\">"
      "<properties><property name=\"vx\" type=\"float\" value=\"2\"/>"
      "<property name=\"vy\" type=\"float\" value=\"3\"/></properties></object></template>");
  const LoadedLevel loaded = read(
      "<object id=\"1\" template=\"templates/ball.tx\" x=\"3\" y=\"4\"/>"
      "<object id=\"2\" template=\"templates\\ball.tx\" type=\"player\" name=\"p\" x=\"5\" y=\"4\" "
      "height=\"9\"><properties><property name=\"vy\" type=\"float\" value=\"1\"/></properties>"
      "</object>");
  EXPECT_THAT(loaded.dropped, ElementsAre());
  ASSERT_EQ(loaded.level.spawns.size(), 2u);
  const Spawn &first = loaded.level.spawns[0], &second = loaded.level.spawns[1];
  EXPECT_EQ(first.name, "b");
  EXPECT_EQ(first.kind, BodyKind::ball);
  EXPECT_EQ(first.position, (Vec2{3, 4}));
  EXPECT_EQ(first.size, (Vec2{6, 8}));
  EXPECT_EQ(first.velocity, (Vec2{2, 3}));
  EXPECT_EQ(second.name, "p");
  EXPECT_EQ(second.kind, BodyKind::player);
  EXPECT_EQ(second.size, (Vec2{6, 9}));
  EXPECT_EQ(second.velocity, (Vec2{2, 1}));
  EXPECT_THAT(loaded.linked, ElementsAre(path("templates/ball.tx"))) << "read once";
}

TEST_F(ImportTemplates, InJsonGiveTheirOutlines) {
  put("templates/line.tj", R"({"type":"template","object":{"name":"hill","type":"curve",)"
                           R"("polyline":[{"x":0,"y":0},{"x":4,"y":2}]}})");
  const LoadedLevel loaded = read("<object template=\"templates/line.tj\" x=\"8\" y=\"8\"/>");
  ASSERT_EQ(loaded.level.curves.size(), 1u);
  EXPECT_EQ(std::get<Segment>(loaded.level.curves[0].curve.form), (Segment{{8, 8}, {12, 10}}));
}

// The type is that of tile 1 of set.tsx, which has the numbers from 1 in the template and from 11 in the map.
TEST_F(ImportTemplates, NumbersOfTilesAreThoseOfTheirTileset) {
  put("set.tsx",
      "<tileset name=\"set\" tilewidth=\"16\" tileheight=\"16\" tilecount=\"4\" columns=\"4\">"
      "<tile id=\"1\" type=\"player\"/></tileset>");
  put("other.tsx",
      "<tileset name=\"other\" tilewidth=\"16\" tileheight=\"16\" tilecount=\"10\" columns=\"4\">"
      "<tile id=\"1\" type=\"ball\"/></tileset>");
  put("templates/hero.tx",
      "<template><tileset firstgid=\"1\" source=\"../set.tsx\"/>"
      "<object gid=\"2147483650\" width=\"8\" height=\"12\"/></template>");
  const std::string object = "<object template=\"templates/hero.tx\" x=\"10\" y=\"30\"/>";
  const std::string other = "<tileset firstgid=\"1\" source=\"other.tsx\"/>";
  const LoadedLevel loaded = read(object, other + "<tileset firstgid=\"11\" source=\"./set.tsx\"/>");
  ASSERT_EQ(loaded.level.spawns.size(), 1u);
  EXPECT_EQ(loaded.level.spawns[0].kind, BodyKind::player);
  EXPECT_EQ(loaded.level.spawns[0].position, (Vec2{10, 18})) << "an object with a tile stands on its place";
  EXPECT_THAT(loaded.dropped, testing::Contains("the picture of a body"));
  EXPECT_EQ(read(object, other).level.spawns.size(), 0u) << "a map without that tileset";
}

TEST_F(ImportTemplates, ABodyShowsItsTile) {
  const auto read_map = [&](const std::string& gid) {
    put("map.tmx",
        "<map orientation=\"orthogonal\" width=\"2\" height=\"1\" tilewidth=\"16\" tileheight=\"16\">"
        "<tileset firstgid=\"5\" name=\"set\" tilewidth=\"16\" tileheight=\"16\" tilecount=\"4\" "
        "columns=\"4\"/><layer name=\"l\" width=\"2\" height=\"1\"><data encoding=\"csv\">5,0</data>"
        "</layer><objectgroup name=\"o\"><object type=\"player\" gid=\"" +
            gid + "\" x=\"4\" y=\"16\" width=\"16\" height=\"16\"/></objectgroup></map>");
    return load_level(path("map.tmx")).value();
  };
  const LoadedLevel shown = read_map("7");
  ASSERT_EQ(shown.level.spawns.size(), 1u);
  const BodyPicture& picture = shown.level.spawns[0].picture;
  const TileNumber ground = shown.level.map.tile_at({0, 0});
  EXPECT_EQ(picture.sheet, SheetId::tiles);
  EXPECT_EQ(picture[BodyAct::stand], (BodyFrames{static_cast<TileNumber>(ground + 2), 1}));
  EXPECT_THAT(shown.dropped, testing::Not(testing::Contains("the picture of a body")));
  const LoadedLevel turned = read_map("2147483655");
  EXPECT_EQ(turned.level.spawns[0].picture, picture) << "it is mirrored by its motion alone";
  EXPECT_THAT(turned.dropped, testing::Contains("the turn of a body's picture"));
  EXPECT_TRUE(read_map("99").level.spawns[0].picture.empty()) << "there is no such tile";
}

TEST_F(ImportTemplates, GiveShapesToTiles) {
  std::filesystem::create_directories(path("sets"));
  put("sets/set.tsx",
      "<tileset name=\"set\" tilewidth=\"16\" tileheight=\"16\" tilecount=\"4\" columns=\"4\"><tile id=\"1\">"
      "<objectgroup><object template=\"box.tx\" x=\"0\" y=\"8\"/></objectgroup></tile></tileset>");
  put("sets/box.tx", "<template><object width=\"16\" height=\"8\"/></template>");
  const LoadedLevel loaded = read("", "<tileset firstgid=\"1\" source=\"sets/set.tsx\"/>");
  EXPECT_EQ(loaded.level.tile_shapes[1].heights, (std::vector<double>{8, 8}));
  EXPECT_EQ(load_level(path("sets/set.tsx"))->level.tile_shapes[1].heights, (std::vector<double>{8, 8}))
      << "a tileset alone";
}

TEST_F(ImportTemplates, ThatCannotBeReadAreReported) {
  put("templates/bad.tx", "<template>\n<object");
  put("templates/map.tx", "<map/>");
  put("templates/large.tx", "<template><object/></template>" + std::string(1 << 20, ' '));
  std::filesystem::create_symlink("/dev/zero", path("templates/endless.tx"));
  const auto dropped = [&](const std::string& name) {
    const LoadedLevel loaded = read("<object type=\"ball\" x=\"1\" y=\"1\" template=\"" + name + "\"/>");
    EXPECT_EQ(loaded.level.spawns.size(), 1u) << "the object keeps what it says itself";
    return loaded.dropped.empty() ? "" : loaded.dropped.front();
  };
  const std::string of = "the template of an object, file ";
  EXPECT_EQ(dropped("none.tx"), of + "none.tx: cannot be opened: No such file or directory");
  EXPECT_EQ(dropped("/etc/passwd"), of + "/etc/passwd: must be relative to the folder of the map");
  EXPECT_EQ(dropped("templates/bad.tx"), of + "templates/bad.tx, line 2: this is not valid XML");
  EXPECT_EQ(dropped("templates/map.tx"), of + "templates/map.tx: is not a template of Tiled");
  EXPECT_EQ(dropped("templates"), of + "templates: is not a file");
  EXPECT_EQ(dropped("templates/endless.tx"),
            of + "templates/endless.tx: lies outside of the folder of the map, and was not read");
  EXPECT_THAT(dropped("templates/large.tx"),
              testing::StartsWith(of + "templates/large.tx: is larger than 1 MiB"));
}

TEST_F(ImportTemplates, TakeABoundedAmountOfMemory) {
  std::string properties;
  for (int i = 0; i < 9; ++i)
    properties +=
        "<property name=\"" + std::to_string(i) + "\" value=\"" + std::string(100'000, 'v') + "\"/>";
  put("large.tx", "<template><object><properties>" + properties + "</properties></object></template>");
  std::string objects;
  for (int i = 0; i < 80; ++i) objects += "<object template=\"large.tx\" x=\"1\" y=\"1\"/>\n";
  put("map.tmx",
      "<map orientation=\"orthogonal\" width=\"4\" height=\"4\" tilewidth=\"16\" tileheight=\"16\">"
      "<objectgroup name=\"o\">" +
          objects + "</objectgroup></map>");
  const auto loaded = load_level(path("map.tmx"));
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.error().message,
            "takes too much from templates: all objects may take up to 64 MiB together");
}

TEST_F(ImportTemplates, OfAMapWithoutAFileAreReported) {
  const auto loaded = read_level(
      "<map orientation=\"orthogonal\" width=\"4\" height=\"4\" tilewidth=\"16\" tileheight=\"16\">"
      "<layer name=\"l\"><data/></layer><objectgroup name=\"o\"><object "
      "template=\"a.tx\"/></objectgroup></map>",
      {"tmx"});
  ASSERT_TRUE(loaded);
  EXPECT_THAT(
      loaded->dropped,
      testing::Contains("the template of an object, file a.tx: is beside the map, but the map has no file"));
}

}  // namespace talus::import_templates_test
