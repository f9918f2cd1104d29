// The levels that the welcome page starts.
#include "edit/new_level.h"

#include <gtest/gtest.h>

#include <memory>

#include <talus/sim/solver.h>
#include "level/lint/lint.h"
#include "level/tile_color.h"

namespace talus::new_level_test {

TEST(NewLevel, AnEmptyOneHasNothing) {
  const Level level = new_level({8, 8}, 60, 34, {});
  EXPECT_EQ(level.map.width(), 60);
  EXPECT_EQ(level.map.height(), 34);
  EXPECT_EQ(level.sheet(SheetId::tiles).picture, nullptr);
  EXPECT_TRUE(compile_scene(level).items.empty());
}

TEST(NewLevel, InTrueColourItsTilesAreClear) {
  const Level level = new_level({24, 16}, 60, 34, {.in_true_colour = true});
  const auto picture = level.sheet(SheetId::tiles).picture;
  ASSERT_NE(picture, nullptr);
  EXPECT_EQ(picture->width, 16 * 24);
  EXPECT_EQ(picture->height, 16 * 16);
  for (int tile = 0; tile < level.tile_count(); ++tile)
    EXPECT_TRUE(is_blank(level, static_cast<TileNumber>(tile)));
}

TEST(NewLevel, ThePlayerRunsOverItsSlopes) {
  for (const int side : {8, 16, 24, 32}) {
    const Level level = new_level({side, side}, 60, 34, {.plays = true});
    const auto scene = std::make_shared<const Scene>(compile_scene(level));
    const auto solver = make_solver(scene);
    State state = initial_state(*scene);
    ASSERT_EQ(state.bodies.size(), 2u) << "a ball and a player";
    Input held;
    held.right = true;
    const auto player = [&]() -> const Body& {
      return state.bodies[0].kind == BodyKind::player ? state.bodies[0] : state.bodies[1];
    };
    for (int i = 0; i < 600 && player().box.x < 26.0 * side; ++i) solver->step(state, held);
    EXPECT_GE(player().box.x, 26.0 * side) << side;
  }
}

TEST(NewLevel, ItHasNoProblems) {
  for (const TileSize tile : {TileSize{8, 8}, TileSize{16, 16}})
    EXPECT_TRUE(lint(new_level(tile, 60, 34, {.plays = true})).empty());
}

TEST(NewLevel, BothKindsOfColourLookTheSame) {
  const Level palette = new_level({8, 8}, 60, 34, {false, true});
  const Level true_colour = new_level({8, 8}, 60, 34, {true, true});
  for (TileNumber tile = 1; tile <= 5; ++tile)
    for (int i = 0; i < 8; ++i)
      EXPECT_EQ(color_on_map(palette, tile, i, 7 - i), color_on_map(true_colour, tile, i, 7 - i));
}

TEST(NewLevel, TilesOfAnotherSizeAreInTrueColour) {
  const Level level = new_level({16, 16}, 60, 34, {});
  ASSERT_NE(level.sheet(SheetId::tiles).picture, nullptr);
  EXPECT_EQ(level.sheet(SheetId::tiles).picture->width, 16 * 16);
  const Level large = new_level({256, 256}, 6, 4, {.plays = true});
  EXPECT_EQ(large.tile_count(), 64) << "16 MB of pixels";
}

TEST(NewLevel, ASmallMapCutsTheScene) { EXPECT_EQ(new_level({8, 8}, 6, 4, {false, true}).map.width(), 6); }

}  // namespace talus::new_level_test
