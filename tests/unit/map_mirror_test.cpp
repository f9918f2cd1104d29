// Mirroring cells with their slopes.
#include "edit/map_mirror.h"

#include <gtest/gtest.h>

#include "map_text.h"

namespace talus::map_mirror_test {

using Kind = TileShape::Kind;

// a: solid, one colour. b, c: the halves of an up-slope of 16x8 px as in the article, with the flag on the
// left one. d, e: the halves of a down-slope, drawn as mirror images. f: an up-slope of one tile with its own
// shape. g: a sign without ground, drawn on its left. h: the mirror image of the sign.
// The level is a cart's, which has no turned tiles.
Level mirror_level(const MapRows& rows) {
  Level level = level_of_rows(rows);
  level.cart = std::make_shared<const CartOrigin>();
  Sheet& sheet = level.sheet(SheetId::tiles);
  sheet.flags[1] = 1;
  sheet.flags[2] = 4;
  sheet.flags[4] = 8;
  sheet.images[1].fill(1);
  const auto draw = [&](int tile, auto color_at) {
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x)
        sheet.images[static_cast<std::size_t>(tile)][static_cast<std::size_t>(8 * y + x)] =
            static_cast<std::uint8_t>(color_at(x, y));
  };
  draw(2, [](int x, int y) { return 2 * (8 - y) <= x + 1 ? 3 : 0; });
  draw(3, [](int x, int y) { return 2 * (8 - y) <= x + 9 ? 3 : 0; });
  draw(4, [](int x, int y) { return 2 * (8 - y) <= 7 - x + 9 ? 3 : 0; });
  draw(5, [](int x, int y) { return 2 * (8 - y) <= 7 - x + 1 ? 3 : 0; });
  draw(6, [](int x, int y) { return 8 - y <= x ? 4 : 0; });
  draw(7, [](int x, int) { return x < 3 ? 5 : 0; });
  draw(8, [](int x, int) { return x > 4 ? 5 : 0; });
  level.tile_shapes[6] = {.kind = Kind::slope, .heights = {0, 8}};
  return level;
}

constexpr MirrorAxis kLeftRight = MirrorAxis::horizontal, kUpDown = MirrorAxis::vertical;

TEST(MapMirror, SlopeOfTwoTilesBecomesTheOneThatGoesDown) {
  const Level level = mirror_level({".bca", "...."});
  const MirroredCells mirrored = mirror_cells(level, {0, 0, 4, 1}, kLeftRight);
  EXPECT_EQ(rows_after(level, mirrored.edit)[0], "ade.");
  EXPECT_EQ(mirrored.without_partner, 0);
  EXPECT_EQ(mirrored.unmirrored_art, 0);
  EXPECT_EQ(text_of_missing(mirrored), "");
}

TEST(MapMirror, MirroringTwiceRestoresTheMap) {
  const MapRows rows = {"abcdea.g", "g.bc.deh"};
  Level level = mirror_level(rows);
  for (int i = 0; i < 2; ++i) apply_edit(level, mirror_cells(level, {0, 0, 8, 2}, kLeftRight).edit);
  EXPECT_EQ(rows_of(level.map), rows);
}

TEST(MapMirror, CellsOutsideAreLeftAlone) {
  const Level level = mirror_level({"abca", "bcga"});
  EXPECT_EQ(rows_after(level, mirror_cells(level, {0, 1, 3, 1}, kLeftRight).edit), (MapRows{"abca", "hdea"}));
}

TEST(MapMirror, PictureWithTheSameFlagsIsPreferred) {
  Level level = mirror_level({"g."});
  EXPECT_EQ(rows_after(level, mirror_cells(level, {0, 0, 2, 1}, kLeftRight).edit), MapRows{".h"});
  level.sheet(SheetId::tiles).flags[8] = 128;  // means something to the game
  const MirroredCells mirrored = mirror_cells(level, {0, 0, 2, 1}, kLeftRight);
  EXPECT_EQ(rows_after(level, mirrored.edit), MapRows{".g"});
  EXPECT_EQ(mirrored.unmirrored_art, 1);
  EXPECT_EQ(text_of_missing(mirrored), "1 tile is not drawn mirrored, as the sheet has no such picture.");
}

TEST(MapMirror, SlopeWithoutAPartnerIsMovedAsAWholeAndCounted) {
  Level level = mirror_level({"fbc.."});
  level.sheet(SheetId::tiles).flags[4] = 0;  // the sheet has no down-slope any more
  const MirroredCells mirrored = mirror_cells(level, {0, 0, 5, 1}, kLeftRight);
  EXPECT_EQ(rows_after(level, mirrored.edit), MapRows{"..bcf"});
  EXPECT_EQ(mirrored.without_partner, 2);
  EXPECT_EQ(
      text_of_missing(mirrored),
      "2 pieces of ground are as before: the sheet has no mirror image, or the selection cuts through.");
}

TEST(MapMirror, SlopeThatTheSelectionCutsIsCounted) {
  const Level level = mirror_level({"a.bc"});
  const MirroredCells mirrored = mirror_cells(level, {0, 0, 3, 1}, kLeftRight);
  EXPECT_EQ(rows_after(level, mirrored.edit), MapRows{"b.ac"});
  EXPECT_EQ(mirrored.without_partner, 1);
}

TEST(MapMirror, TheMostSimilarPartnerIsTaken) {
  Level level = mirror_level({"f"});
  for (const int tile : {9, 10})
    level.tile_shapes[static_cast<std::size_t>(tile)] = {.kind = Kind::slope, .heights = {8, 0}};
  for (int i = 0; i < 64; ++i)
    level.sheet(SheetId::tiles).images[10][static_cast<std::size_t>(i)] = 8 - i / 8 <= 7 - i % 8 ? 4 : 0;
  EXPECT_EQ(rows_after(level, mirror_cells(level, {0, 0, 1, 1}, kLeftRight).edit), MapRows{"j"});
}

TEST(MapMirror, FloorBecomesCeilingUpsideDown) {
  Level level = mirror_level({"f", ".", "a"});
  level.tile_shapes[9] = {.kind = Kind::slope, .side = TileShape::Side::ceiling, .heights = {0, 8}};
  const MirroredCells mirrored = mirror_cells(level, {0, 0, 1, 3}, kUpDown);
  EXPECT_EQ(rows_after(level, mirrored.edit), (MapRows{"a", ".", "i"}));
  EXPECT_EQ(mirrored.without_partner, 0);
  EXPECT_EQ(mirrored.unmirrored_art, 1) << "the ceiling has no picture";
  level.tile_shapes[9] = {};
  EXPECT_EQ(rows_after(level, mirror_cells(level, {0, 0, 1, 3}, kUpDown).edit), (MapRows{"a", ".", "f"}));
}

TEST(MapMirror, OneWayPlatformHasNoMirrorImageUpsideDown) {
  Level level = mirror_level({"i", "."});
  level.tile_shapes[9] = {.kind = Kind::solid, .one_way = true};
  EXPECT_EQ(mirror_cells(level, {0, 0, 1, 2}, kUpDown).without_partner, 1);
  EXPECT_EQ(mirror_cells(level, {0, 0, 1, 2}, kLeftRight).without_partner, 0);
}

TEST(MapMirror, WhatHasNoPartnerIsTurned) {
  Level level = mirror_level({"fbcgh", "i...."});
  level.cart = nullptr;
  level.sheet(SheetId::tiles).flags[4] = 0;    // the sheet has no down-slope any more
  level.sheet(SheetId::tiles).flags[8] = 128;  // and no mirror image of the sign
  level.tile_shapes[9] = {.kind = Kind::solid, .one_way = true};
  const MirroredCells across = mirror_cells(level, {0, 0, 5, 2}, kLeftRight);
  EXPECT_EQ(text_of_missing(across), "");
  apply_edit(level, across.edit);
  const auto turned = [](TileNumber tile, TileTurn turn = TileTurn::left_right) {
    return MapCell(tile, turn);
  };
  const MapCell expected[] = {turned(8), turned(7), turned(3), turned(2), turned(6)};
  for (int x = 0; x < 5; ++x) EXPECT_EQ(level.map.at({x, 0}), expected[x]) << x;
  EXPECT_EQ(level.map.at({4, 1}), 9);
  apply_edit(level, mirror_cells(level, {4, 0, 1, 2}, kUpDown).edit);
  EXPECT_EQ(level.map.at({4, 0}), turned(9, TileTurn::up_down));
  EXPECT_EQ(level.map.at({4, 1}), turned(6, turn_of(false, true, true)));
}

// As in maps of Tiled, whose tiles in 16 colours are blank.
TEST(MapMirror, TilesInTrueColorAreTurned) {
  Level level = level_of_rows({"abc"});
  level.tile_shapes[2] = {.kind = Kind::slope, .heights = {0, 8}};
  level.tile_shapes[4] = {.kind = Kind::slope, .heights = {8, 0}};
  const int side = kCartColumns * kCartTileSize;
  level.sheet(SheetId::tiles).picture = std::make_shared<const SheetPicture>(
      SheetPicture{side, side, std::vector<std::uint8_t>(static_cast<std::size_t>(4 * side * side))});
  for (const auto& [axis, turn, first] :
       {std::tuple{kLeftRight, TileTurn::left_right, 3}, std::tuple{kUpDown, TileTurn::up_down, 1}}) {
    Level turned = level;
    const MirroredCells mirrored = mirror_cells(level, {0, 0, 3, 1}, axis);
    apply_edit(turned, mirrored.edit);
    EXPECT_EQ(turned.map.at({0, 0}), MapCell(static_cast<TileNumber>(first), turn));
    EXPECT_EQ(turned.map.at({1, 0}), MapCell(2, turn));
    EXPECT_EQ(text_of_missing(mirrored), "");
  }
}

}  // namespace talus::map_mirror_test
