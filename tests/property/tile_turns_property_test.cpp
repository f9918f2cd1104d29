// Random shapes in turned cells: their ground is that of the tile, turned as Tiled turns its picture.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <talus/level/ground.h>
#include <talus/level/tile_turns.h>
#include "collision/ground_queries.h"
#include "random_polygons.h"

namespace talus::tile_turns_property_test {

constexpr int kPlaces = 40;

// Where Tiled draws a place of a tile: the diagonal flip comes first.
Vec2 as_in_tiled(Vec2 p, TileTurn turn, TileSize tile) {
  if (has_flip(turn, TileTurn::diagonal)) p = {p.y, p.x};
  const TileSize size = turned(tile, turn);
  if (has_flip(turn, TileTurn::left_right)) p.x = size.width - p.x;
  if (has_flip(turn, TileTurn::up_down)) p.y = size.height - p.y;
  return {p.x, p.y + tile.height - size.height};
}

TileSize some_tile_size(Dice& dice) { return {4 + dice.up_to(28), 4 + dice.up_to(28)}; }

RC_GTEST_PROP(TileTurnsProperty, InsideIsWhatWasInsideBefore, (std::uint64_t seed)) {
  Dice dice(seed);
  const TileSize tile = some_tile_size(dice);
  const TileShape shape =
      dice.one_in(2) ? random_polygon(dice, tile, false) : random_group(dice, tile, false);
  RC_PRE(!problem_of(shape, tile));
  const auto turn = static_cast<TileTurn>(dice.up_to(kTileTurns - 1));
  const TileShape image = turned(shape, turn, tile);
  if (problem_of(image, tile)) return;  // a tile that is long and low may reach too far
  for (int i = 0; i < kPlaces; ++i) {
    const Vec2 place{dice.in(-tile.width, 2 * tile.width), dice.in(-tile.height, 2 * tile.height)};
    const Vec2 there = as_in_tiled(place, turn, tile);
    RC_ASSERT(is_inside(image, tile, there.x, there.y) == is_inside(shape, tile, place.x, place.y));
  }
}

// The same ground, whether a cell turns a tile or a tile has the turned points.
RC_GTEST_PROP(TileTurnsProperty, ACellIsLikeATileWithTurnedPoints, (std::uint64_t seed)) {
  Dice dice(seed);
  const TileSize tile = some_tile_size(dice);
  Level cells, tiles;
  cells.map = tiles.map = TileMap(6, 6, tile);
  for (TileNumber number = 1; number <= 6; ++number) {
    TileShape shape = random_polygon(dice, tile, false);
    if (problem_of(shape, tile)) continue;
    const auto turn = static_cast<TileTurn>(dice.up_to(kTileTurns - 1));
    const Cell cell{dice.up_to(5), dice.up_to(5)};
    cells.tile_shapes[number] = shape;
    for (Vec2& point : shape.points) point = as_in_tiled(weld(point), turn, tile);
    tiles.tile_shapes[number] = shape;
    cells.map.set(cell, {number, turn});
    tiles.map.set(cell, number);
  }
  const Terrain ground = terrain_of(cells), expected = terrain_of(tiles);
  for (int i = 0; i < kPlaces; ++i) {
    const Rect box{dice.in(0, 6 * tile.width), dice.in(0, 6 * tile.height), dice.in(0, 9), dice.in(0, 9)};
    RC_ASSERT(overlaps_ground(ground, box) == overlaps_ground(expected, box));
  }
}

}  // namespace talus::tile_turns_property_test
