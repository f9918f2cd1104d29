// Bodies that meet run mirrored in a mirrored level: each scene has parted from its image once.
#include <gtest/gtest.h>

#include "level/transform.h"
#include "meeting_run.h"

namespace talus::meeting_mirror_test {

// A room with a floor and two walls.
Level room(double gravity, double bounce, double parts) {
  Level level;
  level.map = TileMap(32, 24);
  level.sheet(SheetId::tiles).flags[1] = 1;
  for (int x = 0; x < 32; ++x) level.map.set({x, 23}, 1);
  for (int y = 0; y < 24; ++y) {
    for (const int x : {0, 31}) level.map.set({x, y}, 1);
  }
  let_bodies_meet(level.tuning, gravity, bounce);
  level.tuning.exact.substeps = parts;
  return level;
}
void add_line(Level& level, Vec2 from, Vec2 to) {
  level.curves.push_back({"", {Segment{from, to}, Curve::Faces::up}, ""});
}

void expect_mirrored(const Level& level) {
  constexpr double kWidth = 256;  // px
  MeetingRun run(level), other(mirrored(level));
  for (int frame = 1; frame <= 300; ++frame) {
    run.step();
    other.step();
    for (std::size_t i = 0; i < level.spawns.size(); ++i) {
      ASSERT_NEAR(run.body(i).box.x, kWidth - other.body(i).box.right(), 1e-9) << frame;
      ASSERT_NEAR(run.body(i).box.y, other.body(i).box.y, 1e-9) << frame;
    }
  }
}

// Where the end ends, rounding took the place for the line beyond, in one of the two.
TEST(MeetingMirror, ADiscRollsOverAnEndOntoAFlat) {
  Level level = room(0.2, 0, 1);
  add_line(level, {78, 155}, {136, 129});
  add_line(level, {136, 129}, {176, 115});
  add_body(level, BodyKind::disc, {103, 96}, {2, 0}, {11, 11});
  expect_mirrored(level);
}

// A speed near 0 was what rounding left between two places.
TEST(MeetingMirror, ADiscTurnsBackOnACorner) {
  Level level = room(0.05, 0, 2);
  add_line(level, {97, 106}, {139, 119});
  add_line(level, {139, 119}, {171, 106});
  add_body(level, BodyKind::disc, {166, 34}, {0, 0}, {7, 7});
  expect_mirrored(level);
}

// The time of a touch was right to 1e-6 frames of the slack alone, and its normal was that of before.
TEST(MeetingMirror, TwoDiscsMeetOnASlope) {
  Level level = room(0.05, 0, 1);
  add_line(level, {20, 167}, {73, 116});
  add_body(level, BodyKind::disc, {27, 26}, {0, 0}, {11, 11});
  add_body(level, BodyKind::disc, {73, 37}, {-3, 0}, {7, 7});
  expect_mirrored(level);
}

// It met the slope again and again in what was left of the part, 1e-14 px, and stopped there.
TEST(MeetingMirror, ACrateMeetsASlopeAtTheEndOfAPart) {
  Level level = room(0.05, 0.5, 2);
  add_line(level, {121, 104}, {163, 132});
  add_body(level, BodyKind::crate, {160, 80}, {0, 0}, {7, 10});
  expect_mirrored(level);
}

// The slack grew with x, and with it the time of a touch.
TEST(MeetingMirror, TwoDiscsInAHollowHaveTheSameSlack) {
  Level level = room(0.3, 0, 1);
  add_line(level, {60, 109}, {112, 115});
  add_line(level, {112, 115}, {161, 112});
  add_body(level, BodyKind::disc, {126, 69}, {0, 0}, {8, 8});
  add_body(level, BodyKind::disc, {133, 52}, {0, 0}, {8, 8});
  expect_mirrored(level);
}

// A gap of 1e-14 px takes 1e-7 frames to fall through, which friction turned into a speed.
TEST(MeetingMirror, TwoCratesSlideDownASlope) {
  Level level = room(0.2, 0.2, 2);
  add_line(level, {191, 113}, {232, 158});
  add_body(level, BodyKind::crate, {215, 99}, {0, 0}, {9, 8});
  add_body(level, BodyKind::crate, {203, 105}, {1, 0}, {8, 5});
  expect_mirrored(level);
}

// The chord to the place where it meets the line met that line before, by rounding.
TEST(MeetingMirror, ACrateHopsInAHollow) {
  Level level = room(0.1, 0, 1);
  add_line(level, {63, 120}, {113, 160});
  add_line(level, {113, 160}, {159, 119});
  add_body(level, BodyKind::crate, {125, 82}, {-1, 0}, {8, 5});
  add_body(level, BodyKind::disc, {123, 66}, {-1, 0}, {5, 5});
  expect_mirrored(level);
}

// A contact at rest but for rounding was left out, so a crate was pushed into its slope.
TEST(MeetingMirror, ADiscAndACrateSlideDownTogether) {
  Level level = room(0.3, 0.5, 3);
  add_line(level, {81, 136}, {132, 144});
  add_body(level, BodyKind::disc, {86, 95}, {0, 0}, {9, 9});
  add_body(level, BodyKind::crate, {97, 49}, {0, 0}, {4, 7});
  expect_mirrored(level);
}

}  // namespace talus::meeting_mirror_test
