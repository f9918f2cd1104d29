// A thread compiles large levels, and the session goes on meanwhile.
#include <gtest/gtest.h>

#include <talus/formats/format.h>
#include "edit/map_stroke.h"
#include "edit/spawn_tools.h"
#include "folder_test.h"
#include "session/session.h"
#include "waiting.h"

namespace talus::session_compile_test {

constexpr int kLargeSide = 400;  // cells

// A floor of the solid tile 1 in every second row, and a ball over the first one.
Level large_level() {
  Level level;
  level.sheet(SheetId::tiles).flags[1] = 1;
  level.map = TileMap(kLargeSide, kLargeSide);
  for (int y = 3; y < kLargeSide; y += 2)
    for (int x = 0; x < kLargeSide; ++x) level.map.set({x, y}, 1);
  level.spawns.push_back({"", {16, 8}, {}, ""});
  return level;
}

void wait_for_scene(Session& session) {
  ASSERT_TRUE(comes_true([&] {
    if (session.compile_progress()) session.advance(0);
    return !session.compile_progress();
  }));
}

action::EditLevel clear_solid_flag() {
  return {Edit{"Clear the flag", {FlagsChange{SheetId::tiles, 1, 1, 0}}}, 0};
}

void expect_scene_of_level(const Session& session) {
  EXPECT_TRUE(session.scene() == compile_scene(session.level()));
}

class SessionCompile : public FolderTest {};

TEST_F(SessionCompile, AnEditOfALargeLevelShowsOnceItIsCompiled) {
  Session session(large_level());
  const Scene* before = &session.scene();
  session.apply(clear_solid_flag());
  ASSERT_TRUE(session.compile_progress());
  EXPECT_EQ(&session.scene(), before) << "still the ground as it was";
  session.apply(action::StepFrame{});
  EXPECT_EQ(session.state().frame, 1) << "which is played on meanwhile";
  wait_for_scene(session);
  expect_scene_of_level(session);
  EXPECT_EQ(session.state().frame, 1);
}

TEST_F(SessionCompile, StrokesMadeMeanwhileAreIncluded) {
  Session session(large_level());
  session.apply(clear_solid_flag());
  session.apply(action::EditLevel{paint_stamp(session.level(), {7, 7}, {1, 1, {5}})});
  session.apply(action::EditLevel{Edit{"Solid", {FlagsChange{SheetId::tiles, 5, 0, 1}}}, 0});
  wait_for_scene(session);
  expect_scene_of_level(session);
  EXPECT_EQ(session.level().map.at({7, 7}), 5);
}

TEST_F(SessionCompile, UndoMeanwhileRestoresTheLevel) {
  Session session(large_level());
  session.apply(clear_solid_flag());
  session.apply(action::Undo{});
  wait_for_scene(session);
  expect_scene_of_level(session);
}

TEST_F(SessionCompile, OnlyNewStacksOfTilesTakeLong) {
  constexpr TileNumber kRising = 2, kFalling = 3;
  Level level = large_level();
  level.tuning.solver = SolverKind::exact;
  level.tile_shapes[kRising] = {.kind = TileShape::Kind::slope, .heights = {0, 8}};
  level.tile_shapes[kFalling] = {.kind = TileShape::Kind::slope, .heights = {8, 0}};
  std::vector<TileNumber> front(level.map.cells().size());
  front[3 * kLargeSide + 9] = front[2 * kLargeSide + 20] = kRising;
  front[2 * kLargeSide + 30] = kFalling;
  level.layers.list.push_back({.name = "front", .cells = std::make_shared<const MapCells>(std::move(front))});
  Session session(level);
  wait_for_scene(session);
  session.apply(action::EditLevel{paint_stamp(session.level(), {20, 2}, {1, 1, {1}})});
  EXPECT_FALSE(session.compile_progress()) << "cell 9,3 has the same tiles";
  session.apply(action::EditLevel{paint_stamp(session.level(), {30, 2}, {1, 1, {1}})});
  EXPECT_TRUE(session.compile_progress()) << "no frame waits for the whole map";
  wait_for_scene(session);
  expect_scene_of_level(session);
}

TEST_F(SessionCompile, TuningAndBodiesNeedNoGround) {
  Session session(large_level());
  Tuning tuning = session.level().tuning;
  tuning.exact.substeps = 3;
  session.apply(action::EditLevel{Edit{"Tune", {TuningChange{session.level().tuning, tuning}}}, 0});
  EXPECT_FALSE(session.compile_progress());
  expect_scene_of_level(session);
  std::vector<Spawn> spawns = session.level().spawns;
  spawns.push_back({"", {64, 8}, {}, ""});
  session.apply(action::EditLevel{Edit{"Add a body", {SpawnsChange{session.level().spawns, spawns}}}, 0});
  EXPECT_FALSE(session.compile_progress());
  expect_scene_of_level(session);
  EXPECT_EQ(session.state().bodies.size(), 2u);
}

TEST_F(SessionCompile, ALargeLevelOpensAtOnceAndPlaysOnceCompiled) {
  const std::string file = path("large.talus.json");
  ASSERT_TRUE(save_level(large_level(), *find_format("native"), file));
  Session session;
  session.apply(action::OpenFile{file});
  session.finish_reading();
  session.apply(action::Play{});
  EXPECT_EQ(session.level(), large_level());
  ASSERT_TRUE(session.compile_progress());
  session.apply(action::StepFrame{});
  EXPECT_EQ(session.state().frame, 0) << "there is nothing to fall on yet";
  wait_for_scene(session);
  expect_scene_of_level(session);
  for (int i = 0; i < 200; ++i) session.apply(action::StepFrame{});
  EXPECT_EQ(session.state().bodies.at(0).box.bottom(), 24) << "on the first floor";
}

TEST_F(SessionCompile, AnotherLevelCancelsTheCompilation) {
  Session session(large_level());
  session.apply(clear_solid_flag());
  session.apply(action::NewLevel{});
  session.apply(action::AnswerQuestion{action::Answer::discard});
  EXPECT_FALSE(session.compile_progress());
  expect_scene_of_level(session);
}

}  // namespace talus::session_compile_test
