// The right answer of a hard case as an overlay.

#include "overlay/answer.h"

#include <gtest/gtest.h>

namespace talus::answer_test {

// What is drawn for a body with this start and check.
OverlayDrawing drawn_answer(HardCase hard, Vec2 start, const CaseCheck& check,
                            Rect visible = {0, 0, 320, 136}) {
  Level level;
  level.spawns.emplace_back().position = start;
  hard.checks = {check};
  OverlayDrawing drawing;
  add_answer(hard, level, visible, drawing);
  return drawing;
}

HardCase on_a_floor() {
  HardCase hard;
  hard.floor.parts.emplace_back(Segment{{0, 64}, {80, 64}});
  return hard;
}

CaseCheck reaching(double x) {
  CaseCheck check;
  check.measure = CaseCheck::Measure::reaches;
  check.x = x;
  return check;
}

TEST(AnswerOverlay, DrawsTheStartTheGhostAndTheFloor) {
  CaseCheck check;
  check.right = 48;
  check.bottom = 64;
  const OverlayDrawing drawing = drawn_answer(on_a_floor(), {10, 20}, check);
  ASSERT_EQ(drawing.boxes.size(), 2u);
  EXPECT_EQ(drawing.boxes[0].box, (Rect{10, 20, 8, 8}));
  EXPECT_EQ(drawing.boxes[1].box, (Rect{40, 56, 8, 8}));
  EXPECT_TRUE(drawing.boxes[1].filled);
  ASSERT_EQ(drawing.lines.size(), 2u);
  EXPECT_EQ(drawing.lines[0].from, (Vec2{0, 64}));
  EXPECT_EQ(drawing.lines[1].from, (Vec2{14, 24}));
  EXPECT_EQ(drawing.lines[1].to, (Vec2{44, 60}));
  EXPECT_TRUE(drawing.lines[1].arrow);
}

TEST(AnswerOverlay, APathFollowsTheFloor) {
  const OverlayDrawing drawing = drawn_answer(on_a_floor(), {0, 56}, reaching(24));
  ASSERT_EQ(drawing.lines.size(), 4u);  // the floor, and three parts of the way
  EXPECT_EQ(drawing.lines[3].to, (Vec2{28, 60}));
  EXPECT_TRUE(drawing.lines[3].arrow);
  EXPECT_FALSE(drawing.lines[2].arrow);
}

TEST(AnswerOverlay, APathWithoutAFloorIsStraight) {
  const OverlayDrawing drawing = drawn_answer({}, {40, 56}, reaching(16));
  ASSERT_EQ(drawing.lines.size(), 3u);
  EXPECT_EQ(drawing.lines[2].to, (Vec2{20, 60}));
  EXPECT_TRUE(drawing.lines[2].arrow);
}

// A path has as many lines as can be seen, however far away its end is.
TEST(AnswerOverlay, APathIsDrawnWhereItIsVisible) {
  const OverlayDrawing near = drawn_answer({}, {40, 56}, reaching(1e8));
  EXPECT_GE(near.lines.size(), 280u / 8);
  EXPECT_LE(near.lines.size(), 320u / 8 + 2);
  const OverlayDrawing backwards = drawn_answer({}, {1e8, 56}, reaching(-1e8));
  EXPECT_GE(backwards.lines.size(), 320u / 8);
  EXPECT_LE(backwards.lines.size(), 320u / 8 + 2);
  EXPECT_TRUE(drawn_answer({}, {40, 56}, reaching(1e8), {0, 500, 320, 136}).lines.empty()) << "below it";
  const OverlayDrawing far = drawn_answer(on_a_floor(), {-1e8, 56}, reaching(1e8), {-1e7, 0, 2e7, 136});
  EXPECT_LE(far.lines.size(), 2000u);
}

TEST(AnswerOverlay, OfManyPathsTheFirstAreDrawn) {
  HardCase hard;
  hard.checks.assign(256, reaching(300));
  Level level;
  level.spawns.emplace_back();
  OverlayDrawing drawing;
  add_answer(hard, level, {0, 0, 320, 136}, drawing);
  EXPECT_LE(drawing.lines.size(), 2100u);
}

}  // namespace talus::answer_test
