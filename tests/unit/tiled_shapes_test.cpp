// Outlines of Tiled's tiles: those that are shapes, and what replaces the others.
#include "formats/tiled/tiled_shapes.h"

#include <gmock/gmock.h>

#include <talus/formats/format.h>
#include "unit/tiled_files.h"

namespace talus::tiled_shapes_test {

using testing::ElementsAre;
using Kind = TileShape::Kind;
using Side = TileShape::Side;

// A map whose tileset has one tile with an outline, tile 5.
LoadedLevel map_with(const std::string& object, const std::string& properties = "") {
  const auto loaded = read_level(
      R"(<map orientation="orthogonal" width="1" height="1" tilewidth="8" tileheight="8">)"
      R"(<tileset firstgid="1" name="t" tilewidth="8" tileheight="8" tilecount="256" columns="16">)"
      R"(<tile id="5"><properties>)" +
          properties + "</properties><objectgroup>" + object +
          R"(</objectgroup></tile></tileset><layer name="l"><data encoding="csv">6</data></layer></map>)",
      {"tmx"});
  EXPECT_TRUE(loaded) << loaded.error().message;
  return *loaded;
}
std::string polygon(const std::string& points) {
  return R"(<object x="0" y="0"><polygon points=")" + points + R"("/></object>)";
}
// The warnings besides the one about the missing picture.
std::vector<std::string> told(const LoadedLevel& loaded) {
  std::vector<std::string> phrases = loaded.dropped;
  std::erase(phrases, "the picture of the tileset \"t\"");
  return phrases;
}
TileShape shape_of(const std::string& object) {
  const LoadedLevel loaded = map_with(object);
  EXPECT_THAT(told(loaded), ElementsAre()) << object;
  return loaded.level.tile_shapes[5];
}
std::string told_of(const std::string& object) {
  const std::vector<std::string> phrases = told(map_with(object));
  return phrases.empty() ? "" : phrases[0];
}

TEST(TiledShapes, CeilingsAreNotTakenForWholeTiles) {
  const TileShape falling{.kind = Kind::slope, .side = Side::ceiling, .heights = {8, 0}};
  EXPECT_EQ(shape_of(polygon("0,0 8,0 0,8")), falling);
  EXPECT_EQ(shape_of(polygon("0,0 8,0 8,8")),
            (TileShape{.kind = Kind::slope, .side = Side::ceiling, .heights = {0, 8}}));
  EXPECT_EQ(shape_of(polygon("0,0 16,0 0,8")),
            (TileShape{.kind = Kind::slope, .side = Side::ceiling, .tiles = 2, .heights = {8, 0}}));
  EXPECT_EQ(shape_of(polygon("0,8 0,0 8,0")), falling) << "from another corner";
  EXPECT_EQ(shape_of(polygon("0,8 8,0 0,0")), falling) << "the other way round";
  EXPECT_EQ(shape_of(polygon("0,0 4,0 8,0 6,2 4,4 0,8 0,3")), falling) << "with points on its sides";
  EXPECT_EQ(shape_of(R"(<object x="3" y="-2"><polygon points="-3,2 5,2 -3,10"/></object>)"), falling);
  EXPECT_EQ(shape_of(R"(<object x="8" y="8" rotation="180"><polygon points="0,0 8,0 0,8"/></object>)"),
            (TileShape{.kind = Kind::slope, .heights = {0, 8}}))
      << "turned by half, it is a floor";
}

TEST(TiledShapes, FlatPartsAtTheBottomAreIgnored) {
  EXPECT_EQ(shape_of(polygon("4,8 8,0 8,8")), (TileShape{.kind = Kind::profile, .heights = {0, 0, 8}}));
  EXPECT_EQ(shape_of(polygon("2,0 6,0 4,3")),
            (TileShape{.kind = Kind::profile, .side = Side::ceiling, .heights = {0, 0, 3, 0, 0}}));
  EXPECT_EQ(shape_of(polygon("0,8 2,4 4,8 6,4 8,8")),
            (TileShape{.kind = Kind::profile, .heights = {0, 4, 0, 4, 0}}));
}

TEST(TiledShapes, OtherOutlinesAreApproximatedWithAWarning) {
  const LoadedLevel leaning = map_with(polygon("0,2 8,4 0,8"));
  EXPECT_THAT(told(leaning), ElementsAre("the outline of tile 5, which hangs in the air: its upper line is "
                                         "kept, as a one-way floor"));
  EXPECT_EQ(leaning.level.tile_shapes[5],
            (TileShape{.kind = Kind::slope, .one_way = true, .heights = {6, 4}}));

  const LoadedLevel hollow = map_with(polygon("0,8 0,4 8,2 6,6 8,8"));
  EXPECT_THAT(
      told(hollow),
      ElementsAre("the outline of tile 5, which is not a floor or ceiling of a level: the nearest floor "
                  "stands for it, with 6 px\u00b2 of ground more"));
  EXPECT_EQ(hollow.level.tile_shapes[5], (TileShape{.kind = Kind::slope, .heights = {4, 6}}));

  const LoadedLevel wall = map_with(R"(<object x="2" y="0" width="6" height="8"/>)");
  EXPECT_THAT(told(wall),
              ElementsAre("the outline of tile 5, which is not a floor or ceiling of a level: the "
                          "nearest floor stands for it, with 0.5 px² of ground more"));
  const std::vector<double>& heights = wall.level.tile_shapes[5].heights;
  ASSERT_EQ(heights.size(), 65u);
  EXPECT_THAT((std::vector<double>{heights[0], heights[15], heights[16], heights[64]}),
              ElementsAre(0, 0, 8, 8));

  const LoadedLevel island = map_with(R"(<object x="0" y="2" width="8" height="3"/>)");
  EXPECT_THAT(told(island), ElementsAre("the outline of tile 5, which hangs in the air: its upper line is "
                                        "kept, as a one-way floor"));
  EXPECT_EQ(island.level.tile_shapes[5],
            (TileShape{.kind = Kind::slope, .one_way = true, .heights = {6, 6}}));

  EXPECT_EQ(told_of(R"(<object x="-4" y="4" width="12" height="4"/>)"),
            "the outline of tile 5, which is not a floor or ceiling of a level: the nearest floor stands for "
            "it, with 16 px² less");
  EXPECT_EQ(told_of(polygon("0,0.3 0.123,0.2 8,0.1 8,8 0,8")),
            "the outline of tile 5, which is not a floor or ceiling of a level: the nearest floor stands for "
            "it, off by less than 0.1 px²");
  EXPECT_EQ(told_of(R"(<object x="-9" y="0" width="8" height="8"/>)"),
            "the outline of tile 5, of which nothing is in the tile or up and right of it");
  EXPECT_EQ(told_of(R"(<object x="0" y="0" width="8" height="8"><ellipse/></object>)"),
            "a collision shape of tile 5, which is not a box or a polygon");
  EXPECT_EQ(told_of(polygon("0,0 8,0 0,8") + polygon("0,8 8,8 0,7")),
            "that tile 5 has 2 collision shapes: a level's has one");
}

// Millions of corners took many seconds.
TEST(TiledShapes, OutlinesOfThousandsOfCornersAreLeftOut) {
  std::string points;
  for (int i = 0; i < 1024; ++i) points += std::to_string(i / 128.0) + (i % 2 == 0 ? ",2 " : ",4 ");
  EXPECT_EQ(told_of(polygon(points + "8,8")),
            "a collision shape of tile 5 with 1025 corners, of which up to 1024 are looked at");
  EXPECT_THAT(told_of(polygon(points)), testing::StartsWith("the outline of tile 5, "));
}

TEST(TiledShapes, PropertiesGiveTheExactHeightsOfALine) {
  const std::string words = R"(<property name="shape" value="profile"/>)"
                            R"(<property name="shape_heights" value="2 3 4"/>)";
  const LoadedLevel same = map_with(polygon("0,6 8,4 8,8 0,8"), words);
  EXPECT_EQ(same.level.tile_shapes[5], (TileShape{.kind = Kind::profile, .heights = {2, 3, 4}}));
  EXPECT_THAT(told(same), ElementsAre());
  const LoadedLevel other = map_with(polygon("0,6 8,3 8,8 0,8"), words);
  EXPECT_EQ(other.level.tile_shapes[5], (TileShape{.kind = Kind::slope, .heights = {2, 5}}));
  EXPECT_THAT(told(other),
              ElementsAre("the property \"shape\" of a tile, as its outline says otherwise",
                          "the property \"shape_heights\" of a tile, as its outline says otherwise"));
}

TEST(TiledShapes, OneWayLinesOnTheBottomGiveAWarning) {
  const std::string one_way = R"(<property name="shape_one_way" type="bool" value="true"/>)";
  const LoadedLevel half = map_with(polygon("4,8 8,0 8,8"), one_way);
  EXPECT_EQ(half.level.tile_shapes[5],
            (TileShape{.kind = Kind::profile, .one_way = true, .heights = {0, 0, 8}}));
  EXPECT_THAT(told(half), testing::SizeIs(1));
  EXPECT_THAT(told(map_with(polygon("0,8 4,8 8,0 8,8"), one_way)), ElementsAre());
}

}  // namespace talus::tiled_shapes_test
