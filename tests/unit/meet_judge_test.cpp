// The judge of bodies that meet: it finds what is planted, and explains the rest.
#include <gtest/gtest.h>

#include <string>

#include <talus/level/body_kind.h>
#include "prove/proof.h"
#include "sim/lone_body.h"
#include "unit/meeting_run.h"

namespace talus::meet_judge_test {

// A floor at 96 px, from which a slope of 45 degrees rises at 64 px; a one-way floor at 64 px.
Level level_of_kinds() {
  Level level = open_level(0.2, 0);
  level.map = TileMap(24, 14);
  level.tile_shapes[1].kind = TileShape::Kind::solid;
  level.tile_shapes[2] = {.kind = TileShape::Kind::slope, .heights = {0, 8}};
  level.tile_shapes[3] = {.kind = TileShape::Kind::solid, .one_way = true};
  for (int x = 0; x < 24; ++x) level.map.set({x, 12}, 1);
  level.map.set({8, 11}, 2);
  for (int x = 12; x < 20; ++x) level.map.set({x, 8}, 3);
  for (const BodyKind kind : {BodyKind::ball, BodyKind::crate, BodyKind::disc, BodyKind::marble})
    add_body(level, kind, {16, 80});
  return level;
}

struct Court {
  explicit Court(const Level& level = level_of_kinds()) : scene(level, {}) {}
  // "" if a step is explained.
  std::string says(const Body& before, const Body& after, const StepRecord& record = {}) const {
    const auto verdict = scene.meet_judge().judge(before, after, record);
    return verdict ? std::string(info_of(verdict->kind).word) : "";
  }
  // px; 0 if a step is explained.
  double amount(const Body& before, const Body& after, const StepRecord& record = {}) const {
    const auto verdict = scene.meet_judge().judge(before, after, record);
    return verdict ? verdict->amount : 0;
  }
  std::string says_of_rest(const Body& body) const {
    const auto verdict = scene.meet_judge().judge_rest(body);
    return verdict ? std::string(info_of(verdict->kind).word) : "";
  }
  ProveScene scene;
};

Body body_at(BodyKind kind, Vec2 at, Vec2 velocity = {}) {
  Body body;
  body.id = 1;
  body.kind = kind;
  body.box = {at.x, at.y, 8, 8};
  body.velocity = velocity;
  body.is_clear = true;
  return body;
}

StepRecord contact_at(Vec2 touch, Vec2 normal) {
  StepRecord record;
  ContactRecord& contact = record.contacts.emplace_back();
  contact.touch = touch;
  contact.normal = normal;
  contact.handled = true;
  return record;
}

TEST(MeetJudge, ExplainsAFallAndALanding) {
  const Court court;
  for (const BodyKind kind : {BodyKind::ball, BodyKind::disc}) {
    EXPECT_EQ(court.says(body_at(kind, {20, 40}), body_at(kind, {20, 40.1}, {0, 0.2})), "");
    EXPECT_EQ(
        court.says(body_at(kind, {20, 87}, {0, 2}), body_at(kind, {20, 88}), contact_at({20, 88}, {0, -1})),
        "");
  }
}

TEST(MeetJudge, FindsABodyInTheGround) {
  const Court court;
  for (const BodyKind kind : {BodyKind::crate, BodyKind::disc}) {
    EXPECT_EQ(court.says(body_at(kind, {20, 87}, {0, 2}), body_at(kind, {20, 88.01}, {0, 2})), "inside");
    EXPECT_EQ(court.says(body_at(kind, {20, 87}, {0, 2}), body_at(kind, {20, 88.001}, {0, 2})), "");
  }
  // Of a circle the corner of its box is no part.
  EXPECT_EQ(
      court.says(body_at(BodyKind::crate, {57, 86}, {2, 1}), body_at(BodyKind::crate, {59, 87}, {2, 1})),
      "inside");
  EXPECT_EQ(court.says(body_at(BodyKind::disc, {57, 86}, {2, 1}), body_at(BodyKind::disc, {59, 87}, {2, 1})),
            "");
}

TEST(MeetJudge, FindsAFallThroughAOneWayFloor) {
  const Court court;
  for (const BodyKind kind : {BodyKind::ball, BodyKind::marble}) {
    EXPECT_EQ(court.says(body_at(kind, {110, 55}, {0, 2}), body_at(kind, {110, 57}, {0, 2})),
              "falls-through");
    EXPECT_EQ(court.says(body_at(kind, {110, 66}, {0, -2}), body_at(kind, {110, 64.1}, {0, -1.8})), "");
  }
}

TEST(MeetJudge, FindsAContactWithNothing) {
  const Court court;
  for (const BodyKind kind : {BodyKind::ball, BodyKind::disc}) {
    const Body before = body_at(kind, {20, 60}, {0, 2}), after = body_at(kind, {20, 61}, {0, 0});
    EXPECT_EQ(court.says(before, after, contact_at({20, 61}, {0, -1})), "ghost");
    EXPECT_EQ(court.says(before, after, contact_at({20, 61}, {1, 0})), "ghost");
  }
}

TEST(MeetJudge, MeasuresTheDepthInTheGround) {
  const Court court;
  for (const BodyKind kind : {BodyKind::crate, BodyKind::disc}) {
    const Body before = body_at(kind, {20, 87}, {0, 2});
    EXPECT_NEAR(court.amount(before, body_at(kind, {20, 88.25}, {0, 2})), 0.25, 1e-5);
    EXPECT_NEAR(court.amount(before, body_at(kind, {20, 91}, {0, 2})), 3, 1e-5);
  }
}

TEST(MeetJudge, MeasuresTheDepthBelowAFloor) {
  const Body before = body_at(BodyKind::ball, {110, 55}, {0, 2});
  EXPECT_NEAR(Court().amount(before, body_at(BodyKind::ball, {110, 57}, {0, 2})), 1, 1e-6);
}

TEST(MeetJudge, MeasuresTheWayThatAGhostLeavesFree) {
  const Court court;
  const Body before = body_at(BodyKind::ball, {20, 84}, {0, 2}), after = body_at(BodyKind::ball, {20, 85});
  EXPECT_EQ(court.amount(before, after, contact_at({20, 85}, {0, -1})), 3);
  EXPECT_EQ(court.amount(before, after, contact_at({20, 85}, {1, 0})), 8) << "nothing is there";
}

TEST(MeetJudge, TheMessageNamesTheAmount) {
  Finding finding;
  finding.trial.body = body_at(BodyKind::ball, {20, 87});
  const auto says = [&](FindingKind kind, double amount) {
    finding.kind = kind;
    finding.amount = amount;
    return message_of(finding);
  };
  EXPECT_EQ(says(FindingKind::inside, 0.25),
            "a ball of 8x8 px comes into the ground by 0.25 px at 0, 0 px (solver exact)");
  EXPECT_EQ(says(FindingKind::inside, 0), "a ball of 8x8 px comes into the ground at 0, 0 px (solver exact)");
  EXPECT_EQ(says(FindingKind::falls_through, 1),
            "a ball of 8x8 px falls through a floor by 1 px at 0, 0 px (solver exact)");
  EXPECT_EQ(
      says(FindingKind::ghost, 3),
      "a ball of 8x8 px is stopped by something that is not there and leaves 3 px of its way free at 0, 0 "
      "px (solver exact)");
}

TEST(MeetJudge, FindsSpeedFromNothing) {
  const Court court;
  // A fall by 1 px gives a speed of the square root of 0.4 px/frame.
  EXPECT_EQ(court.says(body_at(BodyKind::ball, {20, 40}), body_at(BodyKind::ball, {20, 41}, {0, 0.632})), "");
  EXPECT_EQ(court.says(body_at(BodyKind::ball, {20, 40}), body_at(BodyKind::ball, {20, 41}, {0, 0.7})),
            "gains");
  Body turns = body_at(BodyKind::disc, {20, 41}, {0, 0.632});
  turns.spin = 0.3;
  EXPECT_EQ(court.says(body_at(BodyKind::disc, {20, 40}), turns), "gains");
}

TEST(MeetJudge, FindsRestWhereNothingHolds) {
  const Court court;
  for (const BodyKind kind : {BodyKind::ball, BodyKind::crate, BodyKind::disc, BodyKind::marble}) {
    EXPECT_EQ(court.says_of_rest(body_at(kind, {20, 88})), "") << "on the floor";
    EXPECT_EQ(court.says_of_rest(body_at(kind, {20, 60})), "stops") << "in the air";
  }
  // Its corner is on the middle of the slope, which is steeper than friction holds.
  EXPECT_EQ(court.says_of_rest(body_at(BodyKind::ball, {60, 84})), "stops");
  EXPECT_EQ(court.says_of_rest(body_at(BodyKind::crate, {60, 84})), "stops");
  // A ball beside the slope is held by the floor.
  EXPECT_EQ(court.says_of_rest(body_at(BodyKind::ball, {56, 88})), "");
}

TEST(MeetJudge, FrictionHoldsACrateOnASlope) {
  Level level = level_of_kinds();
  level.tile_shapes[2].heights = {0, 3};  // friction of 1/2 is more than 3/8
  const Court court(level);
  EXPECT_EQ(court.says_of_rest(body_at(BodyKind::crate, {60, 86.5})), "");
  EXPECT_EQ(court.says_of_rest(body_at(BodyKind::ball, {60, 86.5})), "stops");
}

// ---- Whole proofs ----

std::string text_of(const Level& level) {
  std::string text;
  const Proof proof = *prove(ProveScene(level, {}), 1);
  for (const Finding& finding : proof.findings) text += message_of(finding) + "\n";
  return text;
}

TEST(MeetJudge, AGoodHillHasNoFinding) {
  Level level = level_of_kinds();
  level.map.set({9, 11}, 1);
  level.tile_shapes[4] = {.kind = TileShape::Kind::slope, .heights = {8, 0}};
  level.map.set({10, 11}, 4);
  level.curves.push_back({"", {Arc{{150, 150}, 60, 120, 180, true}, Curve::Faces::both}, ""});
  EXPECT_EQ(text_of(level), "");
}

TEST(MeetJudge, ALowEdgeIsALip) {
  Level level = level_of_kinds();
  level.tile_shapes[2] = {.kind = TileShape::Kind::profile, .heights = {1, 1, 1}};
  const std::string text = text_of(level);
  for (const char* body : {"a ball", "a crate", "a disc", "a marble"})
    EXPECT_NE(text.find(std::string(body) + " of 8x8 px"), std::string::npos) << body << "\n" << text;
  EXPECT_NE(text.find("is stopped by a low edge of 1 px at 64, 95 px"), std::string::npos) << text;
}

TEST(MeetJudge, TheHeightOfALipIsExact) {
  for (const double height : {0.5, 1.0, 2.0}) {
    Level level = level_of_kinds();
    level.tile_shapes[2] = {.kind = TileShape::Kind::profile, .heights = {height, height, height}};
    const Court court(level);
    for (const BodyKind kind : {BodyKind::ball, BodyKind::crate}) {
      const Body before = body_at(kind, {55, 88}, {2, 0}), after = body_at(kind, {56, 88});
      const auto lip = court.scene.meet_judge().judge(before, after, contact_at({56, 88}, {-1, 0}));
      ASSERT_TRUE(lip);
      EXPECT_EQ(lip->kind, FindingKind::lip);
      EXPECT_EQ(lip->amount, height);
      EXPECT_EQ(lip->edge->y, 96 - height);
    }
  }
}

TEST(MeetJudge, AHighEdgeIsAWall) {
  Level level = level_of_kinds();
  level.tile_shapes[2] = {.kind = TileShape::Kind::profile, .heights = {3, 3, 3}};
  EXPECT_EQ(text_of(level), "");
}

// What a proof plays again is what it has played.
TEST(MeetJudge, AFindingPlaysAgain) {
  Level level = level_of_kinds();
  level.tile_shapes[2] = {.kind = TileShape::Kind::profile, .heights = {1, 1, 1}};
  const ProveScene scene(level, {});
  TrialRunner runner(scene);
  const Proof proof = *prove(scene, 1);
  ASSERT_FALSE(proof.findings.empty());
  for (const Finding& finding : proof.findings) {
    const auto again = runner.play(finding.trial);
    ASSERT_TRUE(again) << message_of(finding);
    EXPECT_EQ(message_of(*again), message_of(finding));
    EXPECT_TRUE(scene_for(lone_body_of(finding.trial), compile_scene(level)).features.meets);
  }
}

}  // namespace talus::meet_judge_test
