// The debugger: the timeline, the input roll, breakpoints, plots, comparison and the stages of a step.
#include <algorithm>
#include <cmath>

#include "debugger_harness.h"
#include "edit/level_settings.h"
#include "paths.h"

namespace talus::debugger_test {

class UiDebugger : public DebuggerTest {
 protected:
  ImVec2 on_track(std::int64_t at) {
    const Widget* track = find("timeline/track");
    if (track == nullptr) {
      ADD_FAILURE() << "no timeline";
      return {};
    }
    const float inset = app().ui().px(6), width = track->max.x - track->min.x - 2 * inset;
    const float share = static_cast<float>(at) / static_cast<float>(timeline().last_frame());
    return {track->min.x + inset + share * width, (track->min.y + track->max.y) / 2 + 3};
  }
  void open_tab(const std::string& id) {
    if (!app().ui().view.window.dock_open) key(kKeyF4);
    frames(2);
    click("tabs/" + id);
    frames(2);
  }
  int choose_ball() {
    session().apply(action::SelectBody{ball().id});
    return ball().id;
  }
};

TEST_F(UiDebugger, DraggingTheTimelineShowsEachFrameAsItWas) {
  std::vector<State> states{session().state()};
  for (int i = 0; i < 40; ++i) {
    play(1);
    states.push_back(session().state());
  }
  move(on_track(40));
  press();
  for (const std::int64_t at : {31, 12, 3, 25, 0, 40}) {
    move(on_track(at));
    EXPECT_EQ(frame(), at);
    EXPECT_EQ(session().state(), states[static_cast<std::size_t>(at)]);
  }
  release();
  EXPECT_EQ(timeline().last_frame(), 40);
}

TEST_F(UiDebugger, ANarrowTableOfContactsHasAllColumns) {
  for (const int width : {1280, 800}) {
    start(save_test_level("level.talus.json"), width, width == 800 ? 600 : 720);
    session().apply(action::SelectBody{ball().id});
    while (session().record().contacts.empty()) session().apply(action::StepFrame{});
    app().ui().view.requests.ask(request::ShowTab("inspector"));
    frames(8);
    for (const char* title : {"#", "other", "reaction", "t", "n", "delta", "floor", "done"}) {
      const Widget* column = find(std::string("inspector/contacts/") + title);
      ASSERT_NE(column, nullptr) << title << " at " << width;
      EXPECT_LE(column->max.x, static_cast<float>(width)) << title;
    }
  }
}

TEST_F(UiDebugger, StepsBackAndForthByKeyWithoutLosingTheRest) {
  play(10);
  const State last = session().state();
  for (int i = 0; i < 4; ++i) key(shift(kKeyF10));
  EXPECT_EQ(frame(), 6);
  play(4);
  EXPECT_EQ(session().state(), last);
  EXPECT_EQ(timeline().branches().size(), 1u);
  key(shift(kKeyF10));
  key(kKeyEnd);
  EXPECT_EQ(frame(), 10);
}

TEST_F(UiDebugger, MarksAreSetAndJumpedToByKey) {
  play(20);
  key(ctrl('m'));
  for (int i = 0; i < 8; ++i) key(shift(kKeyF10));
  key(ctrl('m'));
  key(kKeyEnd);
  key(alt(kKeyLeft));
  EXPECT_EQ(frame(), 12);
  key(alt(kKeyRight));
  EXPECT_EQ(frame(), 20);
  click(on_track(5));
  key(ctrl('m'));
  ASSERT_EQ(timeline().current().marks.size(), 3u);
  key(ctrl('m'));
  EXPECT_EQ(timeline().current().marks.size(), 2u);
}

TEST_F(UiDebugger, DraggingABallInThePastMakesABranch) {
  play(30);
  click(on_track(10));
  ASSERT_EQ(frame(), 10);
  const Rect box = ball().box;
  move(on_canvas("play", {box.x + 4, box.y + 4}));
  press();
  key(kKeyF5);
  move(on_canvas("play", {164, 40}));
  frames(5);
  release();
  key(kKeyF5);
  ASSERT_EQ(timeline().branches().size(), 2u);
  const int made = timeline().current().id;
  EXPECT_EQ(timeline().current().fork, 10);
  click("timeline/branch");
  frames(2);
  click("timeline/branch1");
  frames(2);
  EXPECT_EQ(timeline().current().id, 1);
  EXPECT_EQ(timeline().last_frame(), 30);
  click("timeline/branch");
  frames(2);
  click("timeline/drop" + std::to_string(made));
  frames(3);
  click("question/drop");
  frames(2);
  EXPECT_EQ(timeline().branches().size(), 1u);
}

TEST_F(UiDebugger, InputRollPressesAKeyOverARange) {
  play(12);
  open_tab("input_roll");
  const Widget* row = find("input_roll/jump");
  ASSERT_NE(row, nullptr);
  const float column = app().ui().px(12), y = (row->min.y + row->max.y) / 2, left = row->min.x;
  const auto at = [&](int column_number) {
    return ImVec2{left + column * (static_cast<float>(column_number) + 0.5f), y};
  };
  drag(at(3), at(6));
  frames(5);
  EXPECT_EQ(timeline().branches().size(), 2u);
  for (std::int64_t f = 1; f <= 12; ++f) EXPECT_EQ(timeline().current().input(f).jump, f >= 4 && f <= 7) << f;
  EXPECT_EQ(timeline().last_frame(), 12);
  EXPECT_FALSE(timeline().behind());
  click(at(4));
  frames(5);
  EXPECT_FALSE(timeline().current().input(5).jump);
  EXPECT_EQ(timeline().branches().size(), 2u) << "the same draft";
}

// The ball falls from row 10, and meets the floor at y = 128.
TEST_F(UiDebugger, ABreakpointStopsInBothDirections) {
  choose_ball();
  open_tab("breakpoints");
  click("breakpoints/kind");
  frames(2);
  click("breakpoints/kind_0");  // contact with a tile
  frames(2);
  const auto enter = [&](const std::string& field, const std::string& number) {
    click(field);
    click(field);
    key(ctrl('a'));
    type(number);
    key(kKeyTab);
  };
  enter("breakpoints/field0", "5");
  enter("breakpoints/field1", "16");
  click("breakpoints/add");
  frames(2);
  ASSERT_EQ(session().debugger().breakpoints().all().size(), 1u);
  EXPECT_EQ(session().debugger().breakpoints().all()[0].body, ball().id);
  key(kKeyF5);
  frames(200);
  EXPECT_FALSE(session().playback().running);
  const std::int64_t stopped = frame();
  ASSERT_GT(stopped, 5);
  ASSERT_LT(stopped, 200);
  const auto& contacts = session().record().contacts;
  EXPECT_TRUE(std::any_of(contacts.begin(), contacts.end(), [](const ContactRecord& c) {
    return c.other.cell == Cell{5, 16};
  }));
  play(1);
  key(shift(kKeyF9));
  frames(10);
  EXPECT_EQ(frame(), stopped);
  click(on_track(1));
  key(kKeyF9);
  frames(10);
  EXPECT_EQ(frame(), stopped);
}

TEST_F(UiDebugger, RunningBackTakesTheTypedCondition) {
  play(20);
  key(ctrl(kKeyF9));
  frames(3);
  type("frame == 7");
  key(shift(kKeyF9));
  frames(10);
  EXPECT_EQ(frame(), 7);
  key(kKeyEnter);
  frames(3);
  ASSERT_EQ(session().debugger().breakpoints().all().size(), 1u) << "the same one is not added twice";
  EXPECT_EQ(session().debugger().breakpoints().all()[0].condition, "frame == 7");
}

TEST_F(UiDebugger, AWrongConditionSaysWhereAndStopsNothing) {
  session().apply(action::SetBreakpoint{{.condition = "vy > 1"}});
  open_tab("breakpoints");
  click("breakpoints/1/condition");
  key(ctrl('a'));
  type("vz > 1");
  frames(3);
  EXPECT_EQ(session().debugger().breakpoints().all()[0].condition, "vy > 1");
}

TEST_F(UiDebugger, BreakpointsAndPlotsSurviveARestart) {
  session().apply(action::SetBreakpoint{{.condition = "vy > 1", .body = 2, .count = 3, .enabled = false}});
  session().apply(action::SetPlot{0, {"speed", 0}});
  key(kKeyF4);
  stop();
  start();
  EXPECT_TRUE(app().ui().view.window.dock_open);
  ASSERT_EQ(session().debugger().breakpoints().all().size(), 1u);
  const Breakpoint& kept = session().debugger().breakpoints().all()[0];
  EXPECT_EQ(kept.condition, "vy > 1");
  EXPECT_EQ(kept.body, 2);
  EXPECT_EQ(kept.count, 3);
  EXPECT_FALSE(kept.enabled);
  ASSERT_EQ(session().debugger().plots().all().size(), 1u);
  EXPECT_EQ(session().debugger().plots().all()[0].plot.text, "speed");
}

TEST_F(UiDebugger, ARecordingIsSavedFromTheMenuAndOpenedAgain) {
  play(25);
  const State last = session().state();
  key(ctrl_shift('e'));
  frames(3);
  click("files/confirm");
  frames(3);
  ASSERT_TRUE(std::filesystem::exists(path("level.talusrec")));
  drop(path("level.talusrec"));
  frames(5);
  EXPECT_EQ(timeline().last_frame(), 25);
  session().apply(action::SeekEnd{});
  EXPECT_EQ(session().state(), last);
}

TEST_F(UiDebugger, EditingRerunsTheRecordingIfTheMenuSaysSo) {
  play(60);
  click("menu/Debug");
  frames(2);
  click("menu/edit_rule");
  frames(2);
  click("menu/rule_from_start");
  frames(2);
  EXPECT_EQ(session().edit_rule().kind, EditRule::Kind::from_start);
  click(on_sheet(1));
  for (int x = 4; x <= 6; ++x) click(on_map({x, 13}));
  frames(10);
  EXPECT_EQ(timeline().last_frame(), 60);
  EXPECT_EQ(timeline().branches().size(), 2u) << "a stroke of edits makes one branch";
  ASSERT_TRUE(timeline().parting_frame());
  EXPECT_LE(ball().box.bottom(), 13 * 8 + 0.01);
}

TEST_F(UiDebugger, PlotsGrowAndAClickShowsTheFrame) {
  choose_ball();
  open_tab("plots");
  click("plots/choose");
  frames(2);
  click("plots/choose_vy");
  frames(2);
  play(30);
  frames(3);
  const auto& plots = session().debugger().plots();
  ASSERT_EQ(plots.all().size(), 1u);
  const Series* series = plots.series(plots.all()[0]);
  ASSERT_NE(series, nullptr);
  EXPECT_EQ(series->frames(), 31);
  EXPECT_EQ(series->points().back().last, ball().velocity.y);
  const Widget* plot = find("plots/0/plot");
  ASSERT_NE(plot, nullptr);
  click(ImVec2{plot->min.x + (plot->max.x - plot->min.x) * 0.5f, (plot->min.y + plot->max.y) / 2});
  EXPECT_EQ(frame(), 15);
}

// The article's ball sticks at the end of the slope, and the exact solver's passes.
TEST_F(UiDebugger, FindsWhereAnotherSolverDiffers) {
  start(source_path("assets/hard_cases/03-step-with-a-slope.talus.json"));
  Tuning tuning = level().tuning;
  tuning.solver = SolverKind::article;
  session().apply(action::EditLevel{set_tuning(level(), tuning)});
  choose_ball();
  play(60);
  open_tab("compare");
  click("compare/with");
  frames(2);
  click("compare/exact");
  frames(20);
  ASSERT_NE(session().other_state(), nullptr);
  EXPECT_EQ(session().other_state()->frame, frame());
  click("compare/first");
  frames(20);
  const std::int64_t parting = frame();
  const auto apart = [&] {
    return differences(session().state(), *session().other_state()).front().distance;
  };
  if (parting == 60) GTEST_FAIL() << "they do not part";
  EXPECT_GT(apart(), 0.01);
  key(shift(kKeyF10));
  frames(3);
  EXPECT_LE(apart(), 0.01);
}

TEST_F(UiDebugger, StagesAreWalkedThroughByKey) {
  choose_ball();
  for (int i = 0; i < 200 && session().record().contacts.empty(); ++i) play(1);
  ASSERT_FALSE(session().record().contacts.empty());
  click("tabs/why");
  frames(2);
  const auto& stages = session().stages();
  ASSERT_GE(stages.size(), 4u);
  EXPECT_EQ(stages.front().kind, StageKind::wanted);
  EXPECT_EQ(stages.back().kind, StageKind::arrived);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    key(kKeyF11);
    EXPECT_EQ(app().ui().view.debugger.stage, static_cast<int>(i));
  }
  key(shift(kKeyF11));
  EXPECT_EQ(app().ui().view.debugger.stage, static_cast<int>(stages.size()) - 2);
  click("why/stage0");
  EXPECT_EQ(app().ui().view.debugger.stage, 0);
  const auto shown = [&] { return app().ui().view.debugger.shown_stage(ImGui::GetFrameCount()); };
  move(centre("why/stage1"));
  frames(2);
  EXPECT_EQ(shown(), 1) << "the one under the mouse";
  move(on_canvas("play", {20, 20}));
  frames(3);
  EXPECT_EQ(shown(), 0);
}

}  // namespace talus::debugger_test
