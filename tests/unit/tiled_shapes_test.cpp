// Outlines of Tiled's tiles: those that are shapes, and what replaces the others.
#include "formats/tiled/tiled_shapes.h"

#include <gmock/gmock.h>

#include <talus/formats/format.h>
#include "formats/tiled/tiled_objects.h"
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

TileShape polygon_shape(std::vector<Vec2> points, bool one_way = false) {
  TileShape shape;
  shape.kind = Kind::polygon;
  shape.one_way = one_way;
  shape.points = std::move(points);
  return shape;
}

TEST(TiledShapes, OtherOutlinesArePolygonsWithoutAWarning) {
  const auto expect = [](const std::string& object, const TileShape& shape) {
    const LoadedLevel loaded = map_with(object);
    EXPECT_EQ(loaded.level.tile_shapes[5], shape) << object;
    EXPECT_THAT(told(loaded), ElementsAre()) << object;
  };
  expect(polygon("0,2 8,4 0,8"), polygon_shape({{0, 2}, {8, 4}, {0, 8}}));
  expect(polygon("0,8 0,4 8,2 6,6 8,8"), polygon_shape({{0, 8}, {0, 4}, {8, 2}, {6, 6}, {8, 8}}));
  expect(R"(<object x="2" y="0" width="6" height="8"/>)", polygon_shape({{2, 0}, {8, 0}, {8, 8}, {2, 8}}));
  expect(R"(<object x="0" y="2" width="8" height="3"/>)", polygon_shape({{0, 2}, {8, 2}, {8, 5}, {0, 5}}));
  expect(R"(<object x="-9" y="0" width="8" height="8"/>)",
         polygon_shape({{-9, 0}, {-1, 0}, {-1, 8}, {-9, 8}}));
  expect(R"(<object x="4" y="0" width="2" height="4" rotation="90"/>)",
         polygon_shape({{4, 0}, {4, 2}, {0, 2}, {0, 0}}));
  expect(polygon("0,2 0.001,2 8,4 0,8 0,2"), polygon_shape({{0, 2}, {8, 4}, {0, 8}}));
}

TEST(TiledShapes, APropertyMakesAConveyor) {
  const std::string full = R"(<object width="8" height="8"/>)";
  const auto with = [&](const std::string& value) {
    return map_with(full, R"(<property name="shape_conveyor" )" + value + "/>");
  };
  const TileShape conveyor{.kind = Kind::solid, .conveyor = 1.5};
  EXPECT_EQ(with(R"(type="float" value="1.5")").level.tile_shapes[5], conveyor);
  EXPECT_THAT(told(with(R"(type="float" value="1.5")")), ElementsAre());
  EXPECT_EQ(with(R"(type="int" value="-2")").level.tile_shapes[5].conveyor, -2);
  EXPECT_THAT(told(with(R"(type="float" value="99")")),
              ElementsAre("the speed of a conveyor, which is no number of at most 64 px a frame"));
}

// A map whose tile 0 is a conveyor without an outline, in a layer of this name.
LoadedLevel map_with_bare_conveyor(const std::string& layer) {
  const auto loaded = read_level(
      R"(<map orientation="orthogonal" width="2" height="1" tilewidth="8" tileheight="8">)"
      R"(<tileset firstgid="1" name="t" tilewidth="8" tileheight="8" tilecount="4" columns="4">)"
      R"(<tile id="0"><properties><property name="shape_conveyor" type="float" value="1.5"/></properties>)"
      R"(</tile></tileset><layer name=")" +
          layer + R"(" width="2" height="1"><data encoding="csv">1,2147483649</data></layer></map>)",
      {"tmx"});
  EXPECT_TRUE(loaded) << loaded.error().message;
  return *loaded;
}

TEST(TiledShapes, AConveyorWithoutAnOutlineMayBeSolid) {
  const LoadedLevel loaded = map_with_bare_conveyor("ground");
  const Level& level = loaded.level;
  EXPECT_EQ(shape_of_cell(level, level.map.cells()[0]), (TileShape{.kind = Kind::solid, .conveyor = 1.5}));
  EXPECT_EQ(shape_of_cell(level, level.map.cells()[1]), (TileShape{.kind = Kind::solid, .conveyor = -1.5}));
  EXPECT_THAT(told(loaded), ElementsAre());
}

TEST(TiledShapes, AConveyorThatIsNoGroundIsTold) {
  EXPECT_THAT(told(map_with_bare_conveyor("l")),
              ElementsAre("the speed of a conveyor on a tile that is no ground"));
}

TEST(TiledShapes, AnEllipseIsAPolygon) {
  const LoadedLevel loaded = map_with(R"(<object x="1" y="2" width="6" height="4"><ellipse/></object>)");
  const TileShape& shape = loaded.level.tile_shapes[5];
  EXPECT_EQ(shape.kind, Kind::polygon);
  EXPECT_GE(shape.points.size(), 8u);
  EXPECT_EQ(shape.points[0], (Vec2{7, 4}));
  EXPECT_THAT(told(loaded), ElementsAre());
}

TEST(TiledShapes, SeveralOutlinesAreAGroup) {
  const std::string one_way =
      R"(<properties><property name="one_way" type="bool" value="true"/></properties>)";
  const LoadedLevel loaded =
      map_with(polygon("0,0 8,0 0,8") + R"(<object x="2" y="3" width="4" height="2">)" + one_way +
               "</object>" + R"(<object x="0" y="0" width="8" height="8"/>)");
  const TileShape& group = loaded.level.tile_shapes[5];
  ASSERT_EQ(group.kind, Kind::group);
  EXPECT_EQ(group.parts,
            (std::vector<TileShape>{{.kind = Kind::slope, .side = Side::ceiling, .heights = {8, 0}},
                                    polygon_shape({{2, 3}, {6, 3}, {6, 5}, {2, 5}}, true),
                                    {.kind = Kind::solid}}));
  EXPECT_THAT(told(loaded), ElementsAre());
}

// It was a one-way ceiling, which let all bodies fall through.
TEST(TiledShapes, OneWayPlanksAtTheTopAreFloors) {
  const auto plank = [](const std::string& tile) {
    return map_with(R"(<object width="8" height="2"><properties><property name="one_way" type="bool")"
                    R"( value="true"/></properties></object>)",
                    tile)
        .level.tile_shapes[5];
  };
  EXPECT_EQ(plank(""), polygon_shape({{0, 0}, {8, 0}, {8, 2}, {0, 2}}, true));
  const TileShape ceiling = plank(R"(<property name="shape_side" value="ceiling"/>)");
  EXPECT_EQ(ceiling.side, Side::ceiling) << "a level of Talus says so";
  EXPECT_TRUE(ceiling.one_way);
}

TEST(TiledShapes, OutlinesOfPolygonsAreReadAsWritten) {
  TileShape group;
  group.kind = Kind::group;
  group.parts = {polygon_shape({{-3.5, 2}, {12, 4.25}, {0, 8}}, true), {.kind = Kind::solid}};
  const std::vector<TiledObject> objects = tiled_objects(group, {});
  ASSERT_EQ(objects.size(), 2u);
  EXPECT_EQ(polygon_of(outline_of(objects[0]), true, {}), group.parts[0]);
  EXPECT_EQ(objects[0].properties, (TiledProperties{{"one_way", true}}));
  EXPECT_EQ(tile_shape_of(outline_of(objects[1]), false, {}), group.parts[1]);
  EXPECT_EQ(tiled_properties(group), (TiledProperties{{"shape", std::string("group")}}));
}

TEST(TiledShapes, OutlinesThatCrossAreApproximated) {
  EXPECT_THAT(told_of(polygon("0,0 8,8 8,0 0,8")), testing::StartsWith("the outline of tile 5, which "));
  EXPECT_EQ(told_of(R"(<object x="-99" y="0" width="8" height="8"/>)"),
            "the outline of tile 5, of which nothing is in the tile or up and right of it");
  EXPECT_EQ(told_of(R"(<object x="0" y="0"><polyline points="0,0 8,8"/></object>)"),
            "a collision shape of tile 5, which is not a box, an ellipse or a polygon");
  std::string many;
  for (int i = 0; i < 65; ++i) many += R"(<object x="0" y="0" width="8" height="8"/>)";
  EXPECT_EQ(told_of(many),
            "all but the first of the collision shapes of tile 5, as their union has more than 64 parts");
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

// A slope would stop bodies on the bottom beside it, too.
TEST(TiledShapes, OneWayLinesBesideTheBottomArePolygons) {
  const std::string one_way = R"(<property name="shape_one_way" type="bool" value="true"/>)";
  const LoadedLevel half = map_with(polygon("4,8 8,0 8,8"), one_way);
  EXPECT_EQ(half.level.tile_shapes[5], polygon_shape({{4, 8}, {8, 0}, {8, 8}}, true));
  EXPECT_THAT(told(half), ElementsAre());
  EXPECT_THAT(told(map_with(polygon("0,8 4,8 8,0 8,8"), one_way)), ElementsAre());
}

}  // namespace talus::tiled_shapes_test
