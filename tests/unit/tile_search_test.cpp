// Counting and finding tiles on the map.
#include "edit/tile_search.h"

#include <gtest/gtest.h>

#include "map_text.h"

namespace talus::tile_search_test {

constexpr auto kNext = FindDirection::next, kPrevious = FindDirection::previous;

TEST(TileSearch, CountsInTheSelectionOrEverywhere) {
  const TileMap map = level_of_rows({"a.a", "aab"}).map;
  EXPECT_EQ(count_tile(map, 1), 4u);
  EXPECT_EQ(count_tile(map, 1, CellRect{0, 0, 2, 9}), 3u);
  EXPECT_EQ(count_tile(map, 9), 0u);
  EXPECT_EQ(count_tile(map, 1, CellRect{7, 7, 1, 1}), 0u);
}

TEST(TileSearch, GoesRowByRowAndWrapsAround) {
  const TileMap map = level_of_rows({".a.", "a..", "..a"}).map;
  std::optional<Cell> at;
  for (const Cell expected : {Cell{1, 0}, {0, 1}, {2, 2}, {1, 0}})
    EXPECT_EQ(at = find_tile(map, 1, at, kNext), expected);
  at.reset();
  for (const Cell expected : {Cell{2, 2}, {0, 1}, {1, 0}, {2, 2}})
    EXPECT_EQ(at = find_tile(map, 1, at, kPrevious), expected);
}

TEST(TileSearch, TheOnlyTileIsFoundFromItself) {
  const TileMap map = level_of_rows({"...", ".a."}).map;
  EXPECT_EQ(find_tile(map, 1, Cell{1, 1}, kNext), (Cell{1, 1}));
  EXPECT_EQ(find_tile(map, 1, Cell{1, 1}, kPrevious), (Cell{1, 1}));
  EXPECT_EQ(find_tile(map, 2, Cell{1, 1}, kNext), std::nullopt);
  EXPECT_EQ(find_tile(map, 1, Cell{90, -5}, kNext), (Cell{1, 1}))
      << "from beside the map: from its beginning";
}

TEST(TileSearch, StaysInTheSelection) {
  const TileMap map = level_of_rows({"aaaa"}).map;
  EXPECT_EQ(find_tile(map, 1, Cell{2, 0}, kNext, CellRect{1, 0, 2, 1}), (Cell{1, 0}));
}

}  // namespace talus::tile_search_test
