// Maps of Tiled in XML: the text of a small one, and that XML and JSON say the same.
#include <gmock/gmock.h>

#include "tiled_files.h"

namespace talus::export_tmx_test {

Level small_level() {
  Level level;
  level.map = TileMap(2, 2);
  level.map.cells().tiles() = {0, 2, 1, 1};
  level.sheet(SheetId::tiles).flags[1] = 1;
  level.tile_shapes[2] = {.kind = TileShape::Kind::slope, .one_way = true, .heights = {0, 7.5}};
  level.spawns.push_back({.name = "<&\"\x01", .position = {0.5, 1}, .velocity = {1, 0}, .extra = ""});
  return level;
}

std::string exported(const Level& level) {
  std::string text = tiled_export_of(level, "tmx", "cave.tmx").files[0].bytes;
  const auto from = text.find("value=\"{"), to = text.find("\" />", from);  // the property talus_level
  return text.replace(from, to - from, "value=\"...");
}

TEST(ExportTmx, HoldsTheTextThatTiledReads) {
  EXPECT_EQ(exported(small_level()), R"(<?xml version="1.0" encoding="UTF-8"?>
<map version="1.10" tiledversion="1.10.2" orientation="orthogonal" renderorder="right-down" width="2" height="2" tilewidth="8" tileheight="8" infinite="0" backgroundcolor="#1a1c2c" nextlayerid="4" nextobjectid="2">
 <properties>
  <property name="talus_level" value="..." />
 </properties>
 <tileset firstgid="1" name="tiles" tilewidth="8" tileheight="8" tilecount="256" columns="16">
  <image source="cave-tiles.png" width="128" height="128" />
  <tile id="1">
   <properties>
    <property name="flags" type="int" value="1" />
    <property name="solid" type="bool" value="true" />
    <property name="shape" value="solid" />
   </properties>
   <objectgroup draworder="index">
    <object id="1" x="0" y="0" width="8" height="8" />
   </objectgroup>
  </tile>
  <tile id="2">
   <properties>
    <property name="shape" value="slope" />
    <property name="shape_heights" value="0 7.5" />
    <property name="shape_one_way" type="bool" value="true" />
   </properties>
   <objectgroup draworder="index">
    <object id="1" x="0" y="0">
     <properties>
      <property name="one_way" type="bool" value="true" />
     </properties>
     <polygon points="0,8 8,0.5 8,8" />
    </object>
   </objectgroup>
  </tile>
 </tileset>
 <layer id="1" name="map" width="2" height="2">
  <data encoding="csv">
0,3,
2,2
</data>
 </layer>
 <objectgroup id="2" name="spawns" draworder="index">
  <object id="1" name="&lt;&amp;&quot; " type="ball" x="0.5" y="1" width="8" height="8">
   <properties>
    <property name="vx" type="float" value="1" />
    <property name="vy" type="float" value="0" />
    <property name="foot" value="box" />
   </properties>
  </object>
 </objectgroup>
 <objectgroup id="3" name="curves" draworder="index" />
</map>
)");
}

TEST(ExportTmx, SaysInHowManyTextsItReplacesCharacters) {
  Level level = small_level();
  const std::string has_not = "control characters, which XML does not have, in ";
  EXPECT_EQ(tiled_export_of(level, "tmx", "cave.tmx").dropped, (std::vector{has_not + "1 text"}));
  level.flag_names[0] = "\x1b[31mred";
  EXPECT_EQ(tiled_export_of(level, "tmx", "cave.tmx").dropped, (std::vector{has_not + "2 texts"}));
  EXPECT_TRUE(tiled_export_of(level, "tmj", "cave.tmj").dropped.empty());
  level.flag_names[0] = "a\nb";
  level.spawns[0].name = "ball";
  EXPECT_TRUE(tiled_export_of(level, "tmx", "cave.tmx").dropped.empty());
}

// Names that are equal in XML, or that XML cannot hold, must not become flags of their own.
TEST(ExportTmx, FlagsAndNamesThatXmlCannotHoldSurvive) {
  Level level = small_level();
  level.flag_names[0] = "s\x01";
  level.flag_names[1] = "s\x02";
  level.flag_names[2] = "\xef\xbf\xbeup";
  level.flag_names[3] = "s ";
  for (const TileNumber tile : {TileNumber{1}, TileNumber{2}})
    level.sheet(SheetId::tiles).flags[tile] = tile == 1 ? 0b0101 : 0b1010;
  level.curves.push_back({"\x1b", {Segment{{1, 2}, {9, 8}}, Curve::Faces::up}, ""});
  for (const std::string to : {"tmx", "tmj"}) {
    const auto again = read_level(tiled_export_of(level, to, "cave." + to).files[0].bytes, {to});
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again->level.flag_names, level.flag_names) << to;
    EXPECT_EQ(again->level.sheet(SheetId::tiles).flags, level.sheet(SheetId::tiles).flags) << to;
    EXPECT_EQ(again->level.spawns, level.spawns) << to;
    EXPECT_EQ(again->level.curves, level.curves) << to;
  }
}

TEST(ExportTmx, LargeMapsArePackedAndReadAgain) {
  Level level;
  level.map = TileMap(2048, 1024);
  for (std::size_t i = 0; i < level.map.cells().size(); ++i)
    level.map.cells().tiles()[i] = static_cast<TileNumber>(i % 7 * (i % 3));
  for (const std::string to : {"tmx", "tmj"}) {
    const std::string text = tiled_export_of(level, to, "cave." + to).files[0].bytes;
    EXPECT_LT(text.size(), 1'000'000u) << to;
    const auto again = read_level(text, {to});
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again->level.map, level.map) << to;
  }
}

TEST(ExportTmx, SaysTheSameAsTheJson) {
  Level level = level_for_tiled();
  const std::string json = tiled_export_of(level, "tmj", "cave.tmj").files[0].bytes;
  const std::string xml = tiled_export_of(level, "tmx", "cave.tmx").files[0].bytes;
  const auto from_json = read_level(json, {"tmj"}), from_xml = read_level(xml, {"tmx"});
  ASSERT_TRUE(from_json && from_xml);
  EXPECT_TRUE(from_json->level == from_xml->level);
  EXPECT_EQ(from_json->dropped, from_xml->dropped);
  EXPECT_THAT(from_xml->dropped, testing::ElementsAre("the picture of the tileset \"tiles\""));
  level.sheet(SheetId::tiles).images.assign(kCartTiles, {});
  EXPECT_TRUE(from_xml->level == level) << "all but the pixels, which are in the picture";
}

}  // namespace talus::export_tmx_test
