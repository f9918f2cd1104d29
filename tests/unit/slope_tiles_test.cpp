// Tiles along a slope: the floors of drawn and placed tiles lie on the line.
#include "level/slope_tiles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace talus::slope_tiles_test {

using testing::ElementsAre;

Level blank_level(int width = 30, int height = 17) {
  Level level;
  level.map = TileMap(width, height);
  return level;
}

void put(Level& level, const SlopeTiles& tiles) {
  for (const SlopeTiles::Drawn& drawn : tiles.drawn) {
    level.sheet(SheetId::tiles).images[drawn.tile] = drawn.image;
    level.tile_shapes[drawn.tile] = drawn.shape;
  }
  for (const SlopeTiles::Placed& placed : tiles.placed) level.map.set(placed.cell, placed.tile);
}

// The y of the highest floor at x, in px down, seen from the cell to the left or to the right of x.
double floor_at(const Level& level, int x, bool from_left) {
  double best = 1e9;
  for (int y = 0; y < level.map.height(); ++y) {
    for (int cell_x = 0; cell_x < level.map.width(); ++cell_x) {
      const TileShape shape = shape_of_tile(level, level.map.tile_at({cell_x, y}));
      if (shape.kind == TileShape::Kind::none) continue;
      const double inside = x - cell_x * 8, width = shape.tiles * 8;
      if (from_left ? !(inside > 0 && inside <= width) : !(inside >= 0 && inside < width)) continue;
      const auto& h = shape.heights;
      double height = 8;
      if (!h.empty()) {
        const double step = width / static_cast<double>(h.size() - 1);
        const auto i = std::min(h.size() - 2, static_cast<std::size_t>(inside / step));
        height = h[i] + (h[i + 1] - h[i]) * (inside / step - static_cast<double>(i));
      }
      best = std::min(best, y * 8 + 8 - height);
    }
  }
  return best;
}

void expect_on_line(const Level& level, Vec2 from, Vec2 to, double slack) {
  for (int x = static_cast<int>(from.x); x <= to.x; ++x) {
    const double wanted = from.y + (to.y - from.y) * (x - from.x) / (to.x - from.x);
    if (x > from.x) {
      EXPECT_NEAR(floor_at(level, x, true), wanted, slack) << x;
    }
    if (x < to.x) {
      EXPECT_NEAR(floor_at(level, x, false), wanted, slack) << x;
    }
  }
}

std::string error_of(const Level& level, Vec2 a, Vec2 b, const SlopeTilesOptions& options = {}) {
  const auto tiles = slope_tiles(level, a, b, options);
  return tiles ? "" : tiles.error();
}

TEST(SlopeTiles, TheArticlesSlopeIsTwoTiles) {
  const Level level = blank_level();
  const SlopeTiles tiles = slope_tiles(level, {16, 40}, {32, 32}, {.below = 9}).value();
  EXPECT_THAT(tiles.placed, ElementsAre(SlopeTiles::Placed{{2, 4}, 1}, SlopeTiles::Placed{{2, 5}, 9},
                                        SlopeTiles::Placed{{3, 4}, 2}, SlopeTiles::Placed{{3, 5}, 9}));
  ASSERT_EQ(tiles.drawn.size(), 2u);
  EXPECT_EQ(tiles.drawn[0].shape, (TileShape{.kind = TileShape::Kind::slope, .heights = {0, 4}}));
  EXPECT_EQ(tiles.drawn[1].shape, (TileShape{.kind = TileShape::Kind::slope, .heights = {4, 8}}));
  EXPECT_EQ(tiles.drawn[0].image[7 * 8 + 0], 0);
  EXPECT_EQ(tiles.drawn[0].image[7 * 8 + 1], 5);   // the line
  EXPECT_EQ(tiles.drawn[0].image[7 * 8 + 7], 15);  // the ground
  EXPECT_EQ(tiles.drawn[0].image[4 * 8 + 7], 5);
}

TEST(SlopeTiles, DrawnFloorsAreOnTheLine) {
  const std::vector<std::pair<Vec2, Vec2>> lines = {
      {{16, 40}, {32, 32}}, {{3, 100}, {77, 20}},   {{0, 1}, {240, 135}}, {{5, 50}, {100, 50}},
      {{8, 16}, {64, 16}},  {{40, 120}, {48, 64}},  {{9, 77}, {10, 76}},  {{4, 90}, {12, 60}},
      {{0, 136}, {24, 0}},  {{100, 30}, {177, 133}}};
  for (const auto& [from, to] : lines) {
    Level level = blank_level();
    put(level, slope_tiles(level, to, from).value());  // the ends may come in any order
    expect_on_line(level, from, to, kSlopeTileGrain / 2);
  }
}

TEST(SlopeTiles, TheFloorIsLevelBeyondTheEnds) {
  Level level = blank_level();
  put(level, slope_tiles(level, {3, 40}, {13, 20}).value());
  for (int x = 0; x < 3; ++x) EXPECT_EQ(floor_at(level, x, false), 40) << x;
  for (int x = 14; x <= 16; ++x) EXPECT_EQ(floor_at(level, x, true), 20) << x;
}

TEST(SlopeTiles, RepeatingTilesAreDrawnOnce) {
  Level level = blank_level();
  const SlopeTiles half = slope_tiles(level, {0, 120}, {240, 0}).value();
  EXPECT_EQ(half.drawn.size(), 2u);
  const SlopeTiles third = slope_tiles(level, {0, 120}, {240, 40}).value();
  EXPECT_EQ(third.drawn.size(), 3u);
  put(level, third);
  EXPECT_EQ(slope_tiles(level, {24, 128}, {48, 120})->drawn.size(), 0u);  // existing tiles are used again
}

TEST(SlopeTiles, TilesInUseAreLeftAlone) {
  Level level = blank_level();
  level.map.set({20, 1}, 1);                     // blank, but on the map
  level.sheet(SheetId::tiles).flags[2] = 1;      // flagged
  level.sheet(SheetId::tiles).images[3][5] = 1;  // drawn
  level.tile_shapes[4].kind = TileShape::Kind::solid;
  EXPECT_EQ(slope_tiles(level, {0, 8}, {8, 0})->drawn.at(0).tile, 5);
}

TEST(SlopeTiles, ErrorsSayWhy) {
  Level level = blank_level();
  EXPECT_EQ(error_of(level, {8, 8}, {8.4, 16}), "the slope is vertical");
  EXPECT_EQ(error_of(level, {-1, 8}, {8, 16}), "an end of the slope is not on the map");
  EXPECT_EQ(error_of(level, {0, std::nan("")}, {8, 16}), "an end of the slope is not on the map");
  EXPECT_EQ(error_of(level, {0, 136}, {8, 136}), "the slope's tiles would leave the map");
  EXPECT_EQ(error_of(level, {0, 120}, {8, 50}),
            "the slope is too steep: the floor of a tile can rise by at most 64 px");
  for (int tile = 1; tile < kCartTiles; ++tile) level.sheet(SheetId::tiles).images[tile].fill(3);
  EXPECT_EQ(error_of(level, {0, 8}, {8, 0}), "there are too few blank tiles to draw the slope with");
}

// Tiles 3 and 5 are the article's slopes, each with its other half beside it. Tile 1 is solid.
Level level_with_set() {
  Level level = blank_level();
  auto& sheet = level.sheet(SheetId::tiles);
  for (int tile = 1; tile <= 6; ++tile) sheet.images[tile].fill(static_cast<std::uint8_t>(tile));
  sheet.flags[1] = 1;
  sheet.flags[3] = 4;
  sheet.flags[5] = 8;
  return level;
}

TEST(SlopeTiles, SlopesOfASetAreLaidWithTheirOtherHalves) {
  const Level level = level_with_set();
  constexpr std::array<TileNumber, 2> kSet = {3, 5};
  const SlopeTiles tiles = slope_tiles(level, {16, 40}, {48, 24}, {.set = kSet, .below = 1}).value();
  EXPECT_TRUE(tiles.drawn.empty());
  EXPECT_THAT(tiles.placed, ElementsAre(SlopeTiles::Placed{{2, 4}, 3}, SlopeTiles::Placed{{2, 5}, 1},
                                        SlopeTiles::Placed{{3, 4}, 4}, SlopeTiles::Placed{{3, 5}, 1},
                                        SlopeTiles::Placed{{4, 3}, 3}, SlopeTiles::Placed{{4, 4}, 1},
                                        SlopeTiles::Placed{{5, 3}, 4}, SlopeTiles::Placed{{5, 4}, 1}));
}

TEST(SlopeTiles, SlopesOfASetStayNearTheLine) {
  constexpr std::array<TileNumber, 3> kSet = {1, 3, 5};
  const std::vector<std::pair<Vec2, Vec2>> lines = {
      {{0, 128}, {240, 8}}, {{0, 100}, {240, 40}}, {{7, 20}, {200, 61}}, {{0, 50}, {240, 50}}};
  for (const auto& [from, to] : lines) {
    Level level = level_with_set();
    put(level, slope_tiles(level, from, to, {.set = kSet}).value());
    expect_on_line(level, from, to, 8);
    for (int x = 8; x < 240 && x < to.x; x += 8)
      EXPECT_EQ(floor_at(level, x, true), floor_at(level, x, false));
  }
}

TEST(SlopeTiles, ASetThatCannotFollowTheLineIsAnError) {
  const Level level = level_with_set();
  constexpr std::array<TileNumber, 3> kSet = {1, 3, 5};
  constexpr std::array<TileNumber, 1> kUpOnly = {3}, kPicture = {4};
  EXPECT_EQ(error_of(level, {0, 128}, {120, 8}, {.set = kSet}),
            "the tiles of the set would leave the line by more than a tile");
  EXPECT_EQ(error_of(level, {0, 40}, {120, 40}, {.set = kUpOnly}),
            "the set has no tile that follows the line");
  EXPECT_EQ(error_of(level, {0, 40}, {120, 40}, {.set = kPicture}), "the set has no tile with a floor");
}

}  // namespace talus::slope_tiles_test
