// A tour of the debugger: what it says of breakpoints, comparisons and the timeline, by mouse and by key.
#include <algorithm>

#include "debugger_harness.h"
#include "panels/canvas/other_side.h"
#include "panels/commands/commands.h"
#include "panels/debugger/compare_choice.h"
#include "paths.h"

namespace talus::debugger_walk_test {

class UiDebuggerWalk : public DebuggerTest {
 protected:
  static constexpr KeyChord kEnter{SDLK_RETURN};
  void open_tab(const std::string& id) {
    app().ui().view.window.dock_open = true;
    frames(3);
    click("tabs/" + id);
    frames(3);
  }
  ImVec2 size_of(std::string_view name) {
    const Widget* widget = find(name);
    return widget != nullptr ? ImVec2{widget->max.x - widget->min.x, widget->max.y - widget->min.y}
                             : ImVec2{};
  }
  bool is_enabled(CommandId command) { return find_command(command).is_enabled(session(), app().ui()); }
  DebuggerView& view() { return app().ui().view.debugger; }
  const auto& breakpoints() { return session().debugger().breakpoints().all(); }
};

TEST_F(UiDebuggerWalk, AComparisonStaysBeyondTheOtherBranchsEnd) {
  play(10);
  session().apply({action::SeekFrame{4}, action::TakeOver{}});
  play(20);
  session().apply(action::CompareBranch{1});
  open_tab("compare");
  ASSERT_EQ(frame(), 24);
  EXPECT_EQ(session().other_state(), nullptr);
  EXPECT_EQ(missing_side(session()), "branch 1 ends at frame 10");
  EXPECT_NE(find("compare/plot"), nullptr);
  EXPECT_NE(find("compare/missing"), nullptr);
  EXPECT_TRUE(is_enabled("compare/first"_command));
  key(kKeyF7);
  frames(2);
  EXPECT_NE(find("play/other_side"), nullptr) << "the second view stays, and says so";
  click("compare/end");
  frames(2);
  EXPECT_EQ(frame(), 10);
  EXPECT_EQ(missing_side(session()), "");
}

TEST_F(UiDebuggerWalk, ARunningComparisonCanBeCancelled) {
  for (int i = 0; i < 300; ++i) session().apply(action::StepFrame{});
  EXPECT_FALSE(is_enabled("timeline/cancel"_command));
  session().apply(action::CompareVariant{Variant{SolverKind::exact, false}});
  EXPECT_EQ(missing_side(session()), "exact is run: 0 %");
  key(shift(kKeyF5));
  EXPECT_FALSE(is_compared(session()));
}

TEST_F(UiDebuggerWalk, TheKeyOfAComparisonNamesIt) {
  play(3);
  key(shift(kKeyF7));
  ASSERT_TRUE(session().message());
  EXPECT_EQ(session().message()->text, "Compared with exact.");
  EXPECT_EQ(shown_side_name(session()), "article");
  EXPECT_EQ(other_side_name(session()), "exact");
  session().apply(action::SelectBody{ball().id});
  frames(3);
  EXPECT_EQ(chosen_on_other_side(session()), ball().id);
  ASSERT_TRUE(frames_until([&] { return session().other_frame() != nullptr; }));
  EXPECT_EQ(session().other_frame()->state, *session().other_state());
  EXPECT_EQ(session().other_trail(ball().id, 0, frame()).size(), 4u);
}

TEST_F(UiDebuggerWalk, TheLegendFoldsAndIsRemembered) {
  ASSERT_NE(find("play/legend"), nullptr);
  const float open = size_of("play/legend").x;
  click("play/legend");
  frames(2);
  const float folded = size_of("play/legend").x;
  EXPECT_LT(folded, open / 2);
  EXPECT_EQ(session().choices().body, 0) << "the click was not for what is below";
  stop();
  start();
  frames(2);
  EXPECT_EQ(size_of("play/legend").x, folded);
  key(alt('l'));
  frames(2);
  EXPECT_EQ(size_of("play/legend").x, open);
}

TEST_F(UiDebuggerWalk, ATightLegendHasOnlySwatches) {
  for (const Overlay* overlay : all_overlays()) session().apply(action::SetOverlay{overlay, true});
  frames(2);
  const ImVec2 legend = size_of("play/legend"), canvas = size_of("play/canvas");
  EXPECT_LT(legend.x * legend.y, 0.1f * canvas.x * canvas.y);
  EXPECT_LE(find("play/legend")->max.y, find("play/canvas")->max.y);
}

TEST_F(UiDebuggerWalk, HomeAndEndGoToTheEndsOfTheRecording) {
  play(6);
  key(kKeyHome);
  EXPECT_EQ(frame(), 0);
  EXPECT_EQ(timeline().branches().size(), 1u);
  click("transport/last");
  EXPECT_EQ(frame(), 6);
  click("transport/first");
  EXPECT_EQ(frame(), 0);
  EXPECT_EQ(timeline().last_frame(), 6);
  key(shift(kKeyHome));
  EXPECT_EQ(timeline().branches().size(), 2u) << "a new one; the old one stays";
  EXPECT_EQ(timeline().last_frame(), 0);
}

TEST_F(UiDebuggerWalk, AnOpenListHasTheKeys) {
  play(2);
  const ImVec2 before = on_map({4, 4});
  key(alt_shift('t'));
  frames(4);
  key(kKeyDown);
  frames(2);
  key(kKeyUp);
  frames(2);
  key(kKeyDown);
  frames(2);
  key(kEnter);
  frames(3);
  EXPECT_EQ(level().tuning.solver, SolverKind::bump);
  const ImVec2 after = on_map({4, 4});
  EXPECT_EQ(after.x, before.x);
  EXPECT_EQ(after.y, before.y) << "the map has not scrolled";
}

TEST_F(UiDebuggerWalk, TheFirstLetterGoesToTheOpenedField) {
  push_stroke(ctrl(kKeyF9));
  push_typing("frame > 3");
  frames(20);
  EXPECT_FALSE(session().choices().flag_overlay) << "f tints the map";
  key(kEnter);
  frames(2);
  ASSERT_EQ(breakpoints().size(), 1u);
  EXPECT_EQ(breakpoints()[0].condition, "frame > 3");
}

TEST_F(UiDebuggerWalk, TheRowThatStoppedIsMarkedWhileItsFrameIsShown) {
  session().apply(action::SetBreakpoint{{.condition = "frame == 1000"}});
  session().apply(action::SetBreakpoint{{.condition = "frame == 4"}});
  open_tab("breakpoints");
  key(kKeyF9);
  frames(20);
  ASSERT_EQ(frame(), 4);
  EXPECT_NE(find("breakpoints/2/stopped"), nullptr);
  EXPECT_NE(find("breakpoints/1/number"), nullptr);
  EXPECT_NE(find("breakpoints/2/hits"), nullptr);
  play(1);
  EXPECT_EQ(find("breakpoints/2/stopped"), nullptr);
}

TEST_F(UiDebuggerWalk, ReplayingIsShownAndCanBeTakenOver) {
  play(200);
  session().apply({action::SeekFrame{3}});
  frames(2);
  EXPECT_EQ(find("status/replaying"), nullptr);
  key(kKeyF5);
  frames(3);
  EXPECT_NE(find("status/replaying"), nullptr);
  click("timeline/take_over");
  frames(3);
  EXPECT_EQ(timeline().branches().size(), 2u);
  EXPECT_FALSE(timeline().in_past());
  EXPECT_EQ(find("status/replaying"), nullptr);
}

TEST_F(UiDebuggerWalk, TheRuleForEditsIsBesideTheTimeline) {
  play(5);
  click("timeline/edit_rule");
  frames(2);
  click("timeline/rule_from_start");
  frames(2);
  EXPECT_EQ(session().edit_rule().kind, EditRule::Kind::from_start);
}

TEST_F(UiDebuggerWalk, ACellForABreakpointIsClickedOrPicked) {
  open_tab("breakpoints");
  session().apply(action::SelectCells{CellRect{7, 3, 2, 2}});
  frames(2);
  key(alt('a'));
  frames(8);
  ASSERT_EQ(breakpoints().size(), 1u);
  EXPECT_EQ(breakpoints()[0].condition, "touches(7, 3)");
  session().apply(action::SelectCells{});
  const Level before = level();
  click("breakpoints/pick");
  frames(2);
  click(on_map({12, 2}));
  frames(2);
  EXPECT_EQ(level(), before) << "the click picked, and painted nothing";
  click("breakpoints/add");
  frames(2);
  ASSERT_EQ(breakpoints().size(), 2u);
  EXPECT_EQ(breakpoints()[1].condition, "touches(12, 2)");
  key(alt('i'));
  frames(6);
  EXPECT_TRUE(view().picks_cell);
  key(kKeyEscape);
  EXPECT_FALSE(view().picks_cell);
}

TEST_F(UiDebuggerWalk, TheWheelZoomsTheTimelineAroundTheMouse) {
  play(200);
  session().apply(action::SetPlot{0, {"frame", 0}});
  open_tab("plots");
  const Widget* track = find("timeline/track");
  ASSERT_NE(track, nullptr);
  const float y = (track->min.y + track->max.y) / 2;
  const auto at = [&](float share) {
    return ImVec2{track->min.x + (track->max.x - track->min.x) * share, y};
  };
  click(at(0.25f));
  const std::int64_t kept = frame();
  ASSERT_NEAR(static_cast<double>(kept), 50, 2);
  wheel(6);
  frames(2);
  EXPECT_NEAR(view().frames.count, 200 / 3.815, 0.1);
  click(at(0.25f));
  EXPECT_NEAR(static_cast<double>(frame()), static_cast<double>(kept), 1) << "what is under the mouse stays";
  click(at(0.9f));
  EXPECT_LT(frame(), 100);
  const std::int64_t late = frame();
  const Widget* plot = find("plots/0/plot");
  ASSERT_NE(plot, nullptr);
  click(ImVec2{plot->min.x + (plot->max.x - plot->min.x) * 0.9f, (plot->min.y + plot->max.y) / 2});
  EXPECT_NEAR(static_cast<double>(frame()), static_cast<double>(late), 2) << "the plots show the same frames";
  const double first = view().frames.first;
  drag(at(0.5f), at(0.4f), kMiddle);
  EXPECT_GT(view().frames.first, first + 3);
  key(alt('0'));
  EXPECT_EQ(view().frames, FrameZoom{});
  key(alt('='));
  EXPECT_NE(view().frames, FrameZoom{});
  key(kKeyEnd);
  frames(2);
  EXPECT_NEAR(view().frames.first + view().frames.count, 200, 1) << "the shown frame stays in sight";
}

TEST_F(UiDebuggerWalk, TuningIsChangedByKeys) {
  const TuningField& first = tuning_fields()[0];
  const double before = first.of(level().tuning);
  key(alt('t'));
  frames(8);
  key(ctrl('a'));
  const double other = before == first.max ? first.min : first.max;
  type(std::to_string(other));
  key(kEnter);
  frames(3);
  EXPECT_NEAR(first.of(level().tuning), other, 1e-6);
}

TEST_F(UiDebuggerWalk, AKindOfBreakpointIsChosenAndAddedByKeys) {
  key(alt('k'));
  frames(8);
  for (int i = 0; i < 6; ++i) {
    key(kKeyDown);
    frames(2);
  }
  key(kEnter);
  frames(8);
  key(ctrl('a'));
  type("2.5");
  key(kEnter);
  frames(2);
  key(alt('a'));
  frames(8);
  ASSERT_EQ(breakpoints().size(), 1u);
  EXPECT_EQ(breakpoints()[0].condition, "speed > 2.5");
}

TEST_F(UiDebuggerWalk, TheViewFollowsTheChosenBody) {
  session().apply(action::SelectBody{ball().id});
  move(on_canvas("play", {200, 20}));
  wheel(12);
  frames(2);
  const auto in_sight = [&] {
    const Widget* canvas = find("play/canvas");
    const ImVec2 at = on_canvas("play", ball().box.center());
    return at.x > canvas->min.x && at.x < canvas->max.x && at.y > canvas->min.y && at.y < canvas->max.y;
  };
  ASSERT_FALSE(in_sight());
  key(alt('f'));
  frames(3);
  EXPECT_TRUE(in_sight());
}

TEST_F(UiDebuggerWalk, AnotherFileEndsComparisonAndStop) {
  drop(source_path("assets/hard_cases/03-step-with-a-slope.talus.json"));
  frames(3);
  EXPECT_TRUE(session().choices().overlays.has(overlay::answer));
  session().apply(action::SetBreakpoint{{.condition = "frame == 4"}});
  session().apply(action::RunToBreakpoint{SearchDirection::forwards});
  frames(20);
  ASSERT_TRUE(session().debugger().stop());
  session().apply(action::CompareVariant{Variant{SolverKind::article, false}});
  frames(3);
  drop(save_test_level("other.talus.json"));
  frames(3);
  EXPECT_FALSE(is_compared(session()));
  EXPECT_FALSE(session().debugger().stop());
  EXPECT_FALSE(session().choices().overlays.has(overlay::answer));
  ASSERT_EQ(breakpoints().size(), 1u);
  EXPECT_FALSE(breakpoints()[0].enabled) << "kept, and switched off: its bodies were the old level's";
}

}  // namespace talus::debugger_walk_test
