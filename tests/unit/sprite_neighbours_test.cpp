// The neighbours of tiles on the map.
#include "edit/tile_neighbours.h"

#include <gtest/gtest.h>

namespace talus::sprite_neighbours_test {

//  0 1 0 0 1 0
//  3 5 4 3 5 4
//  0 2 0 0 2 0
//  0 0 6 5 4 0
Level level_of_joined_tiles() {
  const std::vector<std::vector<int>> rows = {
      {0, 1, 0, 0, 1, 0}, {3, 5, 4, 3, 5, 4}, {0, 2, 0, 0, 2, 0}, {0, 0, 6, 5, 4, 0}};
  Level level;
  level.map = TileMap(6, 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 6; ++x)
      level.map.set({x, y},
                    static_cast<TileNumber>(rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)]));
  return level;
}

TEST(SpriteNeighbours, PlaceIsWhereAllTilesStand) {
  const Level level = level_of_joined_tiles();
  EXPECT_EQ(place_of_tiles(level, {5, 0, 1, 1}, {4, 1}), (Cell{4, 1}));
  EXPECT_FALSE(place_of_tiles(level, {5, 0, 1, 1}, {0, 0}));
  EXPECT_FALSE(place_of_tiles(level, {5, 0, 1, 1}, {9, 0})) << "off the map";
  EXPECT_FALSE(place_of_tiles(level, {5, 0, 2, 1}, {4, 1})) << "4 and not 6 is to the right";
  EXPECT_EQ(place_of_tiles(level, {3, 0, 2, 1}, {3, 1}), std::nullopt);
  Level pair;
  pair.map = TileMap(4, 1);
  pair.map.set({1, 0}, 3);
  pair.map.set({2, 0}, 4);
  EXPECT_EQ(place_of_tiles(pair, {3, 0, 2, 1}, {2, 0}), (Cell{1, 0})) << "from its second tile, too";
}

TEST(SpriteNeighbours, AtAPlaceWithoutThoseBeyondTheEdge) {
  const TileNeighbours n = neighbours_at(level_of_joined_tiles().map, {5, 0, 1, 1}, {3, 3});
  EXPECT_EQ(n.at(-1, 0), 6);
  EXPECT_EQ(n.at(1, 0), 4);
  EXPECT_EQ(n.at(1, -1), 2);
  EXPECT_EQ(n.at(0, -1), 0);
  EXPECT_FALSE(n.at(0, 1));
  EXPECT_FALSE(n.at(0, 0)) << "the tile itself is no neighbour";
}

TEST(SpriteNeighbours, CommonestOnEachSide) {
  const TileNeighbours n = commonest_neighbours(level_of_joined_tiles(), {5, 0, 1, 1});
  EXPECT_EQ(n.at(-1, 0), 3);
  EXPECT_EQ(n.at(1, 0), 4);
  EXPECT_EQ(n.at(0, -1), 1);
  EXPECT_EQ(n.at(0, 1), 2);
  EXPECT_EQ(n.at(-1, -1), 0);
}

TEST(SpriteNeighbours, EachEdgeTileOfSeveralHasItsOwn) {
  const TileNeighbours n = commonest_neighbours(level_of_joined_tiles(), {3, 0, 3, 1});  // 3 4 5
  EXPECT_EQ(n.w, 3);
  EXPECT_EQ(n.at(2, -1), 1) << "above 5";
  EXPECT_EQ(n.at(1, 1), 0) << "below 4";
  EXPECT_EQ(n.at(3, 0), 4) << "to the right of 5";
  EXPECT_EQ(n.at(-1, 0), 4) << "to the left of 3";
}

TEST(SpriteNeighbours, TilesMissingOnTheMapHaveNone) {
  const TileNeighbours n = commonest_neighbours(level_of_joined_tiles(), {9, 9, 1, 1});
  for (const auto& tile : n.ring) EXPECT_FALSE(tile);
}

}  // namespace talus::sprite_neighbours_test
