// The map as it is drawn when it is zoomed far out.
#include "overlay/map_picture.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace talus::map_picture_test {

constexpr Rgb kBlack{0, 0, 0}, kRed{200, 0, 0}, kBlue{0, 0, 100};

// Tile 1 is red with a blue corner. Tile 2 is blue and a ball.
Level picture_level(int width, int height) {
  Level level;
  level.palette[0] = kBlack;
  level.palette[1] = kRed;
  level.palette[2] = kBlue;
  Sheet& tiles = level.sheet(SheetId::tiles);
  tiles.images[1].fill(1);
  tiles.images[1][0] = 2;
  tiles.images[2].fill(2);
  tiles.flags[2] = 2;
  level.map = TileMap(width, height);
  return level;
}

Rgb pixel(const std::vector<std::uint8_t>& rgba, int at) {
  const auto i = static_cast<std::size_t>(at) * 4;
  return {rgba[i], rgba[i + 1], rgba[i + 2]};
}
std::uint8_t alpha(const std::vector<std::uint8_t>& rgba, int at) {
  return rgba[static_cast<std::size_t>(at) * 4 + 3];
}

TEST(MapPicture, ATileHasTheColourOfMostOfItsPixels) {
  const TileColors colors = tile_colors(picture_level(1, 1), {});
  EXPECT_EQ(colors[0], kBlack);
  EXPECT_EQ(colors[1], kRed);
  EXPECT_EQ(colors[2], kBlue);
}

TEST(MapPicture, ATileInTrueColourHasTheMeanOfItsPixels) {
  Level level = picture_level(1, 1);
  level.set_tile_layout({2, 2});
  SheetPicture picture{16, 8, std::vector<std::uint8_t>(16 * 8 * 4, 255)};
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
    const bool is_first = i / 4 % 16 < 8, is_left = i / 4 % 8 < 4;
    if (is_first) picture.rgba[i] = is_left ? 100 : 200;
    if (!is_first) picture.rgba[i + 3] = 0;
  }
  level.sheet(SheetId::tiles).picture = std::make_shared<const SheetPicture>(std::move(picture));
  const TileColors colors = tile_colors(level, {});
  EXPECT_EQ(colors[0], (Rgb{150, 255, 255}));
  EXPECT_EQ(colors[1], level.palette[0]) << "where it is clear, colour 0 is seen";
}

TEST(MapPicture, BallsMayBeHiddenAndFlagsTinted) {
  const Level level = picture_level(1, 1);
  EXPECT_EQ(tile_colors(level, {.hide_balls = true, .tinted = {}, .tint = {}})[2], kBlack);
  const TileColors tinted =
      tile_colors(level, {.hide_balls = false, .tinted = pattern_of_flag(1), .tint = {100, 0, 0}});
  EXPECT_EQ(tinted[1], kRed);
  EXPECT_EQ(tinted[2], (Rgb{43, 0, 57}));
}

TEST(MapPicture, APixelIsACellAndClearBeyondTheMap) {
  Level level = picture_level(2, 2);
  level.map.set({1, 0}, 1);
  level.map.set({0, 1}, 2);
  const auto rgba = map_picture(level.map, tile_colors(level, {}), {0, 0}, 1, 3, 3);
  EXPECT_EQ(pixel(rgba, 0), kBlack);
  EXPECT_EQ(pixel(rgba, 1), kRed);
  EXPECT_EQ(pixel(rgba, 3), kBlue);
  EXPECT_EQ(alpha(rgba, 4), 255);
  for (const int beyond : {2, 5, 6, 7, 8}) EXPECT_EQ(alpha(rgba, beyond), 0) << beyond;
}

TEST(MapPicture, ABlockIsTheMeanOfItsCellsOnTheMap) {
  Level level = picture_level(3, 2);
  level.map.set({0, 0}, 1);
  level.map.set({2, 1}, 1);
  const auto rgba = map_picture(level.map, tile_colors(level, {}), {0, 0}, 2, 2, 1);
  EXPECT_EQ(pixel(rgba, 0), (Rgb{50, 0, 0}));
  EXPECT_EQ(pixel(rgba, 1), (Rgb{100, 0, 0})) << "of its four cells two are on the map";
}

TEST(MapPicture, EveryRowAndColumnCounts) {
  for (int phase = 0; phase < 4; ++phase) {
    Level rows = picture_level(64, 64), columns = picture_level(64, 64);
    for (int far = phase; far < 64; far += 4) {
      for (int near = 0; near < 64; ++near) {
        rows.map.set({near, far}, 1);
        columns.map.set({far, near}, 1);
      }
    }
    for (const int block : {4, 16, 64}) {
      const TileColors colors = tile_colors(rows, {});
      EXPECT_EQ(pixel(map_picture(rows.map, colors, {0, 0}, block, 1, 1), 0), (Rgb{50, 0, 0})) << block;
      EXPECT_EQ(pixel(map_picture(columns.map, colors, {0, 0}, block, 1, 1), 0), (Rgb{50, 0, 0})) << block;
    }
  }
}

TEST(MapPicture, TheLongestRowFitsAPixel) {
  Level level = picture_level(kMaxTerrainSide, 8);
  level.palette[1] = {255, 255, 255};
  std::fill(level.map.cells().tiles().begin(), level.map.cells().tiles().end(), TileNumber{1});
  EXPECT_EQ(pixel(map_picture(level.map, tile_colors(level, {}), {0, 0}, kMaxBlock, 1, 1), 0),
            (Rgb{255, 255, 255}));
}

TEST(MapPicture, LayersInFrontAreClearWhereTheyShowNothing) {
  Level level = picture_level(2, 1);
  level.sheet(SheetId::tiles).images[1][1] = 0;
  level.map.cells().tiles() = {1, 0};
  level.layers.list = {{.cells = std::make_shared<const MapCells>(2)}, {}};
  level.layers.chosen = 1;
  const auto picture = [&](const LayerLook& look, int block) {
    return layer_picture(level, look.layer, layer_paint(level, look), {0, 0}, block, 2, 1);
  };
  const auto front = picture({1, false, {}}, 1);
  EXPECT_EQ(pixel(front, 0), kRed);
  EXPECT_EQ(alpha(front, 0), 255 * 63 / 64) << "one pixel of 64 has colour 0";
  EXPECT_EQ(alpha(front, 1), 0) << "tile 0";
  const auto block = picture({1, false, {}}, 2);
  EXPECT_NEAR(pixel(block, 0).r, kRed.r, 2) << "what is clear does not darken the rest";
  EXPECT_EQ(alpha(block, 0), 255 * 63 / 64 / 2);
  const auto back = picture({0, true, {}}, 1);
  EXPECT_EQ(pixel(back, 0), kBlack);
  EXPECT_EQ(alpha(back, 0), 255);
}

TEST(MapPicture, OnlyGroundHidesItsBalls) {
  Level level = picture_level(1, 1);
  level.layers.list = {{.cells = std::make_shared<const MapCells>(1)}, {}};
  level.layers.chosen = 1;
  LayerLook look{1, false, {}};
  look.look.hide_balls = true;
  EXPECT_EQ(layer_paint(level, look).opacity[2], 0);
  level.layers.list[1].is_ground = false;
  EXPECT_EQ(layer_paint(level, look).opacity[2], 255);
}

TEST(MapPicture, LayersInTrueColourKeepTheirOpacity) {
  Level level = picture_level(1, 1);
  level.set_tile_layout({2, 2});
  SheetPicture picture{16, 8, std::vector<std::uint8_t>(16 * 8 * 4, 200)};
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4)
    if (i / 4 % 8 < 4) picture.rgba[i] = 0;  // clear in the left half
  level.sheet(SheetId::tiles).picture = std::make_shared<const SheetPicture>(std::move(picture));
  const LayerPaint paint = layer_paint(level, {0, false, {}});
  EXPECT_EQ(paint.colors[1], (Rgb{200, 200, 200})) << "not mixed with what is below";
  EXPECT_EQ(paint.opacity[1], 100);
}

}  // namespace talus::map_picture_test
