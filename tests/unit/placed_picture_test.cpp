// Where pictures are on the map.
#include <talus/level/placed_picture.h>

#include <gmock/gmock.h>

namespace talus::placed_picture_test {

using testing::ElementsAre;

PicturePart part_of(int width, int height) {
  auto picture = std::make_shared<SheetPicture>();
  picture->width = width;
  picture->height = height;
  picture->rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  PicturePart part{std::move(picture)};
  part.width = width;
  part.height = height;
  return part;
}

TEST(PlacedPicture, ALargeTileStandsOnItsCell) {
  const PlacedPicture shown = placed(LargeTile{part_of(16, 32), {16, 32}}, {1, 2}, {8, 8});
  EXPECT_EQ(shown.corner, (Vec2{8, -8}));
  EXPECT_EQ(shown.right, (Vec2{16, 0}));
  EXPECT_EQ(shown.down, (Vec2{0, 32}));
}

TEST(PlacedPicture, ATurnedTileKeepsItsBottomLeft) {
  LargeTile tile{part_of(16, 32), {16, 32}};
  tile.part.swaps_axes = true;
  PlacedPicture shown = placed(tile, {0, 0}, {8, 8});
  EXPECT_EQ(shown.corner, (Vec2{0, -8}));
  EXPECT_EQ(shown.right, (Vec2{0, 16})) << "its rows are columns";
  EXPECT_EQ(shown.down, (Vec2{32, 0}));
  tile.part.mirrors_x = true;
  shown = placed(tile, {0, 0}, {8, 8});
  EXPECT_EQ(shown.corner, (Vec2{32, -8}));
  EXPECT_EQ(shown.down, (Vec2{-32, 0}));
}

TEST(PlacedPicture, ACellTurnsItsTileAfterItsPart) {
  LargeTile tile{part_of(16, 32), {16, 32}};
  PlacedPicture shown = placed(tile, {0, 0}, {8, 8}, TileTurn::left_right);
  EXPECT_EQ(shown.corner, (Vec2{16, -24}));
  EXPECT_EQ(shown.right, (Vec2{-16, 0}));
  tile.part.mirrors_x = true;
  shown = placed(tile, {0, 0}, {8, 8}, TileTurn::diagonal);
  EXPECT_EQ(shown.corner, (Vec2{0, 8})) << "its left side, now the right one, is at the bottom then";
  EXPECT_EQ(shown.right, (Vec2{0, -16}));
  EXPECT_EQ(shown.down, (Vec2{32, 0}));
  const CellReach reach = reach_of({{1, tile}}, {8, 8});
  EXPECT_EQ(reach.up, 3);
  EXPECT_EQ(reach.right, 3) << "turned";
}

TEST(PlacedPicture, AKeptRatioIsInTheMiddle) {
  LargeTile tile{part_of(16, 32), {8, 8}};
  tile.part.keeps_ratio = true;
  const PlacedPicture shown = placed(tile, {0, 0}, {8, 8});
  EXPECT_EQ(shown.corner, (Vec2{2, 0}));
  EXPECT_EQ(shown.right, (Vec2{4, 0}));
}

TEST(PlacedPicture, AnObjectTurnsAboutItsAnchor) {
  MapObject object{.form = MapObject::Form::tile, .position = {10, 20}, .size = {4, 8}, .rotation = 90};
  object.picture = part_of(4, 8);
  const PlacedPicture shown = placed(object);
  EXPECT_NEAR(shown.corner.x, 18, 1e-9);
  EXPECT_NEAR(shown.corner.y, 20, 1e-9);
  EXPECT_NEAR(shown.right.y, 4, 1e-9);
  EXPECT_NEAR(shown.down.x, -8, 1e-9);
}

TEST(PlacedPicture, LayersAreInTheOrderOfTheirPlaces) {
  Level level;
  level.layers.list.resize(2);
  level.objects = {{.name = "front"}, {.name = "between", .place = 1}, {.name = "behind", .place = 0}};
  EXPECT_THAT(layers_in_order(level),
              ElementsAre(LayerInOrder{false, 2}, LayerInOrder{true, 0}, LayerInOrder{false, 1},
                          LayerInOrder{true, 1}, LayerInOrder{false, 0}));
}

TEST(PlacedPicture, ObjectsAreDrawnByTheirY) {
  ObjectLayer layer{.by_y = true};
  for (const double y : {9.0, 3.0, 5.0}) {
    layer.objects.push_back({.form = MapObject::Form::tile, .position = {0, y}, .size = {4, 4}});
    layer.objects.back().picture = part_of(4, 4);
  }
  layer.objects[2].visible = false;
  EXPECT_THAT(drawn_pictures(layer), ElementsAre(1, 0));
}

}  // namespace talus::placed_picture_test
