// Playback: real time becomes steps; stepping, resetting, dragging, and editing during play.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ball_room.h"
#include "edit/flag_lamps.h"
#include "edit/level_settings.h"
#include "edit/map_rectangle.h"
#include "edit/map_stroke.h"
#include "edit/shape_tools.h"
#include "edit/spawn_tools.h"
#include "session/session.h"

namespace talus::playback_test {

namespace act = action;

constexpr std::uint8_t kPlain = 3, kOtherSolid = 4;
constexpr double kFrame = 1.0 / 60;

// A ball of the article high above a floor: the body is at (16, 8), and the floor's top at 64.
Level ball_over_floor() {
  Level level = ball_room(8);
  level.tuning.solver = SolverKind::article;
  level.sheet(SheetId::tiles).flags[kOtherSolid] = 1 << 0;
  return level;
}

act::EditLevel painted(const Session& session, Cell at, TileNumber tile) {
  return {paint_stamp(session.level(), at, {1, 1, {tile}}), 0};
}

// The state after `steps` steps of a level that is not edited.
State state_after(const Level& level, int steps) {
  State state = initial_state(compile_scene(level));
  for (int i = 0; i < steps; ++i) state = step(compile_scene(level), state, {});
  return state;
}

TEST(Playback, IsAtRestAtFirst) {
  Session session(ball_over_floor());
  session.advance(1);
  EXPECT_FALSE(session.playback().running);
  EXPECT_EQ(session.state(), state_after(session.level(), 0));
  EXPECT_TRUE(session.record().paths.empty());
}

TEST(Playback, MakesSixtyStepsASecond) {
  Session session(ball_over_floor());
  session.apply(act::Play{});
  for (int i = 0; i < 30; ++i) session.advance(kFrame);
  EXPECT_EQ(session.state().frame, 30);
  session.advance(0.5);
  EXPECT_EQ(session.state().frame, 60);
  EXPECT_EQ(session.state(), state_after(session.level(), 60));
}

TEST(Playback, KeepsTimeShorterThanAStep) {
  Session session(ball_over_floor());
  session.apply(act::Play{});
  for (int i = 0; i < 7; ++i) session.advance(kFrame / 2);
  EXPECT_EQ(session.state().frame, 3);
  session.advance(kFrame / 2);
  EXPECT_EQ(session.state().frame, 4);
}

TEST(Playback, SpeedScalesTime) {
  Session session(ball_over_floor());
  session.apply({act::Play{}, act::SetSpeed{0.125}});
  for (int i = 0; i < 7; ++i) session.advance(kFrame);
  EXPECT_EQ(session.state().frame, 0);
  session.advance(kFrame);
  EXPECT_EQ(session.state().frame, 1);
  session.apply(act::SetSpeed{8});
  session.advance(kFrame);
  EXPECT_EQ(session.state().frame, 9);
}

TEST(Playback, SpeedIsClamped) {
  Session session;
  session.apply(act::SetSpeed{100});
  EXPECT_EQ(session.playback().speed, 8);
  session.apply(act::SetSpeed{0});
  EXPECT_EQ(session.playback().speed, 0.125);
  session.apply(act::SetSpeed{std::numeric_limits<double>::quiet_NaN()});
  EXPECT_EQ(session.playback().speed, 0.125);
}

TEST(Playback, DropsTimeThatItCannotCatchUpWith) {
  Session session(ball_over_floor());
  session.apply(act::Play{});
  session.advance(3600);
  EXPECT_EQ(session.state().frame, kMaxCatchUpSteps);
  session.advance(0);
  EXPECT_EQ(session.state().frame, kMaxCatchUpSteps);
}

TEST(Playback, StepFramePausesAndMakesOneStep) {
  Session session(ball_over_floor());
  session.apply(act::Play{});
  session.advance(kFrame * 1.75);
  session.apply(act::StepFrame{});
  EXPECT_FALSE(session.playback().running);
  EXPECT_EQ(session.state().frame, 2);
  session.apply(act::StepFrame{});
  EXPECT_EQ(session.state().frame, 3);
  EXPECT_EQ(session.state(), state_after(session.level(), 3));
}

TEST(Playback, KeysAreHeldAndATapWhileItRunsCountsOnce) {
  Level level;
  level.map = TileMap(30, 17);
  level.spawns.resize(1);
  level.spawns[0].kind = BodyKind::player;
  Session session(level);
  const auto vx = [&] { return session.state().bodies[0].velocity.x; };
  session.apply({act::HoldKeys{.right = true}, act::HoldKeys{}, act::StepFrame{}});
  EXPECT_EQ(vx(), 0);  // paused: only keys that are held now count
  session.apply({act::HoldKeys{.right = true}, act::HoldMouse{{200, 100}, false}, act::StepFrame{}});
  EXPECT_EQ(vx(), level.tuning.player.air_gain);
  session.apply({act::HoldKeys{}, act::ResetPlay{}, act::Play{}});
  session.apply({act::HoldKeys{.left = true}, act::HoldKeys{}});
  session.advance(kFrame);
  EXPECT_EQ(vx(), -level.tuning.player.air_gain);
  const double after_tap = vx();
  session.advance(kFrame);
  EXPECT_GT(vx(), after_tap);
}

TEST(Playback, SelectSpawnChoosesItsBody) {
  Level level = ball_over_floor();
  level.spawns.resize(2);
  Session session(level);
  session.apply(act::SelectSpawn{1});
  ASSERT_NE(session.state().find(session.choices().body), nullptr);
  EXPECT_EQ(session.state().find(session.choices().body)->origin.spawn, 1);
  session.apply(act::SelectSpawn{2});
  EXPECT_EQ(session.choices().body, 0);
  session.apply(act::SelectSpawn{-1});  // a ball of the map has no spawn
  EXPECT_EQ(session.choices().body, 0);
}

TEST(Playback, TogglePauseAndPlay) {
  Session session;
  session.apply(act::TogglePlay{});
  EXPECT_TRUE(session.playback().running);
  session.apply(act::TogglePlay{});
  EXPECT_FALSE(session.playback().running);
  session.apply(act::Play{});
  session.apply(act::Pause{});
  EXPECT_FALSE(session.playback().running);
}

TEST(Playback, ResetGoesBackAndKeepsRunning) {
  Session session(ball_over_floor());
  session.apply(act::Play{});
  session.advance(0.5);
  session.apply(act::ResetPlay{});
  EXPECT_TRUE(session.playback().running);
  EXPECT_EQ(session.state(), state_after(session.level(), 0));
  EXPECT_TRUE(session.record().paths.empty());
}

TEST(Playback, TheRecordDescribesTheLastStep) {
  Session session(ball_over_floor());
  session.apply({act::StepFrame{}, act::StepFrame{}});
  StepRecord expected;
  step(session.scene(), state_after(session.level(), 1), {}, &expected);
  ASSERT_EQ(session.record().paths.size(), 1u);
  EXPECT_EQ(session.record().paths[0].from, expected.paths[0].from);
  EXPECT_EQ(session.record().paths[0].to, session.state().bodies[0].box);
}

TEST(Playback, AnEditTakesEffectInTheNextStep) {
  Session session(ball_over_floor());
  session.apply(act::Play{});
  session.advance(0.25);
  const Body falling = session.state().bodies.at(0);
  ASSERT_EQ(session.state().frame, 15);
  ASSERT_LT(falling.box.bottom(), 64);
  session.apply(painted(session, {2, 6}, kRoomSolid));
  EXPECT_EQ(session.state().frame, 15);
  EXPECT_EQ(session.state().bodies.at(0), falling) << "the body goes on from where it is";
  EXPECT_EQ(session.scene(), compile_scene(session.level()));
  while (session.record().contacts.empty() && session.state().frame < 60) session.advance(kFrame);
  ASSERT_FALSE(session.record().contacts.empty());
  EXPECT_EQ(session.record().contacts[0].other.cell, (Cell{2, 6}))
      << "it lands on the new tile, above the floor";
}

TEST(Playback, AnEditTakesEffectInTheStepOfItsBatch) {
  Session session(ball_over_floor());
  session.apply(act::StepFrame{});
  session.apply({painted(session, {2, 2}, kRoomSolid), act::StepFrame{}});
  EXPECT_EQ(session.record().contacts.at(0).other.cell, (Cell{2, 2}));
}

TEST(Playback, UndoTakesEffectInTheNextStepToo) {
  Session session(ball_over_floor());
  const Scene before = session.scene();
  session.apply(painted(session, {2, 6}, kRoomSolid));
  EXPECT_NE(session.scene(), before);
  session.apply(act::Undo{});
  EXPECT_EQ(session.scene(), before);
  session.apply(act::Redo{});
  EXPECT_NE(session.scene(), before);
}

// An edit without an effect on the physics must not cost a compilation: the scene stays the same object.
TEST(Playback, PicturesAndPlainTilesDoNotRecompile) {
  Session session(ball_over_floor());
  const Scene* before = &session.scene();
  session.apply(act::EditLevel{draw_line(session.level(), {}, {0, 0}, {7, 7}, {3}), 0});
  session.apply(act::EditLevel{set_color(session.level(), 3, {1, 2, 3}), 0});
  session.apply(act::EditLevel{rename_flag(session.level(), 3, "ice"), 0});
  session.apply(painted(session, {9, 2}, kPlain));
  session.apply(painted(session, {9, 8}, kOtherSolid));
  session.apply(act::EditLevel{set_flag(session.level(), {SheetId::sprites, {1, 0, 1, 1}}, 0, true), 0});
  session.apply(act::EditLevel{set_flag(session.level(), {SheetId::tiles, {3, 0, 1, 1}}, 7, true), 0});
  EXPECT_EQ(&session.scene(), before);
  EXPECT_EQ(session.scene(), compile_scene(session.level()));
}

TEST(Playback, EveryEditThatChangesThePhysicsRecompiles) {
  Session session(ball_over_floor());
  const auto expect_recompiled = [&](Edit edit) {
    const Scene before = session.scene();
    session.apply(act::EditLevel{std::move(edit), 0});
    EXPECT_NE(session.scene(), before) << session.history().edits().back().label;
    EXPECT_EQ(session.scene(), compile_scene(session.level()));
  };
  const Level& level = session.level();
  expect_recompiled(paint_stamp(level, {5, 5}, {1, 1, {kRoomSolid}}));
  expect_recompiled(set_flag(level, {SheetId::tiles, {kRoomBall, 0, 1, 1}}, 0, true));
  expect_recompiled(erase_cells(level, {0, 8, 30, 1}));
  expect_recompiled(set_roles(level, {7, 1, 2, 3}));
  expect_recompiled(set_spawns(level, {Spawn{"", {100, 8}, {}, ""}}, "Place a spawn"));
  Tuning tuning = level.tuning;
  tuning.shared.fall_speed = 1;
  expect_recompiled(set_tuning(level, tuning));
  TileMap small(4, 4);
  small.set({1, 1}, kRoomBall);
  expect_recompiled(Edit{"Resize", {MapChange{level.map, small}}});
}

TEST(Playback, ShapesRecompileTheGround) {
  Level level = ball_over_floor();
  level.tuning.solver = SolverKind::exact;
  level.map.set({5, 5}, kPlain);
  Session session(level);
  const auto expect_recompiled = [&](Edit edit) {
    const Scene before = session.scene();
    session.apply(act::EditLevel{std::move(edit), 0});
    const std::string& label = session.history().edits().back().label;
    EXPECT_FALSE(session.scene() == before) << label;
    EXPECT_TRUE(session.scene() == compile_scene(session.level())) << label;
  };
  const TileShape slope{.kind = TileShape::Kind::slope, .heights = {0, 8}};
  expect_recompiled(set_tile_shape(session.level(), kPlain, slope));
  expect_recompiled(paint_stamp(session.level(), {6, 5}, {1, 1, {kPlain}}));
  expect_recompiled(set_tile_shape(session.level(), kPlain, {}));
  session.apply(act::EditLevel{set_flag(session.level(), {SheetId::tiles, {kPlain, 0, 1, 1}}, 6, true), 0});
  expect_recompiled(set_flag_shape(session.level(), 6, slope));
  expect_recompiled(set_flag(session.level(), {SheetId::tiles, {kPlain, 0, 1, 1}}, 6, false));
  expect_recompiled(
      set_curves(session.level(), {{"", {Segment{{0, 0}, {8, 8}}, Curve::Faces::up}, ""}}, "Bend"));
}

TEST(Playback, EditsOfCellsGiveTheSceneOfTheEditedLevel) {
  Level level = ball_over_floor();
  level.tuning.solver = SolverKind::exact;
  Session session(level);
  for (const Cell cell : {Cell{2, 6}, Cell{3, 6}, Cell{2, 2}, Cell{2, 6}}) {
    session.apply(
        painted(session, cell, session.level().map.tile_at(cell) == kRoomSolid ? kPlain : kRoomSolid));
    EXPECT_EQ(session.scene(), compile_scene(session.level()));
    session.apply(act::StepFrame{});
  }
  while (session.history().can_undo()) {
    session.apply(act::Undo{});
    EXPECT_EQ(session.scene(), compile_scene(session.level()));
  }
}

TEST(Playback, AtFrameZeroTheStateFollowsTheEditedLevel) {
  Level level = ball_over_floor();
  level.spawns = {Spawn{"hero", {100, 8}, {}, ""}};
  Session session(level);
  level.spawns[0].position = {120, 16};
  session.apply(act::EditLevel{set_spawns(session.level(), level.spawns, "Move the spawn"), 0});
  EXPECT_EQ(session.state(), initial_state(session.scene()));
  EXPECT_EQ(session.state().bodies.at(1).box.x, 120);
}

TEST(Playback, TheSameBodyStaysChosenAcrossEdits) {
  Session session(ball_over_floor());
  session.apply(act::SelectBody{1});
  EXPECT_EQ(session.choices().body, 1);
  session.apply(painted(session, {1, 1}, kRoomBall));  // this ball is first in map order and gets id 1
  EXPECT_EQ(session.choices().body, 2);
  EXPECT_EQ(session.state().find(2)->origin.cell, (Cell{2, 1}));
  session.apply(act::StepFrame{});
  session.apply(painted(session, {0, 1}, kRoomBall));
  EXPECT_EQ(session.choices().body, 2) << "later edits leave ids alone";
  session.apply(act::ResetPlay{});
  EXPECT_EQ(session.choices().body, 3) << "and a reset numbers them anew";
  session.apply(painted(session, {2, 1}, 0));
  EXPECT_EQ(session.choices().body, 0) << "its tile is gone";
}

TEST(Playback, AMissingBodyCannotBeChosen) {
  Session session(ball_over_floor());
  session.apply(act::SelectBody{7});
  EXPECT_EQ(session.choices().body, 0);
}

TEST(Playback, TheMouseCanDragABall) {
  Session session(ball_over_floor());
  session.apply({act::HoldMouse{{20, 12}, true}, act::StepFrame{}});
  EXPECT_EQ(session.state().grabbed, 1);
  EXPECT_EQ(session.state().bodies[0].box, (Rect{16, 8, 8, 8})) << "held at its centre it does not fall";
  session.apply({act::HoldMouse{{30, 12}, true}, act::StepFrame{}});
  EXPECT_DOUBLE_EQ(session.state().bodies[0].box.x, 19) << "0.3 of the 10 px to the mouse";
  session.apply({act::HoldMouse{{30, 12}, false}, act::StepFrame{}});
  EXPECT_EQ(session.state().grabbed, 0);
  EXPECT_GT(session.state().bodies[0].velocity.x, 2) << "thrown";
}

// Three bodies placed side by side, high above the floor.
Level three_spawns() {
  Level level = ball_over_floor();
  level.map.set({2, 1}, 0);
  for (const double x : {40.0, 80.0, 120.0}) level.spawns.emplace_back().position = {x, 8};
  return level;
}

TEST(Playback, BodiesKeepTheirSpawnsWhenOneIsRemoved) {
  Session session(three_spawns());
  for (int i = 0; i < 5; ++i) session.apply(act::StepFrame{});
  session.apply(act::SelectSpawn{2});
  const State before = session.state();
  session.apply(act::EditLevel{remove_spawn(session.level(), 0)});
  ASSERT_EQ(session.state().bodies.size(), 2u);
  EXPECT_EQ(session.state().bodies[0].box, before.bodies[1].box);
  EXPECT_EQ(session.state().bodies[1].box, before.bodies[2].box);
  EXPECT_EQ(session.state().bodies[1].id, 3);
  EXPECT_EQ(session.choices().body, 3) << "the same body stays chosen";
  session.apply(act::Undo{});
  ASSERT_EQ(session.state().bodies.size(), 3u);
  EXPECT_EQ(session.state().find(2)->box, before.bodies[1].box);
  EXPECT_EQ(session.state().find(3)->box, before.bodies[2].box);
  EXPECT_EQ(session.state().find(4)->box, (Rect{40, 8, 8, 8})) << "the one that came back starts anew";
}

TEST(Playback, TheChosenBodyStaysChosenAtFrameZero) {
  Session session(three_spawns());
  session.apply(act::SelectSpawn{2});
  session.apply(act::EditLevel{remove_spawn(session.level(), 0)});
  ASSERT_EQ(session.choices().body, 2);
  EXPECT_EQ(session.state().find(2)->box.x, 120);
}

}  // namespace talus::playback_test
