// The levels that the welcome page starts.
#include "edit/new_level.h"

#include <gtest/gtest.h>

#include <memory>

#include <talus/sim/solver.h>
#include "edit/auto_tile.h"
#include "edit/shape_tools.h"
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

TEST(NewLevel, ItsBallsFallAsItsPlayerDoesByTheClosedForm) {
  for (const int side : {8, 16, 24, 32}) {
    Level level = new_level({side, side}, 60, 34, {.plays = true});
    const double gravity = level.tuning.player.gravity;
    EXPECT_EQ(level.tuning.exact.gravity, gravity);
    level.spawns = {Spawn{.name = "", .position = {14.0 * side, 6.0 * side}, .extra = ""}};
    const auto scene = std::make_shared<const Scene>(compile_scene(level));
    const auto solver = make_solver(scene);
    State state = initial_state(*scene);
    const auto ball = [&]() -> const Body& { return state.bodies.back(); };
    const double from = ball().box.y;
    for (int i = 0; i < 10; ++i) solver->step(state, {});
    // The velocity of a frame is that at its end, so the flight itself begins with half of a frame's gravity.
    EXPECT_NEAR(ball().box.y, from + gravity / 2 * 10 + gravity * 100 / 2, 1e-9) << side;
  }
}

TEST(NewLevel, ItHasNoProblems) {
  for (const TileSize tile : {TileSize{8, 8}, TileSize{16, 16}})
    EXPECT_TRUE(lint(new_level(tile, 60, 34, {.plays = true})).empty());
}

TEST(NewLevel, ItsGroundToolAndItsSlopeToolTakeItsTiles) {
  for (const bool in_true_colour : {false, true}) {
    Level level = new_level({8, 8}, 60, 34, {in_true_colour, true});
    const Level blank = level;
    // From the grass, at row 13, four tiles to the right and two up.
    apply_edit(level, lay_slope(level, {35 * 8, 13 * 8}, {39 * 8, 11 * 8}, {1, 1, {0}}, 12).value());
    EXPECT_TRUE(level.sheets == blank.sheets) << "nothing is drawn";
    EXPECT_EQ(level.map.at({35, 12}), 17);
    EXPECT_EQ(level.map.at({36, 12}), 18);
    EXPECT_EQ(level.map.at({37, 11}), 17);
    EXPECT_EQ(level.map.at({38, 11}), 18);
    EXPECT_EQ(level.map.at({37, 12}), 2) << "earth fills the ground";
    EXPECT_EQ(level.map.at({37, 13}), 2) << "and replaces the grass that is covered";
    EXPECT_EQ(level.map.at({34, 13}), 1) << "grass in the open stays";
    apply_edit(level, paint_ground(level, {45, 12}, {50, 12}, GroundChange::add));
    EXPECT_EQ(level.map.at({45, 12}), 17);
    EXPECT_EQ(level.map.at({50, 12}), 20);
    EXPECT_EQ(level.map.at({47, 13}), 2);
    EXPECT_TRUE(lint(level).empty());
  }
}

TEST(NewLevel, BothKindsOfColourLookTheSame) {
  const Level palette = new_level({8, 8}, 60, 34, {false, true});
  const Level true_colour = new_level({8, 8}, 60, 34, {true, true});
  for (TileNumber tile = 1; tile <= 20; ++tile)
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
