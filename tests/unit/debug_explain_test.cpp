// Sentences about what happened in a step.
#include "debug/explain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "debug/number_text.h"
#include "level_picture.h"
#include "recorded_frames.h"

namespace talus::debug_explain_test {

// A handmade step of body 1 of 8x8 px, by the exact solver.
class Sentences : public testing::Test {
 protected:
  Sentences() {
    scene_->tuning.solver = SolverKind::exact;
    frame_.scene = scene_;
    frame_.state = state_of({body_at(1, 0, 0)});
  }
  // Sets a step from (10, 20) that wanted to move by `wanted` and ended at `to`.
  void step(Vec2 wanted, Vec2 to) {
    frame_.record.paths = {
        {.body = 1, .from = {10, 20, 8, 8}, .goal = Vec2{10, 20} + wanted, .to = {to.x, to.y, 8, 8}}};
  }
  ContactRecord& contact(Obstacle other, Vec2 normal, double ti, Vec2 move, Vec2 touch) {
    ContactRecord& made = frame_.record.contacts.emplace_back();
    made.body = 1;
    made.order = static_cast<int>(frame_.record.contacts.size()) - 1;
    made.other = other;
    made.normal = normal;
    made.ti = ti;
    made.move = move;
    made.touch = touch;
    made.handled = true;
    return made;
  }
  std::string sentence(std::size_t index = 0) const { return explain_contact(frame_, index).sentence; }
  std::string numbers(std::size_t index = 0) const { return explain_contact(frame_, index).numbers; }

  const Obstacle tile_{.role = TileRole::solid, .cell = {12, 9}, .body = 0, .box = {96, 72, 8, 8}};
  const Obstacle slope_{.role = TileRole::up_slope, .cell = {3, 4}, .body = 0, .box = {24, 32, 16, 8}};
  const std::shared_ptr<Scene> scene_ = std::make_shared<Scene>();
  Frame frame_;
};

TEST_F(Sentences, TellOfAWallThatABodySlidesAlong) {
  step({4, 3}, {11.48, 23});
  contact(tile_, {-1, 0}, 0.37, {4, 3}, {11.48, 21.11});
  EXPECT_EQ(sentence(),
            "stopped by the left side of the tile at (12, 9) at 0.37 of the step; of 3.15 px of "
            "remaining motion 1.89 px slid down");
  EXPECT_EQ(numbers(), "normal (-1, 0)");
}

TEST_F(Sentences, TellOfAFloorThatStopsTheBody) {
  step({0, 4}, {10, 21});
  contact(tile_, {0, -1}, 0.25, {0, 4}, {10, 21});
  EXPECT_EQ(
      sentence(),
      "stopped by the top of the tile at (12, 9) at 0.25 of the step; 3 px of remaining motion went into "
      "it and is lost");
  EXPECT_EQ(numbers(), "normal (0, -1), floor at y 29");
}

TEST_F(Sentences, TellOfASlope) {
  step({2, 2}, {12, 20});
  ContactRecord& met = contact(slope_, {-0.6, -0.8}, 0, {2, 2}, {10, 20});
  met.slope = SlopeProbe{slope_, 0.4375, 28, 20, {-0.6, -0.8}, true};
  EXPECT_EQ(
      sentence(),
      "stopped by the up-slope at (3, 4) at once; of 2.83 px of remaining motion 2 px slid to the right");
  EXPECT_EQ(numbers(), "normal (-0.6, -0.8), slope delta 0.44, floor at y 28");
}

TEST_F(Sentences, TellOfABounce) {
  scene_->tuning.exact.rebound = 1;
  step({0, 4}, {10, 19});
  contact({.role = TileRole::ball, .cell = {}, .body = 3, .box = {}}, {0, -1}, 0.5, {0, 4}, {10, 22});
  EXPECT_EQ(sentence(),
            "stopped by the top of body 3 at 0.5 of the step; it bounced off and went on 3 px up");
}

TEST_F(Sentences, LeaveRoundingOut) {
  step({4, 0}, {10, 20});
  contact(tile_, {-1, 0}, 2e-14, {4, 0}, {10, 20});
  EXPECT_EQ(sentence(),
            "stopped by the left side of the tile at (12, 9) at once; 4 px of remaining motion went into it "
            "and is lost");
  frame_.record.contacts[0].ti = 0.999;
  EXPECT_EQ(sentence(), "stopped by the left side of the tile at (12, 9) at the end of the step")
      << "0.004 px";
}

TEST_F(Sentences, TellOfTheContactsAfterTheFirst) {
  step({4, 4}, {12, 22});
  contact(tile_, {-1, 0}, 0.5, {4, 4}, {12, 22});
  contact({.role = TileRole::solid, .cell = {}, .body = 0, .box = {}, .curve = 2}, {0, -1}, 0.25, {0, 2},
          {12, 22.5});
  contact(slope_, {0.6, 0.8}, 1, {0, 1}, {12, 22});
  EXPECT_EQ(
      sentence(0),
      "stopped by the left side of the tile at (12, 9) at 0.5 of the step; of 2.83 px of remaining motion "
      "2 px slid down");
  EXPECT_EQ(sentence(1),
            "stopped by the top of curve 2 at 0.25 of the remaining motion; of 1.5 px of remaining motion 1 "
            "px slid "
            "down");
  EXPECT_EQ(sentence(2), "stopped by the sloped ceiling at (3, 4) at the end of the remaining motion");
}

TEST_F(Sentences, NameACurveByItsName) {
  const auto met = [this](const char* expected) {
    frame_.record.contacts.clear();
    contact({.role = TileRole::solid, .cell = {}, .body = 0, .box = {}, .curve = 1}, {0, -1}, 0.25, {0, 4},
            {10, 21});
    EXPECT_EQ(sentence().substr(0, sentence().find(" at 0.25")), expected);
  };
  step({0, 4}, {10, 21});
  scene_->curve_names = {"", "hill"};
  met("stopped by the top of curve \"hill\"");
  scene_->curve_names = {"hill", ""};
  met("stopped by the top of curve 1");
}

TEST(SceneCurveNames, MatchTheCurvesOfTheGround) {
  Level level = level_of({"....", "...."});
  const auto curve = [](const char* name, double x1) {
    return LevelCurve{.name = name, .curve = {.form = Segment{{0, 8}, {x1, 8}}}, .extra = {}};
  };
  level.curves = {curve("floor", 8), curve("off the map", 80), curve("ledge", 16)};
  level.tuning.solver = SolverKind::exact;
  EXPECT_EQ(compile_scene(level).curve_names, (std::vector<std::string>{"floor", "ledge"}));
}

TEST_F(Sentences, TellOfTheArticlesSlopes) {
  scene_->tuning.solver = SolverKind::article;
  step({2, 2}, {12, 20});
  ContactRecord& met = contact(slope_, {-1, 0}, 0.5, {2, 2}, {11, 21});
  met.response = Response::cross;
  EXPECT_EQ(sentence(),
            "came into the box of the up-slope at (3, 4) at 0.5 of the step; it moved up, or no slope was "
            "straight below it, so it was left as it was");
  met.slope = SlopeProbe{slope_, 0.4375, 28.4, 20, {-0.6, -0.8}, true};
  EXPECT_EQ(sentence(),
            "came into the box of the up-slope at (3, 4) at 0.5 of the step; under its centre the floor of "
            "the up-slope at (3, 4) is at y 28.4, so its top was put at y 20");
  EXPECT_EQ(numbers(), "normal (-0.6, -0.8), slope delta 0.44, floor at y 28.4");
  met.slope->corrected = false;
  EXPECT_EQ(sentence(),
            "came into the box of the up-slope at (3, 4) at 0.5 of the step; under its centre the floor of "
            "the up-slope at (3, 4) is at y 28.4, and its top was above y 20 already, so it was left as it "
            "was");
  met.handled = false;
  EXPECT_EQ(sentence(),
            "came into the box of the up-slope at (3, 4) at 0.5 of the step; another slope had already put "
            "the body on its floor");
}

TEST_F(Sentences, TellOfOverlaps) {
  scene_->tuning.solver = SolverKind::bump;
  step({1, 0}, {9, 20});
  ContactRecord& met = contact(tile_, {-1, 0}, -12, {1, 0}, {9, 20});
  met.overlaps = true;
  EXPECT_EQ(sentence(), "was inside the tile at (12, 9) from the start and was put out of it to the left");
  ContactRecord& passed = contact(slope_, {}, 0.2, {1, 0}, {9, 20});
  passed.response = Response::cross;
  passed.handled = false;
  EXPECT_EQ(sentence(1), "passed above the floor of the up-slope at (3, 4)");
  EXPECT_EQ(numbers(1), "no normal");
}

// Real steps, as the solvers record them.
class Steps : public testing::Test {
 protected:
  // The explanation of a step of the article's body 1 with these contacts.
  static std::string told(std::vector<ContactRecord> contacts, Vec2 to) {
    MadeFrames made({state_of({body_at(1, 10, 20)}), state_of({body_at(1, to.x, to.y)})});
    auto scene = std::make_shared<Scene>();
    scene->tuning.solver = SolverKind::article;
    Frame& frame = made.frames[1];
    frame.scene = scene;
    frame.record.paths = {{.body = 1, .from = {10, 20, 8, 8}, .goal = {12, 20}, .to = {to.x, to.y, 8, 8}}};
    for (ContactRecord& contact : contacts) contact.body = 1;
    frame.record.contacts = std::move(contacts);
    FrameHistory history(1);
    history.go_to(made, 1);
    return explain_step(history.view(), 1);
  }
  static ContactRecord crossed_slope(bool corrected) {
    ContactRecord made;
    made.other = {.role = TileRole::up_slope, .cell = {3, 4}, .body = 0, .box = {24, 32, 16, 8}};
    made.response = Response::cross;
    made.ti = 0.5;
    made.move = {2, 0};
    made.touch = {11, 20};
    made.handled = true;
    made.slope = SlopeProbe{made.other, 0.5, 28, 20, {-0.6, -0.8}, corrected};
    return made;
  }
  static std::string step(const RecordedFrames& recorded, std::int64_t frame) {
    FrameHistory history(1);
    history.go_to(recorded, frame);
    return explain_step(history.view(), 1);
  }
  static Level falling(SolverKind solver) {
    Level level = level_of({"o..", "...", "###"});
    level.tuning.solver = solver;
    level.tuning.shared.fall_blend = 1;
    level.tuning.shared.floor_bounce = 0.5;
    return level;
  }
};

TEST_F(Steps, TellOfAFreeFallAndALanding) {
  const RecordedFrames recorded(falling(SolverKind::exact), 2);
  EXPECT_EQ(step(recorded, 0), "");
  EXPECT_EQ(step(recorded, 1),
            "Body 1 wanted to go (0, 5) px and did. It met nothing. Its velocity went from (0, 0) to (0, "
            "5) px/frame.");
  EXPECT_EQ(step(recorded, 2),
            "Body 1 wanted to go (0, 5) px and went (0, 3) px. It was stopped by the top of the tile at "
            "(0, 2) at 0.6 of the step; 2 px of remaining motion went into it and is lost. Its velocity went "
            "from (0, 5) to (0, -2.5) px/frame.");
  FrameHistory history(1);
  history.go_to(recorded, 2);
  EXPECT_EQ(explain_step(history.view(), 2), "") << "no such body";
}

TEST_F(Steps, AreExplainedAlikeForEverySolver) {
  for (const SolverKind solver : solver_kinds()) {
    const RecordedFrames recorded(falling(solver), 2);
    EXPECT_EQ(step(recorded, 2), step(RecordedFrames(falling(SolverKind::exact), 2), 2))
        << solver_name(solver);
  }
}

TEST_F(Steps, TellOfAStartInsideTheGround) {
  Level level = level_of({"...", "...", "###"});
  level.tuning.solver = SolverKind::exact;
  level.spawns.push_back({.name = "", .position = {0, 9}, .velocity = {}, .extra = ""});
  const std::string text = step(RecordedFrames(level, 1), 1);
  EXPECT_NE(
      text.find(" It began inside the ground, and was first put out of it. It was stopped by the top of"),
      std::string::npos)
      << text;
}

TEST_F(Steps, TellOfAPlayerBetweenTwoSteepSides) {
  Level level;
  level.map = TileMap(30, 20);
  level.tuning.solver = SolverKind::exact;
  level.tile_shapes[2] = {.kind = TileShape::Kind::polygon, .points = {{0, 0}, {16, 40}, {0, 40}}};
  level.tile_shapes[3] = {.kind = TileShape::Kind::polygon, .points = {{12, 0}, {16, 40}, {0, 40}}};
  level.map.set({13, 10}, 2);
  level.map.set({15, 10}, 3);
  Spawn player;
  player.position = {116, 100};
  player.kind = BodyKind::player;
  player.foot = Foot::box;
  level.spawns = {player};
  EXPECT_EQ(step(RecordedFrames(level, 60), 60),
            "Body 1 stands still between two sides that are too steep to stand on alone: nothing moves it.");
}

// The article does not change the velocity there, but this tile stops the body.
TEST_F(Steps, TellWhichSideABodySticksTo) {
  ContactRecord side;
  side.order = 1;
  side.other = {.role = TileRole::solid, .cell = {5, 3}, .body = 0, .box = {40, 24, 8, 8}};
  side.move = {2, 0};
  side.normal = {-1, 0};
  side.touch = {10, 20};
  EXPECT_EQ(
      told({crossed_slope(true), side}, {10, 20}),
      "Body 1 wanted to go (2, 0) px and went (0, 0) px. It came into the box of the up-slope at (3, 4) "
      "at 0.5 of the step; under its centre the floor of the up-slope at (3, 4) is at y 28, so its top "
      "was put at y 20. Then it was stopped by the left side of the tile at (5, 3) at once; 2 px of "
      "remaining motion went into it and is lost; its velocity was left alone, as a slope had put the body "
      "on "
      "its floor.");
}

TEST_F(Steps, TellOfContactsWithoutAnEffect) {
  EXPECT_EQ(told({crossed_slope(false)}, {12, 20}),
            "Body 1 wanted to go (2, 0) px and did. Nothing that it met changed its way.");
}

TEST_F(Steps, LeaveOutInvisibleMotions) {
  MadeFrames made(
      {state_of({body_at(1, 0, 0, {-4e-311, -0.18})}), state_of({body_at(1, 0, 0.2, {-3e-311, 0})})});
  made.frames[1].record.paths = {
      {.body = 1, .from = {0, 0, 8, 8}, .goal = {-1e-9, 0.2}, .to = {-1e-9, 0.2, 8, 8}}};
  FrameHistory history(1);
  history.go_to(made, 1);
  EXPECT_EQ(
      explain_step(history.view(), 1),
      "Body 1 wanted to go (0, 0.2) px and did. It met nothing. Its velocity went from (0, -0.18) to (0, 0) "
      "px/frame.");
}

TEST(MotionText, ASmallMotionIsNotShownAsZero) {
  EXPECT_EQ(motion_text({0.003, 0}), "less than 0.005");
  EXPECT_EQ(motion_text({0.003, 2}), "(0, 2)");
  EXPECT_EQ(motion_text({1e-300, 0}), "(0, 0)");
  EXPECT_EQ(motion_text({-0.18, 0.007}), "(-0.18, 0.01)");
  EXPECT_EQ(short_text(Vec2{0.003, -1}), "(3e-03, -1)") << "a normal's small numbers are shown";
  EXPECT_EQ(short_text(Vec2{-4e-311, -1}), "(0, -1)");
}

TEST_F(Steps, TellOfLimitsAndTheMouse) {
  MadeFrames made({state_of({body_at(1, 0, 0)}), state_of({body_at(1, 4, 0)})});
  Frame& frame = made.frames[1];
  frame.state.grabbed = 1;
  frame.record.paths = {
      {.body = 1, .from = {0, 0, 8, 8}, .goal = {4, 0}, .to = {4, 0, 8, 8}, .limited = true, .capped = true}};
  FrameHistory history(1);
  history.go_to(made, 1);
  EXPECT_EQ(explain_step(history.view(), 1),
            "Body 1, held by the mouse, wanted to go (4, 0) px and did. It met nothing. It met more contacts "
            "than a "
            "step handles, and the rest of its motion is lost. Its way or its speed was cut to the largest "
            "allowed.");
}

TEST_F(Steps, TellOfAnEndedWorkBudget) {
  MadeFrames made({state_of({body_at(1, 0, 0)}), state_of({body_at(1, 4, 0)})});
  made.frames[1].record.paths = {
      {.body = 1, .from = {0, 0, 8, 8}, .goal = {9, 0}, .to = {4, 0, 8, 8}, .cut_short = true}};
  FrameHistory history(1);
  history.go_to(made, 1);
  EXPECT_THAT(explain_step(history.view(), 1),
              testing::HasSubstr("It met the limit of work for a step, and stopped early."));
}

TEST_F(Steps, TellThatAConveyorCarriesABody) {
  Level level = level_of({"..........", "..........", "..........", "##########"});
  level.tuning.solver = SolverKind::exact;
  level.tuning.shared.bodies = static_cast<double>(BodyPairs::meet);
  level.tuning.exact.gravity = 0.25;
  const TileNumber tile = level.map.at({0, 3}).tile;
  level.tile_shapes[tile] = {.kind = TileShape::Kind::solid, .conveyor = -1.5};
  level.spawns = {{.name = "", .position = {40, 16}, .velocity = {}, .extra = "", .kind = BodyKind::crate},
                  {.name = "", .position = {16, 16}, .velocity = {}, .extra = "", .kind = BodyKind::marble}};
  const auto why = [&](int body) {
    const RecordedFrames recorded(level, 1);
    FrameHistory history(1);
    history.go_to(recorded, 1);
    return explain_step(history.view(), body);
  };
  EXPECT_THAT(why(1), testing::HasSubstr(
                          "stopped by the top of the tile at (4, 3) at once, whose conveyor carries it to "
                          "the left at 1.5 px/frame"));
  EXPECT_THAT(why(2), testing::Not(testing::HasSubstr("conveyor"))) << "a marble does not rub";
  level.tile_shapes[tile].conveyor = 0;
  EXPECT_THAT(why(1), testing::Not(testing::HasSubstr("conveyor")));
}

// A ball comes to a crate that another crate stands on.
TEST_F(Steps, TellWhoHitWhomWhereBodiesMeet) {
  Level level = level_of({"..........", "..........", "..........", "##########"});
  level.tuning.solver = SolverKind::exact;
  level.tuning.shared.bodies = static_cast<double>(BodyPairs::meet);
  level.tuning.shared.drift_blend = level.tuning.shared.wall_bounce = 0;
  level.tuning.exact.gravity = 0.25;
  level.spawns = {{.name = "", .position = {8, 16}, .velocity = {2, 0}, .extra = ""},
                  {.name = "", .position = {18, 16}, .velocity = {}, .extra = "", .kind = BodyKind::crate},
                  {.name = "", .position = {20, 8}, .velocity = {}, .extra = "", .kind = BodyKind::crate}};
  const RecordedFrames recorded(level, 2);
  const auto why = [&](std::int64_t frame, int body) {
    FrameHistory history(2);
    history.go_to(recorded, frame);
    return explain_step(history.view(), body);
  };
  EXPECT_THAT(why(1, 2), testing::HasSubstr("It was stopped by the top of the tile at (2, 3) at once"));
  EXPECT_THAT(why(1, 3), testing::HasSubstr("It was stopped by the top of body 2 at once"));
  EXPECT_THAT(why(2, 1), testing::HasSubstr("stopped by the left side of body 2"));
  EXPECT_THAT(why(2, 2), testing::HasSubstr("hit by the right side of body 1"));
}

}  // namespace talus::debug_explain_test
