// Maps without ground: the chosen layer becomes it.
#include "edit/layer_ground.h"

#include <gtest/gtest.h>

#include "folder_test.h"
#include "map_text.h"
#include "session/session.h"

namespace talus::layer_ground_test {

using Kind = TileShape::Kind;

// Two layers: "ab." chosen, and ".b." in front. Tile 2 is the one that both show.
Level layers_level() {
  Level level = level_of_rows({"ab."});
  TileLayer front{.name = "front"};
  MapCells cells(3);
  cells.set(1, 2);
  front.cells = std::make_shared<const MapCells>(cells);
  level.layers.list.push_back(front);
  return level;
}

TEST(LayerGround, TilesWithoutAShapeBecomeSolid) {
  Level level = layers_level();
  ASSERT_TRUE(lacks_ground(level));
  const Level before = level;
  const Edit edit = make_tiles_ground(level);
  apply_edit(level, edit);
  EXPECT_FALSE(lacks_ground(level));
  EXPECT_EQ(level.tile_shapes[0].kind, Kind::none) << "of empty cells";
  EXPECT_EQ(level.tile_shapes[1].kind, Kind::solid);
  EXPECT_EQ(level.tile_shapes[2].kind, Kind::solid);
  EXPECT_EQ(level.tile_shapes[3].kind, Kind::none) << "the layer does not show it";
  EXPECT_TRUE(level.layers.list[0].is_ground);
  EXPECT_FALSE(level.layers.list[1].is_ground) << "it shows tile 2, too";
  EXPECT_TRUE(make_tiles_ground(level).empty());
}

TEST(LayerGround, WhatStopsBodiesIsGround) {
  Level level = layers_level();
  level.tile_shapes[2] = {.kind = Kind::slope, .heights = {0, 8}};
  EXPECT_FALSE(lacks_ground(level));
  level.layers.list[0].is_ground = level.layers.list[1].is_ground = false;
  EXPECT_TRUE(lacks_ground(level)) << "both layers are scenery";
  level.objects.push_back({.name = "walls", .is_ground = true});
  EXPECT_FALSE(lacks_ground(level));
  EXPECT_FALSE(lacks_ground(Level())) << "nothing is drawn";
}

class MapsWithoutGround : public FolderTest {};

TEST_F(MapsWithoutGround, OfferGroundWhenTheyOpen) {
  const std::string map =
      R"(<map orientation="orthogonal" width="2" height="1" tilewidth="8" tileheight="8">)"
      R"(<tileset firstgid="1" name="t" tilewidth="8" tileheight="8" tilecount="1" columns="1">)"
      R"(<image source="t.png" width="8" height="8"/>)";
  const std::string cells =
      R"(</tileset><layer name="l" width="2" height="1"><data encoding="csv">1,0</data></layer></map>)";
  Session session;
  session.apply(action::OpenFile{put("plain.tmx", map + cells)});
  ASSERT_TRUE(session.message());
  EXPECT_TRUE(session.message()->offers_ground);
  EXPECT_NE(session.message()->text.find("Nothing on this map is ground yet: "), std::string::npos);
  session.apply(action::OpenFile{
      put("solid.tmx", map + R"(<tile id="0"><properties><property name="solid" type="bool" value="true"/>)" +
                           "</properties></tile>" + cells)});
  EXPECT_TRUE(!session.message() || !session.message()->offers_ground);
}

}  // namespace talus::layer_ground_test
