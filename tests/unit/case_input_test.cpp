// The input of hard cases: which keys are held when, and that the session plays it.
#include "sim/case_input.h"

#include <gtest/gtest.h>

#include "folder_test.h"
#include "paths.h"
#include "session/session.h"

namespace talus::case_input_test {

namespace act = action;

// A player runs right, up a ramp and into a wall. Its right side is at 96 from frame 100 on.
const std::string kRamp = source_path("assets/hard_cases/09-ramp-into-a-wall.talus.json");

TEST(CaseInput, HoldsFromItsFrameOn) {
  const std::vector<CaseInput> entries = {{.frame = 3, .mouse = {8, 9}, .mouse_down = true, .left = true},
                                          {.frame = 5, .mouse = {}, .right = true, .jump = true}};
  EXPECT_EQ(case_input(entries, 2), Input{});
  const Input first{.mouse = {8, 9}, .mouse_down = true, .left = true};
  EXPECT_EQ(case_input(entries, 3), first);
  EXPECT_EQ(case_input(entries, 4), first);
  const Input second{.mouse = {}, .right = true, .jump = true};
  EXPECT_EQ(case_input(entries, 5), second);
  EXPECT_EQ(case_input(entries, 1000), second);
  EXPECT_EQ(case_input({}, 1), Input{});
}

TEST(CaseInput, LiveInputIsAdded) {
  const Input of_case{.mouse = {1, 2}, .mouse_down = true, .right = true};
  EXPECT_EQ(added(of_case, Input{.mouse = {3, 4}, .jump = true}),
            (Input{.mouse = {1, 2}, .mouse_down = true, .right = true, .jump = true}));
  EXPECT_EQ(added(of_case, Input{.mouse = {3, 4}, .mouse_down = true}),
            (Input{.mouse = {3, 4}, .mouse_down = true, .right = true}));
  EXPECT_EQ(added({}, Input{.mouse = {3, 4}, .left = true}), (Input{.mouse = {3, 4}, .left = true}));
}

class SessionHardCase : public FolderTest {};

TEST_F(SessionHardCase, PlaysWithItsInput) {
  Session session;
  session.apply(act::OpenFile{kRamp, true});
  for (int i = 0; i < 120; ++i) session.apply(act::StepFrame{});
  EXPECT_NEAR(session.state().bodies[0].box.right(), 96, 1e-9);
  session.apply(act::ResetPlay{});
  session.apply(act::Play{});
  for (int i = 0; i < 120; ++i) session.advance(1.0 / kStepsPerSecond);
  EXPECT_NEAR(session.state().bodies[0].box.right(), 96, 1e-9);
}

TEST_F(SessionHardCase, PlaysWithItsInputWhenItIsRecovered) {
  Session session;
  session.apply(
      act::RecoverLevel{std::make_shared<const Level>(load_level(kRamp).value().level), "", "ramp"});
  for (int i = 0; i < 120; ++i) session.apply(act::StepFrame{});
  EXPECT_NEAR(session.state().bodies[0].box.right(), 96, 1e-9);
}

TEST_F(SessionHardCase, PlaysWithItsInputWhenItIsReadAgain) {
  const std::string file = path("case.talus.json");
  Level level = load_level(kRamp).value().level;
  const Level whole = level;
  level.extra.clear();
  ASSERT_TRUE(save_level(level, *format_for_file(file), file));
  Session session;
  session.apply(act::OpenFile{file});
  ASSERT_TRUE(save_level(whole, *format_for_file(file), file));
  session.apply(act::CheckFile{});
  session.apply(act::ResetPlay{});
  for (int i = 0; i < 120; ++i) session.apply(act::StepFrame{});
  EXPECT_NEAR(session.state().bodies[0].box.right(), 96, 1e-9);
}

TEST_F(SessionHardCase, KeysOfTheUserAreAdded) {
  Session session;
  session.apply(act::OpenFile{kRamp, true});
  session.apply(act::StepFrame{});
  const double y = session.state().bodies[0].box.y;
  session.apply(act::HoldKeys{.jump = true});
  for (int i = 0; i < 4; ++i) session.apply(act::StepFrame{});
  EXPECT_LT(session.state().bodies[0].box.y, y - 8);
  EXPECT_GT(session.state().bodies[0].box.x, 40);
}

TEST_F(SessionHardCase, AnotherLevelIsPlayedWithoutIt) {
  const std::string file = path("no_case.talus.json");
  auto loaded = load_level(kRamp);
  ASSERT_TRUE(loaded);
  loaded->level.extra.clear();
  ASSERT_TRUE(save_level(loaded->level, *format_for_file(file), file));
  Session session;
  session.apply(act::OpenFile{kRamp, true});
  session.apply(act::OpenFile{file});
  ASSERT_EQ(session.level().spawns.size(), 1u);
  for (int i = 0; i < 120; ++i) session.apply(act::StepFrame{});
  EXPECT_EQ(session.state().bodies[0].box.x, 40);
}

}  // namespace talus::case_input_test
