// Steps that no geometry explains are found, and nothing is found in steps that are as they should be.
#include <gtest/gtest.h>

#include <optional>

#include <talus/level/ground.h>
#include "prove/judge.h"

namespace talus::judge_test {

constexpr int kFloor = 96;  // px, y of the floor's top

struct Case {
  Case() {
    level.map = TileMap(20, 14);
    level.tile_shapes[1].kind = TileShape::Kind::solid;
    level.tile_shapes[2] = {.kind = TileShape::Kind::solid, .one_way = true};
    for (int x = 0; x < 20; ++x) level.map.set({x, 12}, 1);
    before.kind = BodyKind::player;
    before.box = {50, kFloor - 8, 8, 8};
    before.velocity = {level.tuning.player.run_speed, 0};
    before.gait.grounded = true;
    after = before;
    after.box.x += level.tuning.player.run_speed;
  }
  std::optional<Verdict> verdict(bool right = true) const {
    const RawGround ground(ground_of(level));
    Input input;
    input.right = right;
    return Judge(ground, level.tuning, 2).judge(before, after, input, record);
  }
  std::optional<FindingKind> kind(bool right = true) const {
    const auto found = verdict(right);
    if (!found) return std::nullopt;
    return found->kind;
  }
  Level level;
  Body before, after;
  StepRecord record;
};

TEST(Judge, AStepAlongTheFloorIsExplained) { EXPECT_EQ(Case().kind(), std::nullopt); }

TEST(Judge, FindsABodyThatStopsForNothing) {
  Case c;
  c.after.box.x = c.before.box.x + 0.25;
  c.after.velocity.x = 0;
  EXPECT_EQ(c.kind(), FindingKind::stops);
  c.level.map.set({7, 11}, 1);  // a wall, 56 px from the left
  c.before.box.x = 46.5;
  c.after.box.x = 48;
  EXPECT_EQ(c.kind(), std::nullopt);
}

TEST(Judge, FindsABodyThatLosesSpeed) {
  Case c;
  c.after.velocity.x = 1;
  const auto found = c.verdict();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, FindingKind::slows);
  EXPECT_DOUBLE_EQ(found->amount, 0.5);
}

TEST(Judge, FindsABodyThatLeavesItsFloor) {
  Case c;
  c.after.gait.grounded = false;
  EXPECT_EQ(c.kind(), FindingKind::leaves_floor);
  c.level.map = TileMap(20, 14);
  for (int x = 0; x < 7; ++x) c.level.map.set({x, 12}, 1);  // ends 56 px from the left
  c.before.box.x = 55, c.after.box.x = 56.5;
  EXPECT_EQ(c.kind(), std::nullopt);
}

TEST(Judge, FindsABodyThatIsPutHigher) {
  Case c;
  c.after.box.y -= 8;
  c.level.map.set({7, 11}, 1);  // on which it stands then
  EXPECT_EQ(c.kind(), FindingKind::jumps);
}

TEST(Judge, FindsABodyThatStandsOnAir) {
  Case c;
  c.before.gait.grounded = false;
  c.after.box.y -= 2;
  EXPECT_EQ(c.kind(), FindingKind::floats);
}

TEST(Judge, FindsABodyInTheGround) {
  Case c;
  c.after.box.y += 1;
  EXPECT_EQ(c.kind(), FindingKind::inside);
}

TEST(Judge, FindsABodyThatFallsThroughAOneWayFloor) {
  Case c;
  for (int x = 0; x < 20; ++x) c.level.map.set({x, 8}, 2);  // 64 px from the top
  c.before.gait.grounded = c.after.gait.grounded = false;
  c.before.box.y = 55, c.after.box.y = 58;
  EXPECT_EQ(c.kind(), FindingKind::falls_through);
  c.before.box.y = 58, c.after.box.y = 60;
  EXPECT_EQ(c.kind(), std::nullopt) << "it comes from below";
}

TEST(Judge, FindsABodyThatMeetsNothing) {
  Case c;
  c.before.gait.grounded = c.after.gait.grounded = false;
  c.before.box.y = c.after.box.y = 40;
  ContactRecord contact;
  contact.handled = true;
  contact.move = {1.5, 1};
  contact.normal = {0, -1};
  contact.touch = {50, 40};
  c.record.contacts = {contact};
  EXPECT_EQ(c.kind(), FindingKind::ghost);
  c.record.contacts[0].touch.y = kFloor - 8;
  EXPECT_EQ(c.kind(), std::nullopt);
}

// A body that falls along a wall of two tiles may not land on the upper side of the lower one.
TEST(Judge, ASeamOfAWallIsNoFloor) {
  Case c;
  for (int y = 4; y < 12; ++y) c.level.map.set({8, y}, 1);  // a wall, 64 px from the left
  c.before.gait.grounded = c.after.gait.grounded = false;
  c.before.box = c.after.box = {56, 52, 8, 8};
  ContactRecord contact;
  contact.handled = true;
  contact.move = {1, 2};
  contact.normal = {0, -1};
  contact.touch = {56, 56};
  c.record.contacts = {contact};
  EXPECT_EQ(c.kind(), FindingKind::ghost);
  c.record.contacts[0].normal = {-1, 0};
  EXPECT_EQ(c.kind(), std::nullopt);
}

TEST(Judge, SaysHowHighTheEdgeIsThatStopsABody) {
  Case c;
  c.level.tile_shapes[3] = {.kind = TileShape::Kind::slope, .heights = {0.5, 0.5}};
  c.level.map.set({8, 11}, 3);  // 64 px from the left
  c.before.box.x = 55, c.after.box.x = 56;
  c.after.velocity.x = 0;
  const auto found = c.verdict();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, FindingKind::lip);
  EXPECT_NEAR(found->amount, 0.5, 0.001);
  EXPECT_EQ(found->edge, (Vec2{64, kFloor - 0.5}));
  EXPECT_EQ(found->side, 1);
  c.level.tile_shapes[3].heights = {4, 4};
  EXPECT_EQ(c.kind(), std::nullopt) << "a step that is meant";
}

TEST(Judge, ABodyThatFitsIntoAMouthIsNotInTheGround) {
  Case c;  // a slope up, and a ceiling that comes down to it
  c.level.tile_shapes[3] = {.kind = TileShape::Kind::slope, .heights = {0, 8}};
  c.level.tile_shapes[4] = {
      .kind = TileShape::Kind::slope, .side = TileShape::Side::ceiling, .heights = {0, 16}};
  c.level.map.set({8, 11}, 3);
  c.level.map.set({8, 10}, 4);
  c.before.foot = c.after.foot = Foot::centre;
  c.before.gait.grounded = c.after.gait.grounded = false;
  c.before.box = {60, 80, 2, 7};
  c.after.box = {66, 86, 2, 7};  // from the ceiling, at 86 px, to the slope, at 93
  EXPECT_EQ(c.kind(), std::nullopt);
  c.after.box.y -= 0.01;
  EXPECT_EQ(c.kind(), FindingKind::inside);
}

TEST(Judge, ACornerOnTheWayExplainsAStop) {
  Case c;  // a way down, on which the corner of a ceiling is in the way for a hundredth of a pixel
  c.level.tile_shapes[3] = {.kind = TileShape::Kind::slope, .heights = {8, 0}};
  c.level.map.set({8, 11}, 3);
  c.level.map.set({9, 9}, 1);  // from 72 px on, and down to 80
  const double corner = 0.01;
  c.after.box = {66, 80 - corner, 6, 10 + corner};
  c.before.box = c.after.box;
  c.before.box.x -= 0.5, c.before.box.y -= 0.5;
  c.after.velocity.x = 0;
  EXPECT_EQ(c.kind(), std::nullopt);
  c.level.map.set({9, 9}, 0);
  EXPECT_EQ(c.kind(), FindingKind::stops);
}

// Two halves of a ramp with a gap of a px between them, behind which the ramp goes on half a px higher.
TEST(Judge, FindsALowEdgeBehindAGapUnderAWideBody) {
  Case c;
  c.level.map = TileMap(20, 14, {16, 16});
  for (int x = 0; x < 20; ++x) c.level.map.set({x, 12}, 1);
  c.level.tile_shapes[3] = {
      .kind = TileShape::Kind::polygon, .points = {{0, 16}, {15, 8.5}, {15, 16}}, .parts = {}};
  c.level.tile_shapes[4] = {.kind = TileShape::Kind::slope, .heights = {8.5, 16}};
  c.level.map.set({8, 11}, 3);
  c.level.map.set({9, 11}, 4);
  for (const double width : {8.0, 12.0, 20.0}) {
    Body& body = c.after;
    body.foot = Foot::centre;
    body.box = {144 - width, 0, width, 12};  // its right side at the second half
    const double foot = 192 - 0.5 * (144 - width / 2 - 128);
    body.box.y = foot - 12;
    body.velocity = {};
    c.before = body;
    c.before.velocity.x = 1.5;
    const auto found = c.verdict();
    ASSERT_TRUE(found) << width;
    EXPECT_EQ(found->kind, FindingKind::lip) << width;
    EXPECT_NEAR(found->amount, 1, 0.01) << width;
    ASSERT_TRUE(found->edge);
    EXPECT_NEAR(found->edge->x, 144, 0.01) << width;
    EXPECT_NEAR(found->edge->y, 192 - 8.5, 0.01) << width;
  }
}

TEST(Judge, FindsALowEdgeThatTurnsABallBack) {
  Case c;
  c.level.tuning.solver = SolverKind::exact;
  c.level.tile_shapes[3] = {.kind = TileShape::Kind::slope, .heights = {1, 1}};
  c.level.map.set({8, 11}, 3);  // 64 px from the left
  for (Body* body : {&c.before, &c.after}) {
    body->kind = BodyKind::ball;
    body->gait = {};
    body->box = {55, kFloor - 8, 8, 8};
  }
  ContactRecord contact;
  contact.handled = true;
  contact.normal = {-1, 0};
  contact.touch = {56, kFloor - 8};
  contact.move = {2, 0};
  c.record.contacts = {contact};
  const auto found = c.verdict(false);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, FindingKind::lip);
  EXPECT_EQ(found->amount, 1);
  c.level.tile_shapes[3].heights = {4, 4};
  EXPECT_FALSE(c.verdict(false)) << "a wall";
}

// A corner of a body on its centre meets the side of a tile to which a one-way slope leads up.
TEST(Judge, FindsABallThatStopsBelowItsFloor) {
  for (const double above : {0.0, 3.0}) {  // the slope, px
    for (const bool one_way : {true, false}) {
      Case c;
      c.level.tuning.solver = SolverKind::exact;
      c.level.tile_shapes[3] = {.kind = TileShape::Kind::slope, .one_way = one_way, .heights = {0, 8}};
      c.level.map.set({7, 11}, 3);
      c.level.map.set({8, 11}, 1);  // 64 px from the left
      for (Body* body : {&c.before, &c.after}) {
        body->kind = BodyKind::ball;
        body->foot = Foot::centre;
        body->gait = {};
        body->box = {56, kFloor - 12 - above, 8, 8};
      }
      c.before.box.x = 54;
      c.before.box.y = kFloor - 10 - above;
      ContactRecord contact;
      contact.handled = true;
      contact.normal = {-1, 0};
      contact.touch = c.after.box.position();
      contact.move = {4, -4};
      c.record.contacts = {contact};
      EXPECT_EQ(c.kind(false), FindingKind::stops) << above << one_way;
      c.level.map.set({8, 10}, 1);  // a wall
      EXPECT_EQ(c.kind(false), std::nullopt) << above << one_way;
    }
  }
}

// A body on its centre whose corner is in a slope falls beside the slope: it does not stand there.
TEST(Judge, AWallBesideAFallingBodyIsNoLip) {
  Case c;
  c.level.tuning.solver = SolverKind::exact;
  c.level.tile_shapes[3] = {.kind = TileShape::Kind::slope, .heights = {8, 0}};
  c.level.map.set({6, 11}, 3);
  c.level.map.set({8, 11}, 1);
  for (Body* body : {&c.before, &c.after}) {
    body->foot = Foot::centre;
    body->gait = {};
    body->box = {56 - 1, kFloor - 15, 8, 8};
  }
  c.before.box.x = 54;
  c.after.box.x = 56;
  ContactRecord contact;
  contact.handled = true;
  contact.normal = {-1, 0};
  contact.touch = {56, kFloor - 8 - 1};
  contact.move = {2, 0};
  c.record.contacts = {contact};
  EXPECT_FALSE(c.verdict(false));
}

}  // namespace talus::judge_test
