// The stages of a step, and the trace of a cast that they show.
#include "debug/stages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include <talus/sim/solver.h>

namespace talus::debug_stages_test {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Not;

// A floor in row 11, a slope of 8x8 px on it in column 5, and a wall from column 6 on.
Level level_with_a_slope(SolverKind solver) {
  Level level;
  level.tuning.solver = solver;
  level.map = TileMap(12, 12);
  level.tile_shapes[1].kind = TileShape::Kind::solid;
  level.tile_shapes[2] = {.kind = TileShape::Kind::slope, .heights = {0, 8}};
  for (int x = 0; x < 12; ++x) level.map.set({x, 11}, 1);
  level.map.set({5, 10}, 2);
  for (int x = 6; x < 12; ++x) level.map.set({x, 10}, 1);
  return level;
}

void place(Level& level, Vec2 position, Vec2 velocity, BodyKind kind = BodyKind::ball) {
  Spawn& spawn = level.spawns.emplace_back();
  spawn.position = position;
  spawn.velocity = velocity;
  spawn.kind = kind;
}

Frame frame_after(const Level& level, int steps) {
  Frame frame;
  frame.scene = std::make_shared<const Scene>(compile_scene(level));
  frame.ground = measured_ground(*frame.scene, level);
  frame.state = initial_state(*frame.scene);
  const auto solver = make_solver(frame.scene);
  for (int i = 0; i < steps; ++i) solver->step(frame.state, {}, &frame.record);
  return frame;
}

std::vector<StageKind> kinds(const std::vector<Stage>& stages) {
  std::vector<StageKind> kinds;
  for (const Stage& stage : stages) kinds.push_back(stage.kind);
  return kinds;
}

TEST(CastTrace, ListsTestedCellsAndSidesAndTheFirstContact) {
  const Level level = level_with_a_slope(SolverKind::exact);
  const Scene scene = compile_scene(level);
  const Cast<double> cast{{10, 76, 8, 8}, {0, 6}, Foot::box};
  const CastTrace trace = trace_cast(*scene.ground, cast);
  const Contact<double> contact = cast_box(*scene.ground, cast);
  EXPECT_EQ(trace.contact.t, contact.t);
  EXPECT_EQ(trace.contact.position, contact.position);
  EXPECT_THAT(trace.cells, Contains(Cell{1, 11}));
  EXPECT_THAT(trace.cells, Contains(Cell{2, 11}));
  const auto firsts = std::count_if(trace.candidates.begin(), trace.candidates.end(),
                                    [](const CastCandidate& c) { return c.is_first; });
  ASSERT_EQ(firsts, 1);
  const auto first = std::find_if(trace.candidates.begin(), trace.candidates.end(),
                                  [](const CastCandidate& c) { return c.is_first; });
  EXPECT_EQ(first->t, 4.0 / 6);
  EXPECT_EQ(first->facing, Facing::up);
  EXPECT_EQ(first->from.y, 88);
  EXPECT_EQ(first->to.y, 88);
}

TEST(CastTrace, AMotionThroughAirHasNoFirstContact) {
  const Level level = level_with_a_slope(SolverKind::exact);
  const CastTrace trace = trace_cast(*compile_scene(level).ground, {{10, 10, 8, 8}, {3, 2}, Foot::box});
  EXPECT_FALSE(trace.contact);
  EXPECT_FALSE(trace.cells.empty());
  EXPECT_TRUE(trace.candidates.empty());
}

// A foot in the middle is cast a second time, as a line in the middle of the box.
TEST(CastTrace, OfACentreFootHasOneFirstContact) {
  const Level level = level_with_a_slope(SolverKind::exact);
  const Scene scene = compile_scene(level);
  int met = 0;
  for (double x = 26; x <= 46; x += 1) {
    for (const Vec2 motion : {Vec2{12, 0}, Vec2{12, 6}, Vec2{0, 20}, Vec2{12, -6}}) {
      const Cast<double> cast{{x, 77, 8, 8}, motion, Foot::centre};
      const CastTrace trace = trace_cast(*scene.ground, cast);
      EXPECT_EQ(trace.contact.t, cast_box(*scene.ground, cast).t);
      if (!trace.contact) continue;
      ++met;
      int firsts = 0;
      for (const CastCandidate& candidate : trace.candidates) {
        if (!candidate.is_first) continue;
        ++firsts;
        EXPECT_EQ(candidate.t, trace.contact.t) << x << " by " << motion.x << ", " << motion.y;
      }
      EXPECT_EQ(firsts, 1) << x << " by " << motion.x << ", " << motion.y;
    }
  }
  EXPECT_GT(met, 20);
}

// The ball falls 4 px in two parts. The floor is 1 px below, so 1 px of the first part is left, and slides.
TEST(Stages, OfAStepInPartsShowTheRestOfEachPart) {
  Level level = level_with_a_slope(SolverKind::exact);
  level.tuning.exact.substeps = 2;
  level.tuning.exact.rebound = 0;
  place(level, {10, 79}, {2, 4});
  const Frame frame = frame_after(level, 1);
  ASSERT_FALSE(frame.record.contacts.empty());
  const ContactRecord& contact = frame.record.contacts[0];
  ASSERT_TRUE(contact.after);
  EXPECT_EQ(contact.after->y, 0);
  EXPECT_NEAR(contact.after->x, contact.move.x * (1 - contact.ti), 1e-12);
  const std::vector<Stage> stages = stages_of(frame, 1);
  const auto met = std::find_if(stages.begin(), stages.end(),
                                [](const Stage& stage) { return stage.kind == StageKind::met; });
  ASSERT_NE(met, stages.end());
  EXPECT_THAT(met->sentence, testing::HasSubstr(" of a part of the step; of "));
  EXPECT_THAT(met->sentence, testing::HasSubstr(" px slid to the right"));
  const auto on =
      std::find_if(met, stages.end(), [](const Stage& stage) { return stage.kind == StageKind::went_on; });
  ASSERT_NE(on, stages.end());
  EXPECT_EQ(on->motion, *contact.after);
}

// The ball is 3 px above the floor: the first part meets nothing.
TEST(Stages, OfALaterPartBeginWithThatPart) {
  Level level = level_with_a_slope(SolverKind::exact);
  level.tuning.exact.substeps = 2;
  level.tuning.exact.gravity = 0;
  level.tuning.shared.fall_blend = 0;
  place(level, {10, 77}, {0, 4});
  const std::vector<Stage> stages = stages_of(frame_after(level, 1), 1);
  ASSERT_GT(stages.size(), 2u);
  ASSERT_EQ(stages[1].kind, StageKind::searched);
  EXPECT_EQ(stages[1].box, (Rect{10, 79, 8, 8}));
}

TEST(Stages, OfABallOnASlopeShowItPutOnTheFloor) {
  Level level = level_with_a_slope(SolverKind::article);
  place(level, {40, 68}, {0, 2});
  int placed = 0;
  for (int steps = 1; steps < 40; ++steps) {
    const Frame frame = frame_after(level, steps);
    for (const Stage& stage : stages_of(frame, 1)) {
      if (stage.kind != StageKind::placed || !stage.sentence.starts_with("put on the slope's floor"))
        continue;
      ++placed;
      const ContactRecord& contact = frame.record.contacts[static_cast<std::size_t>(stage.contact)];
      EXPECT_EQ(stage.box.position(), (Vec2{frame.record.paths[0].to.x, contact.slope->placed_y}));
    }
  }
  EXPECT_GT(placed, 0);
}

TEST(Stages, OfAFallGoFromTheWishToTheEnd) {
  Level level = level_with_a_slope(SolverKind::exact);
  place(level, {10, 79}, {0, 4});
  const Frame frame = frame_after(level, 1);
  const std::vector<Stage> stages = stages_of(frame, 1);
  ASSERT_THAT(kinds(stages), ElementsAre(StageKind::wanted, StageKind::searched, StageKind::met,
                                         StageKind::placed, StageKind::arrived));
  EXPECT_EQ(stages[0].box, (Rect{10, 79, 8, 8}));
  EXPECT_EQ(stages[0].motion, frame.record.paths[0].goal - (Vec2{10, 79}));
  const auto first = std::find_if(stages[1].candidates.begin(), stages[1].candidates.end(),
                                  [](const CastCandidate& c) { return c.is_first; });
  ASSERT_NE(first, stages[1].candidates.end());
  EXPECT_EQ(first->t, frame.record.contacts[0].ti);
  EXPECT_EQ(stages[2].contact, 0);
  EXPECT_NE(stages[2].sentence.find("stopped by the top of the tile"), std::string::npos)
      << stages[2].sentence;
  EXPECT_EQ(stages[3].box.y, 80);
  EXPECT_EQ(stages[4].box, frame.state.bodies[0].box);
}

TEST(Stages, OfAWalkerShowTheSnapToALowerFloor) {
  Level level = level_with_a_slope(SolverKind::exact);
  level.tile_shapes[3] = {.kind = TileShape::Kind::slope, .heights = {6, 6}};  // 2 px below the wall's top
  level.map.set({5, 10}, 3);
  place(level, {56, 72}, {}, BodyKind::player);
  Frame frame = frame_after(level, 4);
  const auto solver = make_solver(frame.scene);
  std::vector<StageKind> seen;
  for (int i = 0; i < 16; ++i) {
    Input input;
    input.left = true;
    solver->step(frame.state, input, &frame.record);
    for (const Stage& stage : stages_of(frame, 1)) {
      seen.push_back(stage.kind);
      if (stage.kind != StageKind::snapped) continue;
      EXPECT_EQ(stage.box.position() + stage.motion, frame.state.bodies[0].box.position());
      EXPECT_EQ(frame.state.bodies[0].box.bottom(), 82);
    }
  }
  EXPECT_THAT(seen, Contains(StageKind::snapped));
}

TEST(Stages, OfAWalkerOverACrestTurnWithTheFloor) {
  Level level = level_with_a_slope(SolverKind::exact);
  place(level, {44, 72}, {}, BodyKind::player);
  Frame frame = frame_after(level, 4);
  const auto solver = make_solver(frame.scene);
  int turns = 0;
  for (int i = 0; i < 30; ++i) {
    Input input;
    input.left = true;
    solver->step(frame.state, input, &frame.record);
    for (const ContactRecord& contact : frame.record.contacts)
      turns += contact.ti == 0 && contact.after ? 1 : 0;
    EXPECT_THAT(kinds(stages_of(frame, 1)), Not(Contains(StageKind::snapped)));
    EXPECT_TRUE(frame.state.bodies[0].gait.grounded);
  }
  EXPECT_GT(turns, 0);
}

TEST(Stages, OfWorldListEachTestedBoxOnce) {
  Level level = level_with_a_slope(SolverKind::bump);
  place(level, {10, 79}, {0, 4});
  const Frame frame = frame_after(level, 1);
  const std::vector<Stage> stages = stages_of(frame, 1);
  EXPECT_EQ(std::count_if(stages.begin(), stages.end(),
                          [](const Stage& s) { return s.kind == StageKind::searched; }),
            1);
  const auto floor = std::find_if(stages[1].tested.begin(), stages[1].tested.end(), [](const Obstacle& o) {
    return o.cell == Cell{1, 11};
  });
  ASSERT_NE(floor, stages[1].tested.end());
  EXPECT_EQ(floor->box, (Rect{8, 88, 8, 8}));
  EXPECT_THAT(stages[1].sentence, testing::StartsWith("tested the "));
  EXPECT_THAT(stages[1].sentence, testing::HasSubstr("the tile at (1, 11)"));
  EXPECT_EQ(stages.back().box, frame.state.bodies[0].box);
}

// Body 2 hangs 1 px below body 1. Its number alone would put it 40 px away.
TEST(Stages, OfWorldListTestedBodiesAtTheirPlaces) {
  Level level = level_with_a_slope(SolverKind::article);
  level.sheet(SheetId::tiles).flags[3] = 1 << 1;
  level.map.set({1, 2}, 3);
  level.map.set({1, 8}, 3);
  Frame frame = frame_after(level, 40);
  const std::vector<Stage> stages = stages_of(frame, 1);
  ASSERT_GT(stages.size(), 1u);
  const auto& tested = stages[1].tested;
  const auto other =
      std::find_if(tested.begin(), tested.end(), [](const Obstacle& o) { return o.body == 2; });
  ASSERT_NE(other, tested.end()) << stages[1].sentence;
  EXPECT_EQ(other->box, frame.state.bodies[1].box);
  EXPECT_NE(other->box.y, 64) << "it has moved";
  EXPECT_THAT(stages[1].sentence, testing::HasSubstr("body 2"));
}

// A ball flies into another ball in the air: no side of the ground is near.
TEST(Stages, OfExactListBodiesAmongTheCandidates) {
  Level level = level_with_a_slope(SolverKind::exact);
  level.tuning.exact.gravity = 0;
  level.tuning.shared.fall_blend = 0;
  place(level, {10, 20}, {6, 0});
  place(level, {21, 20}, {0, 0});
  place(level, {60, 20}, {0, 0});
  const Frame frame = frame_after(level, 1);
  ASSERT_FALSE(frame.record.contacts.empty());
  ASSERT_EQ(frame.record.contacts[0].other.body, 2);
  const std::vector<Stage> stages = stages_of(frame, 1);
  ASSERT_EQ(stages[1].kind, StageKind::searched);
  ASSERT_EQ(stages[1].tested.size(), 1u) << "the third is far away";
  EXPECT_EQ(stages[1].tested[0].body, 2);
  EXPECT_EQ(stages[1].tested[0].box, (Rect{21, 20, 8, 8}));
  EXPECT_THAT(stages[1].sentence, testing::EndsWith("; tested body 2"));
  for (const CastCandidate& candidate : stages[1].candidates) EXPECT_FALSE(candidate.is_first);
}

// The ball came to rest on the slope. The rest of its motion is rounding and is not shown.
TEST(Stages, LeaveOutAMotionThatIsTooSmallToBeSeen) {
  Frame frame = frame_after(level_with_a_slope(SolverKind::article), 0);
  Body& body = frame.state.bodies.emplace_back();
  body.id = 1;
  body.box = {10, 80, 8, 8};
  frame.record.paths = {{.body = 1, .from = {10, 80, 8, 8}, .goal = {10 - 1e-9, 80.2}, .to = body.box}};
  ContactRecord& contact = frame.record.contacts.emplace_back();
  contact.body = 1;
  contact.other.cell = {1, 11};
  contact.move = {-1e-9, 0.2};
  contact.normal = {0, -1};
  contact.touch = {10, 80};
  contact.handled = true;
  frame.record.paths[0].to.x -= 1e-9;
  const std::vector<Stage> stages = stages_of(frame, 1);
  EXPECT_THAT(kinds(stages), ElementsAre(StageKind::wanted, StageKind::searched, StageKind::met,
                                         StageKind::placed, StageKind::arrived));
  EXPECT_EQ(stages[0].sentence, "wants to go (0, 0.2) px");
  EXPECT_EQ(stages[2].sentence,
            "stopped by the top of the tile at (1, 11) at once; 0.2 px of remaining motion went into it and "
            "is lost");
}

TEST(Stages, AreEmptyAtFrameZeroAndWithoutABody) {
  Level level = level_with_a_slope(SolverKind::exact);
  place(level, {10, 79}, {});
  EXPECT_TRUE(stages_of(frame_after(level, 0), 1).empty());
  EXPECT_TRUE(stages_of(frame_after(level, 1), 7).empty());
}

}  // namespace talus::debug_stages_test
