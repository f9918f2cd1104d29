// Bodies that meet, against the closed forms of tests/reference.
#include "reference/closed_forms.h"

#include <gtest/gtest.h>

#include <vector>

#include "meeting_run.h"

namespace talus::closed_forms_test {

void add(Level& level, Vec2 at, Vec2 velocity = {}, Vec2 size = {8, 8}, BodyKind kind = BodyKind::ball) {
  add_body(level, kind, at, velocity, size);
}

using Play = MeetingRun;

struct Cradle {
  int count, from_left, from_right;
};

TEST(ClosedForms, Cradles) {
  for (const auto& [count, left, right] : {Cradle{2, 1, 0}, {5, 1, 0}, {5, 2, 0}, {3, 1, 1}, {7, 2, 2}}) {
    Level level = open_level(0, 1);
    for (int i = 0; i < count; ++i) {
      const double comes = i < left ? 1 : i >= count - right ? -1 : 0;
      add(level, {100 + 8.0 * i - comes * 20.3, 40}, {2.5 * comes, 0});
    }
    Play run(level);
    run.step(20);
    const std::vector<double> after = reference::cradle(count, left, right, 2.5);
    for (std::size_t i = 0; i < after.size(); ++i)
      EXPECT_NEAR(run.state.bodies[i].velocity.x, after[i], 1e-12) << count << " " << left << " " << i;
  }
}

TEST(ClosedForms, TwoBodiesOfAnyMassAndBounce) {
  for (const double width : {1.0, 8.0, 13.5, 200.0}) {
    for (const double bounce : {0.0, 0.3, 0.9, 1.0}) {
      for (const double speed : {-3.0, -0.25, 0.0, 1.0}) {
        Level level = open_level(0, bounce);
        add(level, {40, 40}, {2, 0}, {8, 8});
        add(level, {60.3, 44}, {speed, 0}, {width, 3});
        Play run(level);
        run.step(20);
        const auto after = reference::after_impact({64, width * 3}, {2, speed}, bounce);
        EXPECT_NEAR(run.state.bodies[0].velocity.x, after.a, 1e-12) << width << " " << bounce << " " << speed;
        EXPECT_NEAR(run.state.bodies[1].velocity.x, after.b, 1e-12) << width << " " << bounce << " " << speed;
      }
    }
  }
}

// A crate has a friction of 1/2.
TEST(ClosedForms, ACrateOnAnIncline) {
  for (const double slope : {0.125, 0.375, 0.625, 0.75, 1.0, 1.5}) {
    Level level = open_level(0.2, 0);
    level.curves.push_back({"", {Segment{{16, 180}, {16 + 96, 180 - 96 * slope}}, Curve::Faces::up}, ""});
    const double x = 80, y = 180 - (x + 8 - 16) * slope - 8;  // its right corner is on the line
    add(level, {x, y}, {}, {8, 8}, BodyKind::crate);
    Play run(level);
    const double gain = reference::gain_down_incline(0.2, slope, 0.5), length = std::hypot(1.0, slope);
    for (int frame = 1; frame <= 25; ++frame) {
      run.step();
      const Body& crate = run.body(0);
      const double way = gain * frame * frame / 2;
      ASSERT_NEAR(crate.box.x, x - way / length, 1e-9) << slope << " " << frame;
      ASSERT_NEAR(crate.box.y, y + way * slope / length, 1e-9) << slope << " " << frame;
      ASSERT_NEAR(std::hypot(crate.velocity.x, crate.velocity.y), gain * frame, 1e-9)
          << slope << " " << frame;
    }
  }
}

TEST(ClosedForms, AFallWithABounce) {
  for (const double bounce : {0.3, 0.5, 0.9, 1.0}) {
    Level level = open_level(0.2, bounce);
    level.curves.push_back({"", {Segment{{0, 160}, {320, 160}}, Curve::Faces::up}, ""});
    const reference::Fall fall{.height = 97.3, .gravity = 0.2, .bounce = bounce};
    add(level, {40, 160 - 8 - fall.height});
    Play run(level);
    for (int frame = 1; frame < fall.lands_again(); ++frame) {
      run.step();
      const Body& ball = run.body(0);
      ASSERT_NEAR(160 - ball.box.bottom(), fall.above(frame), 1e-9) << bounce << " " << frame;
      ASSERT_NEAR(-ball.velocity.y, fall.rises(frame), 1e-9) << bounce << " " << frame;
    }
  }
}

}  // namespace talus::closed_forms_test
