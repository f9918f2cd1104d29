// Flags and shapes of tiles that are saved into the tilesets of maps of Tiled.
#include <gmock/gmock.h>

#include "folder_test.h"

namespace talus::save_tiled_tiles_test {

using testing::HasSubstr;

std::string with_line_ends(std::string text, const std::string& line_end) {
  std::string result;
  for (const char c : text) result += c == '\n' ? line_end : std::string(1, c);
  return result;
}

// A map whose tileset is in it, or in a file beside it.
std::string map_of(const std::string& tileset, const std::string& head = "version=\"1.8\"") {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<map " + head +
         " orientation=\"orthogonal\" width=\"2\" height=\"2\" tilewidth=\"16\" tileheight=\"16\">\n " +
         tileset +
         "\n <layer id=\"1\" name=\"l\" width=\"2\" height=\"2\">\n  <data "
         "encoding=\"csv\">\n1,2,\n3,4\n</data>\n "
         "</layer>\n</map>\n";
}
const std::string kSource = "<tileset firstgid=\"1\" source=\"t.tsx\"/>";

std::string tileset_of(const std::string& tiles, const std::string& first = "") {
  return "<tileset " + first +
         "name=\"t\" tilewidth=\"16\" tileheight=\"16\" tilecount=\"8\" columns=\"4\">\n <!-- mine -->\n "
         "<image "
         "source=\"t.png\" width=\"64\" height=\"32\"/>" +
         tiles + "\n</tileset>\n";
}

const std::string kForeign = R"(
 <tile id="1" type="x">
  <properties>
   <property name="hard" type="float" value="1.50"/>
  </properties>
  <objectgroup draworder="index" id="2">
   <object id="4" name="spot" x="3" y="4"><point/></object>
   <object id="5" name="top" type="edge" x="0" y="0" width="16" height="4">
    <properties><property name="mine" value="1"/></properties>
   </object>
   <object id="7" x="0" y="12" width="16" height="4"/>
  </objectgroup>
  <animation><frame tileid="1" duration="9"/></animation>
 </tile>
 <tile id="5" probability="0.5"/>)";

TileShape slope(double left, double right) {
  TileShape shape;
  shape.kind = TileShape::Kind::slope;
  shape.heights = {left, right};
  return shape;
}
TileShape triangle() {
  TileShape shape;
  shape.kind = TileShape::Kind::polygon;
  shape.points = {{1, 2.5}, {13, 4}, {7.25, 9.00390625}};
  return shape;
}

class SaveTiledTiles : public FolderTest {
 protected:
  // The tile of a number in cells of the map.
  static TileNumber tile(const Level& level, std::uint32_t cell) {
    const auto& tiles = level.tiled->frame.tiles;
    return static_cast<TileNumber>(std::find(tiles.begin(), tiles.end(), cell) - tiles.begin());
  }
  template <class Edit>
  std::string edit(const std::string& name, Edit change) {
    auto loaded = load_level(path(name));
    if (!loaded) return to_string(loaded.error(), name);
    change(loaded->level);
    const auto saved = save_level(loaded->level, *loaded->format, path(name), loaded->companion);
    if (!saved) return to_string(saved.error(), name);
    const auto again = load_level(path(name));
    if (!again) return to_string(again.error(), name);
    EXPECT_EQ(again->level.tile_shapes, loaded->level.tile_shapes);
    EXPECT_EQ(again->level.sheet(SheetId::tiles).flags, loaded->level.sheet(SheetId::tiles).flags);
    return "";
  }
  void put_both(const std::string& tiles, const std::string& line_end = "\n") {
    put("a.tmx", with_line_ends(map_of(kSource), line_end));
    put("t.tsx", with_line_ends(tileset_of(tiles), line_end));
  }
};

TEST_F(SaveTiledTiles, ConveyorsAreAProperty) {
  put_both(kForeign);
  const auto give = [](double speed) {
    return [speed](Level& level) {
      level.tile_shapes[tile(level, 3)] = {.kind = TileShape::Kind::solid, .conveyor = speed};
    };
  };
  EXPECT_EQ(edit("a.tmx", give(1.25)), "");
  EXPECT_THAT(bytes_of("t.tsx"), HasSubstr(R"(name="shape_conveyor" type="float" value="1.25")"));
  EXPECT_EQ(edit("a.tmx", give(-3)), "");
  EXPECT_THAT(bytes_of("t.tsx"), HasSubstr(R"(value="-3")"));
  EXPECT_EQ(edit("a.tmx", give(0)), "");
  EXPECT_THAT(bytes_of("t.tsx"), testing::Not(HasSubstr("shape_conveyor")));
}

TEST_F(SaveTiledTiles, AnUnchangedTilesetKeepsItsBytes) {
  put_both(kForeign, "\r\n");
  EXPECT_EQ(edit("a.tmx", [](Level&) {}), "");
  EXPECT_EQ(bytes_of("t.tsx"), with_line_ends(tileset_of(kForeign), "\r\n"));
  EXPECT_FALSE(exists("a.tmx.talus.json"));
}

TEST_F(SaveTiledTiles, ANewTileGetsItsElementAtItsPlace) {
  for (const std::string line_end : {"\n", "\r\n"}) {
    put_both(kForeign, line_end);
    EXPECT_EQ(edit("a.tmx",
                   [](Level& level) {
                     level.tile_shapes[tile(level, 4)] = slope(0, 16);
                     level.tile_shapes[tile(level, 1)] = triangle();
                   }),
              "");
    const std::string before = R"(
 <tile id="0">
  <objectgroup draworder="index">
   <object id="1" x="1" y="2.5">
    <polygon points="0,0 12,1.5 6.25,6.50390625"/>
   </object>
  </objectgroup>
 </tile>)";
    const std::string between = R"(
 <tile id="3">
  <objectgroup draworder="index">
   <object id="1" x="0" y="16">
    <polygon points="0,0 16,-16 16,0"/>
   </object>
  </objectgroup>
 </tile>)";
    std::string wanted = kForeign;
    wanted.insert(wanted.find("\n <tile id=\"5\""), between);
    EXPECT_EQ(bytes_of("t.tsx"), with_line_ends(tileset_of(before + wanted), line_end));
    EXPECT_EQ(bytes_of("a.tmx"), with_line_ends(map_of(kSource), line_end));
    EXPECT_FALSE(exists("a.tmx.talus.json"));
  }
}

// Without a word of it, the outline of a slope or of a full tile is one.
TEST_F(SaveTiledTiles, APolygonLikeASlopeStaysOne) {
  put_both(kForeign);
  TileShape wedge = triangle(), box = triangle(), group;
  wedge.points = {{0, 16}, {16, 0}, {16, 16}};
  box.points = {{0, 0}, {16, 0}, {16, 16}, {0, 16}};
  group.kind = TileShape::Kind::group;
  group.parts = {wedge, triangle()};
  EXPECT_EQ(edit("a.tmx",
                 [&](Level& level) {
                   level.tile_shapes[tile(level, 1)] = wedge;
                   level.tile_shapes[tile(level, 3)] = group;
                   level.tile_shapes[tile(level, 4)] = box;
                 }),
            "");
  EXPECT_FALSE(exists("a.tmx.talus.json"));
  EXPECT_THAT(bytes_of("t.tsx"), HasSubstr("<property name=\"shape\" value=\"polygon\"/>"));
  EXPECT_EQ(edit("a.tmx",
                 [&](Level& level) {
                   level.tile_shapes[tile(level, 1)] = slope(0, 16);
                   level.tile_shapes[tile(level, 3)] = {};
                   level.tile_shapes[tile(level, 4)] = triangle();
                 }),
            "");
  EXPECT_FALSE(exists("a.tmx.talus.json"));
  EXPECT_THAT(bytes_of("t.tsx"), testing::Not(HasSubstr("\"polygon\"")));
}

TEST_F(SaveTiledTiles, OnlyTheChangedObjectIsReplaced) {
  put_both(kForeign);
  EXPECT_EQ(edit("a.tmx",
                 [](Level& level) {
                   TileShape& shape = level.tile_shapes[tile(level, 2)];
                   ASSERT_EQ(shape.parts.size(), 2U);
                   shape.parts[0] = triangle();
                   shape.parts[0].one_way = true;
                 }),
            "");
  std::string wanted = kForeign;
  const std::string old = R"(<object id="5" name="top" type="edge" x="0" y="0" width="16" height="4">
    <properties><property name="mine" value="1"/></properties>
   </object>)";
  wanted.replace(wanted.find(old), old.size(), R"(<object id="5" name="top" type="edge" x="1" y="2.5">
    <properties><property name="mine" value="1"/><property name="one_way" type="bool" value="true"/></properties>
    <polygon points="0,0 12,1.5 6.25,6.50390625"/>
   </object>)");
  EXPECT_EQ(bytes_of("t.tsx"), tileset_of(wanted));
}

TEST_F(SaveTiledTiles, ARemovedShapeTakesOnlyItsObjects) {
  put_both(kForeign);
  EXPECT_EQ(edit("a.tmx", [](Level& level) { level.tile_shapes[tile(level, 2)] = {}; }), "");
  const std::string text = bytes_of("t.tsx");
  EXPECT_THAT(
      text, HasSubstr("<object id=\"4\" name=\"spot\" x=\"3\" y=\"4\"><point/></object>\n  </objectgroup>"));
  EXPECT_THAT(text, HasSubstr("value=\"1.50\"/>"));
  EXPECT_THAT(text, HasSubstr("<frame tileid"));
  EXPECT_FALSE(exists("a.tmx.talus.json"));
}

TEST_F(SaveTiledTiles, AddedAndRemovedFlagsGiveTheSameBytesAgain) {
  put_both(kForeign);
  EXPECT_EQ(edit("a.tmx",
                 [](Level& level) {
                   level.flag_names[4] = "ice";
                   level.sheet(SheetId::tiles).flags[tile(level, 2)] = 1 << 4;
                   level.sheet(SheetId::tiles).flags[tile(level, 3)] = 1;
                 }),
            "");
  std::string wanted = kForeign;
  const std::string own = "value=\"1.50\"/>";
  wanted.insert(wanted.find(own) + own.size(), "\n   <property name=\"ice\" type=\"bool\" value=\"true\"/>");
  wanted.insert(wanted.find("\n <tile id=\"5\""), R"(
 <tile id="2">
  <properties>
   <property name="solid" type="bool" value="true"/>
  </properties>
 </tile>)");
  EXPECT_EQ(bytes_of("t.tsx"), tileset_of(wanted));
  EXPECT_FALSE(exists("a.tmx.talus.json"));
  EXPECT_EQ(edit("a.tmx",
                 [](Level& level) {
                   for (const std::uint32_t cell : {2U, 3U})
                     level.sheet(SheetId::tiles).flags[tile(level, cell)] = 0;
                 }),
            "");
  EXPECT_EQ(bytes_of("t.tsx"), tileset_of(kForeign));
}

TEST_F(SaveTiledTiles, ANumberOfFlagsIsKeptUpToDate) {
  put_both(
      "\n <tile id=\"1\"><properties><property name=\"flags\" type=\"int\" "
      "value=\"1\"/></properties></tile>");
  EXPECT_EQ(edit("a.tmx", [](Level& level) { level.sheet(SheetId::tiles).flags[tile(level, 2)] = 6; }), "");
  EXPECT_EQ(bytes_of("t.tsx"),
            tileset_of("\n <tile id=\"1\"><properties><property name=\"flags\" type=\"int\" "
                       "value=\"6\"/></properties></tile>"));
}

TEST_F(SaveTiledTiles, ATilesetInTheMapIsWrittenThere) {
  const std::string first = "firstgid=\"1\" ";
  put("a.tmx", map_of(tileset_of(kForeign, first)));
  EXPECT_EQ(edit("a.tmx",
                 [](Level& level) {
                   level.map.set({0, 0}, tile(level, 3));
                   level.sheet(SheetId::tiles).flags[tile(level, 3)] = 1;
                 }),
            "");
  const std::string text = bytes_of("a.tmx");
  EXPECT_THAT(text, HasSubstr("\n3,2,\n3,4\n"));
  EXPECT_THAT(text, HasSubstr("\n <tile id=\"2\">\n  <properties>\n   <property name=\"solid\""));
  EXPECT_FALSE(exists("a.tmx.talus.json"));
}

TEST_F(SaveTiledTiles, UndoneEditsGiveTheFirstBytes) {
  put_both(kForeign);
  auto loaded = load_level(path("a.tmx"));
  ASSERT_TRUE(loaded);
  const Level before = loaded->level;
  loaded->level.tile_shapes[tile(before, 4)] = slope(4, 8);
  const auto first = save_level(loaded->level, *loaded->format, path("a.tmx"), loaded->companion);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->others.size(), 1U);
  EXPECT_THAT(bytes_of("t.tsx"), HasSubstr("<tile id=\"3\">"));
  const auto second = save_level(before, *loaded->format, path("a.tmx"), first->companion);
  ASSERT_TRUE(second);
  EXPECT_EQ(bytes_of("t.tsx"), tileset_of(kForeign));
  const auto third = save_level(before, *loaded->format, path("a.tmx"), second->companion);
  ASSERT_TRUE(third);
  EXPECT_TRUE(third->others.empty());
}

// Two entries of a map with the same file: the second tile cannot differ from the first.
TEST_F(SaveTiledTiles, ATilesetOfTwoEntriesIsWrittenOnce) {
  put("t.tsx", tileset_of(kForeign));
  put("a.tmx", with_line_ends(map_of(kSource + "\n <tileset firstgid=\"9\" source=\"./t.tsx\"/>"), "\n"));
  std::string text = bytes_of("a.tmx");
  text.replace(text.find("3,4"), 3, "3,12");
  put("a.tmx", text);
  EXPECT_EQ(edit("a.tmx", [](Level& level) { level.tile_shapes[tile(level, 12)] = slope(2, 6); }), "");
  EXPECT_THAT(bytes_of("t.tsx"), HasSubstr("<tile id=\"3\">"));
  EXPECT_TRUE(exists("a.tmx.talus.json"));  // that tile 4 has none
}

TEST_F(SaveTiledTiles, AProfileKeepsItsHeights) {
  put_both("");
  EXPECT_EQ(edit("a.tmx",
                 [](Level& level) {
                   TileShape shape = slope(2, 6);
                   shape.kind = TileShape::Kind::profile;
                   shape.heights = {2, 4, 6};
                   level.tile_shapes[tile(level, 4)] = shape;
                 }),
            "");
  EXPECT_THAT(bytes_of("t.tsx"), HasSubstr("<property name=\"shape_heights\" value=\"2 4 6\"/>"));
  EXPECT_FALSE(exists("a.tmx.talus.json"));
}

TEST_F(SaveTiledTiles, AOneWayCeilingStaysACeiling) {
  put_both("");
  EXPECT_EQ(edit("a.tmx",
                 [](Level& level) {
                   TileShape shape = slope(2, 6);
                   shape.side = TileShape::Side::ceiling;
                   shape.one_way = true;
                   level.tile_shapes[tile(level, 4)] = shape;
                 }),
            "");
  EXPECT_THAT(bytes_of("t.tsx"), HasSubstr("<property name=\"shape_side\" value=\"ceiling\"/>"));
  EXPECT_FALSE(exists("a.tmx.talus.json"));
}

const std::string kJsonTiles = R"(
  { "id":1, "type":"x",
    "objectgroup": { "objects":[
      { "id":4, "point":true, "x":3, "y":4, "width":0, "height":0 },
      { "id":5, "name":"top", "x":0, "y":0, "width":16, "height":4, "rotation":0 } ] }
  },
  { "id":5, "probability":0.50 })";
std::string json_tileset(const std::string& tiles) {
  return R"({ "columns":4, "name":"t", "tilecount":8, "tilewidth":16, "tileheight":16, "type":"tileset", "own": 1.0, "tiles":[)" +
         tiles + "]}\n";
}
const std::string kJsonMap =
    R"({"orientation":"orthogonal","width":2,"height":2,"tilewidth":16,"tileheight":16,"version":"1.9",)"
    R"("layers":[{"type":"tilelayer","name":"l","width":2,"height":2,"data":[1,2,3,4]}],)"
    R"("tilesets":[{"firstgid":1,"source":"t.tsj"}],"type":"map"})";

TEST_F(SaveTiledTiles, JsonKeepsItsTextBesideTheTiles) {
  put("a.tmj", kJsonMap);
  put("t.tsj", json_tileset(kJsonTiles));
  EXPECT_EQ(edit("a.tmj", [](Level&) {}), "");
  EXPECT_EQ(bytes_of("t.tsj"), json_tileset(kJsonTiles));
  EXPECT_EQ(edit("a.tmj",
                 [](Level& level) {
                   level.tile_shapes[tile(level, 2)] = triangle();
                   level.tile_shapes[tile(level, 4)] = slope(0, 16);
                   level.sheet(SheetId::tiles).flags[tile(level, 4)] = 2;
                 }),
            "");
  std::string wanted = kJsonTiles;
  const std::string old = R"("x":0, "y":0, "width":16, "height":4, "rotation":0 })";
  wanted.replace(
      wanted.find(old), old.size(),
      R"("x":1, "y":2.5, "width":0, "height":0, "rotation":0, "polygon":[{"x":0, "y":0}, {"x":12, "y":1.5}, {"x":6.25, "y":6.50390625}] })");
  wanted.insert(
      wanted.find("{ \"id\":5, \"prob"),
      R"({"id":3, "objectgroup":{"draworder":"index", "name":"", "objects":[{"height":0, "id":1, "name":"", "polygon":[{"x":0, "y":0}, {"x":16, "y":-16}, {"x":16, "y":0}], "rotation":0, "class":"", "visible":true, "width":0, "x":0, "y":16}], "opacity":1, "type":"objectgroup", "visible":true, "x":0, "y":0}, "properties":[{"name":"ball", "type":"bool", "value":true}]},
  )");
  EXPECT_THAT(bytes_of("t.tsj"), HasSubstr(R"("polygon":[{"x":0, "y":0}, {"x":12, "y":1.5})"));
  EXPECT_THAT(bytes_of("t.tsj"),
              HasSubstr(R"("properties":[{"name":"ball", "type":"bool", "value":true}]},)"));
  EXPECT_THAT(bytes_of("t.tsj"), HasSubstr(R"({ "id":5, "probability":0.50 }])"));
  EXPECT_FALSE(exists("a.tmj.talus.json"));
  EXPECT_EQ(edit("a.tmj", [](Level& level) { level.tile_shapes[tile(level, 2)] = {}; }), "");
  EXPECT_THAT(bytes_of("t.tsj"),
              HasSubstr(R"({ "id":4, "point":true, "x":3, "y":4, "width":0, "height":0 } ] })"));
}

TEST_F(SaveTiledTiles, ATilesetAloneIsSavedTheSameWay) {
  put("t.tsx", tileset_of(kForeign));
  EXPECT_EQ(edit("t.tsx", [](Level&) {}), "");
  EXPECT_EQ(bytes_of("t.tsx"), tileset_of(kForeign));
  EXPECT_EQ(edit("t.tsx", [](Level& level) { level.sheet(SheetId::tiles).flags[tile(level, 3)] = 1; }), "");
  std::string wanted = kForeign;
  wanted.insert(wanted.find("\n <tile id=\"5\""),
                "\n <tile id=\"2\">\n  <properties>\n   <property name=\"solid\" type=\"bool\" "
                "value=\"true\"/>\n  </properties>\n </tile>");
  EXPECT_EQ(bytes_of("t.tsx"), tileset_of(wanted));
  EXPECT_FALSE(exists("t.tsx.talus.json"));
}

TEST_F(SaveTiledTiles, ATilesetAloneShowsEachTileOnce) {
  put("t.tsx", tileset_of(kForeign));
  auto loaded = load_level(path("t.tsx"));
  ASSERT_TRUE(loaded);
  const TileMap& map = loaded->level.map;
  EXPECT_EQ(map.width(), 4 + 6);
  EXPECT_EQ(map.height(), 2 + 6);
  for (std::uint32_t id = 0; id < 8; ++id) {
    const Cell cell{3 + static_cast<int>(id) % 4, 3 + static_cast<int>(id) / 4};
    EXPECT_EQ(map.tile_at(cell), tile(loaded->level, id + 1)) << id;
  }
  EXPECT_EQ(std::count(map.cells().tiles().begin(), map.cells().tiles().end(), 0), 80 - 8);
  loaded->level.map.set({0, 0}, tile(loaded->level, 6));
  loaded->level.spawns.push_back({.name = "", .position = {8, 8}, .velocity = {}, .extra = ""});
  const auto saved = save_level(loaded->level, *loaded->format, loaded->path, loaded->companion);
  ASSERT_TRUE(saved);
  EXPECT_EQ(bytes_of("t.tsx"), tileset_of(kForeign)) << "what was tried is kept beside it";
  EXPECT_TRUE(load_level(path("t.tsx"))->level == loaded->level);
}

TEST_F(SaveTiledTiles, ATilesetAloneWithGapsShowsWhatIsThere) {
  put("t.tsx", R"(<tileset name="t" tilewidth="16" tileheight="16" tilecount="2" columns="0">)"
               R"(<tile id="1"><image source="a.png" width="16" height="16"/></tile>)"
               R"(<tile id="19"><image source="b.png" width="16" height="16"/></tile></tileset>)");
  const auto loaded = load_level(path("t.tsx"));
  ASSERT_TRUE(loaded);
  EXPECT_EQ(std::count(loaded->level.map.cells().tiles().begin(), loaded->level.map.cells().tiles().end(), 0),
            loaded->level.map.width() * loaded->level.map.height() - 2);
  put("wide.tsx", R"(<tileset name="t" tilewidth="16" tileheight="16" tilecount="70000" columns="70000"/>)");
  EXPECT_FALSE(load_level(path("wide.tsx"))) << "too many tiles";
}

TEST_F(SaveTiledTiles, ACollectionTakesShapesInThePlaceOfItsTiles) {
  put("t.tsx",
      "<tileset name=\"t\" tilewidth=\"32\" tileheight=\"24\" tilecount=\"1\" columns=\"0\">\n <tile "
      "id=\"3\">\n  "
      "<image source=\"a.png\" width=\"32\" height=\"24\"/>\n </tile>\n</tileset>\n");
  put("a.tmx", map_of(kSource));
  EXPECT_EQ(edit("a.tmx",
                 [](Level& level) { level.tile_shapes[tile(level, 4)] = {.kind = TileShape::Kind::solid}; }),
            "");
  EXPECT_THAT(bytes_of("t.tsx"),
              HasSubstr("height=\"24\"/>\n  <objectgroup draworder=\"index\">\n   <object id=\"1\" "
                        "x=\"0\" y=\"8\" width=\"16\" height=\"16\"/>\n  </objectgroup>"));
}

}  // namespace talus::save_tiled_tiles_test
