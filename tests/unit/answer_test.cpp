// The right answer of a hard case as an overlay.

#include "overlay/answer.h"

#include <gtest/gtest.h>

namespace talus::answer_test {

TEST(AnswerOverlay, DrawsTheStartTheGhostAndTheFloor) {
  Level level;
  level.spawns.emplace_back().position = {10, 20};
  HardCase hard;
  hard.floor.parts.emplace_back(Segment{{0, 64}, {80, 64}});
  CaseCheck check;
  check.right = 48;
  check.bottom = 64;
  hard.checks = {check};
  OverlayDrawing drawing;
  add_answer(hard, level, drawing);
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

TEST(AnswerOverlay, AWayKeepsToTheFloor) {
  Level level;
  level.spawns.emplace_back().position = {0, 56};
  HardCase hard;
  hard.floor.parts.emplace_back(Segment{{0, 64}, {80, 64}});
  CaseCheck check;
  check.measure = CaseCheck::Measure::reaches;
  check.x = 24;
  hard.checks = {check};
  OverlayDrawing drawing;
  add_answer(hard, level, drawing);
  ASSERT_EQ(drawing.lines.size(), 4u);  // the floor, and three parts of the way
  EXPECT_EQ(drawing.lines[3].to, (Vec2{28, 60}));
  EXPECT_TRUE(drawing.lines[3].arrow);
  EXPECT_FALSE(drawing.lines[2].arrow);
}

TEST(AnswerOverlay, AWayWithoutAFloorIsStraight) {
  Level level;
  level.spawns.emplace_back().position = {40, 56};
  HardCase hard;
  CaseCheck check;
  check.measure = CaseCheck::Measure::reaches;
  check.x = 16;
  hard.checks = {check};
  OverlayDrawing drawing;
  add_answer(hard, level, drawing);
  ASSERT_EQ(drawing.lines.size(), 3u);
  EXPECT_EQ(drawing.lines[2].to, (Vec2{20, 60}));
  EXPECT_TRUE(drawing.lines[2].arrow);
}

}  // namespace talus::answer_test
