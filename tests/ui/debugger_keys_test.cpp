// The debugger without a mouse: branches, the input roll, breakpoints, plots and comparison by keys alone.
#include <imgui_internal.h>

#include <algorithm>

#include "debugger_harness.h"
#include "panels/canvas/case_note.h"
#include "panels/commands/commands.h"
#include "panels/debugger/compare_choice.h"
#include "paths.h"

namespace talus::debugger_keys_test {

class UiDebuggerKeys : public DebuggerTest {
 protected:
  const auto& breakpoints() { return session().debugger().breakpoints().all(); }
  const auto& plots() { return session().debugger().plots().all(); }
  static constexpr KeyChord kEnter{SDLK_RETURN};
};

TEST_F(UiDebuggerKeys, SeekByTensAndToBothEnds) {
  play(25);
  key(ctrl(kKeyLeft));
  EXPECT_EQ(frame(), 15);
  key(ctrl(kKeyRight));
  EXPECT_EQ(frame(), 25);
  key(ctrl(kKeyLeft));
  key(kKeyHome);
  EXPECT_EQ(frame(), 0);
  EXPECT_EQ(timeline().branches().size(), 1u) << "no new branch is begun";
  key(ctrl(kKeyRight));
  EXPECT_EQ(frame(), 10);
  key(kKeyEnd);
  EXPECT_EQ(frame(), 25);
  key(ctrl(kKeyF10));
  frames(2);
  key(ctrl('a'));
  type("7");
  key(kEnter);
  EXPECT_EQ(frame(), 7);
}

TEST_F(UiDebuggerKeys, MakeGoToAndDropBranches) {
  play(20);
  key(ctrl(kKeyLeft));
  key(ctrl('b'));
  play(3);
  ASSERT_EQ(timeline().branches().size(), 2u);
  const int made = timeline().current().id;
  EXPECT_EQ(timeline().last_frame(), 13);
  key(alt(kKeyDown));
  EXPECT_EQ(timeline().current().id, 1);
  key(alt(kKeyDown));
  EXPECT_EQ(timeline().current().id, made);
  key(alt(kKeyUp));
  EXPECT_EQ(timeline().current().id, 1);
  key(alt(kKeyDelete));
  frames(2);
  click("question/drop");
  ASSERT_EQ(timeline().branches().size(), 1u);
  EXPECT_EQ(timeline().current().id, made);
}

TEST_F(UiDebuggerKeys, SetAndClearCellsOfTheInputRoll) {
  play(12);
  key(kKeyF6);
  frames(2);
  EXPECT_TRUE(app().ui().view.window.dock_open);
  ASSERT_NE(find("input_roll/jump"), nullptr);
  key(kKeyDown);
  key(kKeyDown);  // jump
  for (int i = 0; i < 4; ++i) key(kKeyLeft);
  ASSERT_EQ(frame(), 8);
  for (int i = 0; i < 3; ++i) key(shift(kKeyLeft));
  ASSERT_EQ(frame(), 5);
  key(' ');
  frames(5);
  EXPECT_EQ(timeline().branches().size(), 2u);
  for (std::int64_t f = 1; f <= 12; ++f) EXPECT_EQ(timeline().current().input(f).jump, f >= 5 && f <= 8) << f;
  EXPECT_EQ(timeline().last_frame(), 12);
  key(kKeyRight);  // ends the range
  EXPECT_EQ(frame(), 6);
  key(' ');
  frames(5);
  EXPECT_FALSE(timeline().current().input(6).jump);
  EXPECT_TRUE(timeline().current().input(7).jump);
  key(kKeyF3);
  EXPECT_EQ(app().ui().view.window.focus, Focus::map);
  key(kKeyLeft);
  EXPECT_EQ(frame(), 6) << "the map has the keys again";
}

// Frame 0 has no input, so the mouse's place of a range is not shown there.
TEST_F(UiDebuggerKeys, GoToTheFirstFrameWithARangeOfTheInputRoll) {
  play(6);
  key(kKeyF6);
  frames(2);
  for (int i = 0; i < 3; ++i) key(shift(kKeyLeft));
  session().apply(action::SeekFrame{0});
  frames(2);
  EXPECT_EQ(frame(), 0);
  EXPECT_EQ(timeline().last_frame(), 6);
}

TEST_F(UiDebuggerKeys, TypeThePlaceOfTheMouse) {
  play(6);
  key(kKeyF6);
  frames(2);
  key(kKeyLeft);
  key('m');
  frames(2);
  key(ctrl('a'));
  type("33.5");
  key(kKeyTab);
  key(ctrl('a'));
  type("21");
  key(kEnter);
  frames(5);
  EXPECT_EQ(timeline().current().input(5).mouse, (Vec2{33.5, 21}));
  EXPECT_EQ(timeline().current().input(4).mouse, Vec2{});
  EXPECT_EQ(timeline().last_frame(), 6);
}

TEST_F(UiDebuggerKeys, AddChangeSwitchAndRemoveABreakpoint) {
  play(3);
  key(ctrl(kKeyF9));
  frames(3);
  type("vy > 9");
  key(kEnter);
  frames(2);
  ASSERT_EQ(breakpoints().size(), 1u);
  EXPECT_EQ(breakpoints()[0].condition, "vy > 9");
  EXPECT_TRUE(breakpoints()[0].enabled);
  key(ctrl_shift(kKeyF9));
  EXPECT_FALSE(breakpoints()[0].enabled);
  key(ctrl_shift(kKeyF9));
  EXPECT_TRUE(breakpoints()[0].enabled);

  key(ctrl(kKeyF9));
  frames(3);
  key(kKeyDown);
  frames(3);
  key(ctrl('a'));
  type("vy > 8");
  key(kEnter);
  frames(2);
  EXPECT_EQ(breakpoints()[0].condition, "vy > 8");
  key(ctrl(kKeyF9));
  frames(3);
  key(kKeyDown);
  frames(3);
  key(ctrl(SDLK_RETURN));
  frames(2);
  EXPECT_FALSE(breakpoints()[0].enabled);

  key(ctrl(kKeyF9));
  frames(3);
  key(kKeyDown);
  frames(3);
  key(ctrl('a'));
  key(kKeyDelete);
  key(kEnter);
  frames(2);
  EXPECT_TRUE(breakpoints().empty());
}

TEST_F(UiDebuggerKeys, AddChangeAndRemoveAPlot) {
  key(ctrl(kKeyF8));
  frames(3);
  type("vy * 2");
  key(kEnter);
  frames(2);
  ASSERT_EQ(plots().size(), 1u);
  EXPECT_EQ(plots()[0].plot.text, "vy * 2");
  const auto go_to_first = [&] {
    key(ctrl(kKeyF8));
    frames(3);
    key(kKeyDown);
    frames(3);
    key(ctrl('a'));
  };
  go_to_first();
  type("vx");
  key(kEnter);
  frames(2);
  EXPECT_EQ(plots()[0].plot.text, "vx");
  go_to_first();
  key(kKeyDelete);
  key(kEnter);
  frames(2);
  EXPECT_TRUE(plots().empty());
  key(ctrl_shift(kKeyF8));
  frames(2);
  EXPECT_NE(find("plots/times/plot"), nullptr);
}

TEST_F(UiDebuggerKeys, CompareWithEachInTurn) {
  play(10);
  std::vector<std::string> seen;
  for (int i = 0; i < 5; ++i) {
    key(shift(kKeyF7));
    frames(5);
    seen.push_back(compare_choice(session()).label);
  }
  EXPECT_EQ(seen,
            (std::vector<std::string>{"exact", "exact, single precision", "bump", "article", "nothing"}));
  key(shift(kKeyF7));
  frames(5);
  key(ctrl_shift(kKeyF7));
  ASSERT_EQ(breakpoints().size(), 1u);
  EXPECT_EQ(breakpoints()[0].condition, "parting > 0.01");
}

TEST_F(UiDebuggerKeys, AFieldKeepsTheKeysOfItsCursor) {
  play(20);
  key(ctrl(kKeyF8));
  frames(3);
  type("vx vy");
  key(ctrl(kKeyLeft));
  EXPECT_EQ(frame(), 20);
  type("* ");
  key(kEnter);
  frames(2);
  ASSERT_EQ(plots().size(), 1u);
  EXPECT_EQ(plots()[0].plot.text, "vx * vy");
}

TEST_F(UiDebuggerKeys, RulesForEditsAreChosenInTurn) {
  play(4);
  using Kind = EditRule::Kind;
  for (const Kind kind : {Kind::from_start, Kind::from_frame, Kind::go_on}) {
    key(alt('e'));
    EXPECT_EQ(session().edit_rule().kind, kind);
  }
}

TEST_F(UiDebuggerKeys, ACaseSaysThatItsOwnInputPlays) {
  EXPECT_EQ(case_note(session()), "");
  start(source_path("assets/hard_cases/13-downhill.talus.json"));
  EXPECT_EQ(case_note(session()), "The hard case holds Right; your keys count as well");
  session().apply(action::HoldKeys{.left = true, .right = false, .jump = false});
  EXPECT_EQ(case_note(session()),
            "The hard case holds Right and you hold the opposite key: the two cancel out");
}

TEST_F(UiDebuggerKeys, ACaseSaysWhoMakesItsEdits) {
  start(source_path("assets/hard_cases/66-crate-taken-away.talus.json"));
  EXPECT_EQ(case_note(session()), "Only the checks of the hard case make its edits; here you make your own");
  start(source_path("assets/hard_cases/44-stack.talus.json"));
  EXPECT_EQ(case_note(session()), "");
}

TEST_F(UiDebuggerKeys, AfterEnterAFieldOfPlotsKeepsTheKeys) {
  key(ctrl(kKeyF8));
  frames(3);
  const MapTool tool = session().choices().map_tool;
  const std::size_t edits = session().history().edits().size();
  push_typing("vx");
  push_stroke(kEnter);
  push_typing("vy");
  push_stroke(kEnter);
  frames(20);
  ASSERT_EQ(plots().size(), 2u);
  EXPECT_EQ(plots()[1].plot.text, "vy");
  push_typing("ghc90");  // each letter would be a command
  frames(10);
  EXPECT_EQ(session().choices().map_tool, tool);
  EXPECT_EQ(session().history().edits().size(), edits);
  EXPECT_TRUE(ImGui::GetIO().WantTextInput);
}

TEST_F(UiDebuggerKeys, NoHelpCoversTheErrorOfAnExpression) {
  key(ctrl(kKeyF8));
  frames(3);
  push_typing("vx +");
  frames(4);
  move(centre("plots/new"));
  frames(90);
  const ImGuiWindow* tooltip = ImGui::FindWindowByName("##Tooltip_00");
  EXPECT_TRUE(tooltip == nullptr || !tooltip->Active);
}

}  // namespace talus::debugger_keys_test
