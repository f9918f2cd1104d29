// Where a player can get to: marked cells are reached by the keys that are given, and walls that are too high
// stop the player.
#include "sim/reach.h"

#include <gtest/gtest.h>

#include "overlay/reach_drawing.h"
#include "session/session.h"
#include "slope_level.h"

namespace talus::reach_test {

// A player to the left of a wall, and a separate room behind it.
Level walled_level(int wall) {
  std::vector<std::string> rows(12, "..............");
  rows.push_back("##############");
  for (int i = 0; i < wall; ++i) rows[static_cast<std::size_t>(11 - i)][7] = '#';
  Level level = slope_level(rows);
  level.spawns = {{"", {16, 88}, {}, "", BodyKind::player, {8, 8}}};
  return level;
}

ReachSearch search_of(const Level& level, ReachOptions options = {}) {
  const Scene scene = compile_scene(level);
  return ReachSearch(scene, initial_state(scene).bodies.at(0), options);
}

TEST(Reach, AJumpGetsOverALowWallOnly) {
  ReachSearch low = search_of(walled_level(3));
  while (!low.advance(1000)) {
  }
  EXPECT_TRUE(low.reached({7, 8}));
  EXPECT_TRUE(low.stood_at({7, 8}));
  EXPECT_TRUE(low.stood_at({13, 11}));
  EXPECT_FALSE(low.reached({7, 9}));  // the wall itself
  EXPECT_FALSE(low.is_full());

  ReachSearch high = search_of(walled_level(5));
  while (!high.advance(1000)) {
  }
  EXPECT_TRUE(high.stood_at({0, 11}));
  EXPECT_TRUE(high.reached({6, 8}));    // in the air, in front of the wall
  EXPECT_FALSE(high.stood_at({6, 8}));  // in the air
  for (int x = 8; x < 14; ++x) EXPECT_FALSE(high.reached({x, 11})) << x;
}

TEST(Reach, TheInputLeadsToTheCell) {
  const Level level = walled_level(3);
  ReachSearch reach = search_of(level);
  while (!reach.advance(1000)) {
  }
  const auto scene = std::make_shared<const Scene>(compile_scene(level));
  for (const Cell cell : {Cell{7, 8}, Cell{13, 11}, Cell{0, 9}}) {
    State state = initial_state(*scene);
    const std::vector<Input> way = reach.way_to(cell);
    ASSERT_FALSE(way.empty());
    for (const Input& input : way) state = step(*scene, state, input);
    const Rect box = state.bodies[0].box;
    EXPECT_TRUE(box.x < cell.x * 8 + 8 && box.right() > cell.x * 8 && box.y < cell.y * 8 + 8 &&
                box.bottom() > cell.y * 8)
        << cell.x << ", " << cell.y;
  }
  EXPECT_TRUE(reach.way_to({2, 11}).empty());  // the cell of the start
  EXPECT_TRUE(reach.way_to({7, 9}).empty());
  EXPECT_TRUE(reach.way_to({-7, 12}).empty());
  EXPECT_FALSE(reach.reached({-7, 12}));
}

TEST(Reach, SearchingInSlicesGivesTheSame) {
  ReachSearch whole = search_of(walled_level(3)), sliced = search_of(walled_level(3));
  while (!whole.advance(100'000)) {
  }
  while (!sliced.advance(7)) {
  }
  EXPECT_EQ(whole.known(), sliced.known());
  EXPECT_EQ(whole.cells(), sliced.cells());
  EXPECT_EQ(whole.way_to({13, 11}), sliced.way_to({13, 11}));
  EXPECT_EQ(whole.frames(), sliced.frames());
}

TEST(Reach, TheLimitOfStatesEndsTheSearch) {
  ReachSearch reach = search_of(walled_level(3), {.most_states = 50});
  EXPECT_TRUE(reach.advance(100'000));
  EXPECT_TRUE(reach.is_full());
  EXPECT_EQ(reach.known(), 50u);
}

TEST(Reach, IsDrawnAsBoxesOfItsCells) {
  ReachSearch reach = search_of(walled_level(3));
  while (!reach.advance(1000)) {
  }
  OverlayDrawing all, stale, left;
  add_reach(reach, false, TileMap(14, 13), {0, 0, 112, 104}, all);
  double area = 0;
  for (const OverlayBox& box : all.boxes) {
    area += box.box.w * box.box.h;
    EXPECT_TRUE(box.filled);
  }
  EXPECT_EQ(area, 64.0 * static_cast<double>(reach.cells()));
  EXPECT_FALSE(all.lines.empty());
  add_reach(reach, true, TileMap(14, 13), {0, 0, 112, 104}, stale);
  ASSERT_EQ(stale.boxes.size(), all.boxes.size());
  EXPECT_FALSE(stale.boxes[0].filled);
  add_reach(reach, false, TileMap(14, 13), {-50, 0, 60, 104}, left);
  for (const OverlayBox& box : left.boxes) EXPECT_LE(box.box.right(), 24);
}

TEST(Reach, TheSessionSearchesAndPlaysTheInput) {
  Session session(walled_level(3));
  session.apply(action::FindReach{});
  EXPECT_TRUE(session.choices().overlays.has(overlay::reach));
  EXPECT_TRUE(session.reach().running());
  for (int i = 0; i < 4000 && session.reach().running(); ++i) session.advance(0);
  ASSERT_TRUE(session.reach().found()->finished());
  EXPECT_EQ(session.reach().others(), 0);
  const std::size_t frames = session.reach().found()->way_to({13, 11}).size();
  session.apply(action::ShowWay{{13, 11}});
  EXPECT_EQ(session.state().frame, static_cast<std::int64_t>(frames));
  EXPECT_GT(session.state().bodies[0].box.right(), 13 * 8);
  session.apply(action::ShowWay{{7, 9}});  // not reached
  EXPECT_EQ(session.state().frame, static_cast<std::int64_t>(frames));

  session.apply(action::EditLevel{{"Paint", {CellChange{{3, 3}, 0, kSolidSign}}}});
  EXPECT_TRUE(session.reach().is_stale());
  session.apply(action::NewLevel{});
  session.apply(action::AnswerQuestion{action::Answer::discard});
  EXPECT_EQ(session.reach().found(), nullptr);
}

TEST(Reach, ASearchCanBeStopped) {
  Session session(walled_level(3));
  session.apply(action::FindReach{});
  session.apply(action::CancelReach{});
  session.advance(0);
  EXPECT_FALSE(session.reach().running());
  EXPECT_EQ(session.reach().found()->followed(), 0u);
  EXPECT_TRUE(session.reach().found()->reached({2, 11}));
}

TEST(Reach, WithoutAPlayerTheSearchIsAnError) {
  Level level = walled_level(3);
  level.spawns[0].kind = BodyKind::ball;
  Session balls(level);
  balls.apply(action::FindReach{});
  ASSERT_TRUE(balls.message());
  EXPECT_EQ(balls.message()->text,
            "No player to follow: place a body with the body tool, and make it a player in the inspector.");
  EXPECT_EQ(balls.reach().found(), nullptr);

  level = walled_level(3);
  level.tuning.solver = SolverKind::bump;
  Session bump(level);
  bump.apply(action::FindReach{});
  EXPECT_EQ(bump.message()->text,
            "Only the exact solver has players: choose it in Tuning to see where one gets to.");
}

}  // namespace talus::reach_test
