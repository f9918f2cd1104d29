// The panel of problems: going from one to the next, filtering, and repairing a broken level by its buttons
// alone; and showing where a player can get to.
#include <imgui_internal.h>

#include "harness.h"
#include "level/lint/lint.h"
#include "level/single_change.h"
#include "panels/level/problem_list.h"
#include "paths.h"

namespace talus::problems_test {

class UiProblems : public UiTest {
 protected:
  // Starts on a copy of the level with five problems: two slopes without their right halves, two seams, a
  // tile with contradicting flags, and a player inside a wall.
  void start_broken(int width = 1280, int height = 720) {
    const std::string copy = path("broken.talus.json");
    std::filesystem::copy_file(source_path("tests/ui/broken.talus.json"), copy);
    start(copy, width, height);
    frames(8);  // the lint and the fixes are computed a few at a time
  }

  std::vector<std::string> codes() {
    std::vector<std::string> codes;
    for (const Problem& problem : *app().ui().problems) codes.emplace_back(problem.rule->code);
    return codes;
  }
  std::string row_of(const std::string& code) {
    const std::vector<std::string> all = codes();
    return std::to_string(std::find(all.begin(), all.end(), code) - all.begin());
  }
  std::string last_edit() { return session().history().edits().back().label; }
};

TEST_F(UiProblems, ABrokenLevelIsRepairedFromThePanelAlone) {
  start_broken();
  ASSERT_EQ(codes(), (std::vector<std::string>{"flags-conflict", "spawn-in-solid", "slope-half-missing",
                                               "slope-half-missing", "seam", "seam"}));

  click("problems/row" + row_of("spawn-in-solid"));  // see where it is first
  EXPECT_EQ(app().ui().view.canvas.marked_cell, (Cell{25, 13}));
  click("problems/fix" + row_of("spawn-in-solid"));
  EXPECT_EQ(level().spawns[0].position, (Vec2{204, 96}));  // on top of the wall
  EXPECT_EQ(last_edit(), "Move body \"hero\" up by 12 px to 204, 96 px");
  EXPECT_EQ(app().ui().view.canvas.marked_cell, std::nullopt) << "there is no problem any more";
  ASSERT_TRUE(session().message());
  EXPECT_EQ(session().message()->text, last_edit() + ": done. Ctrl+Z takes it back.");
  frames(4);

  click("problems/fix" + row_of("flags-conflict"));
  EXPECT_EQ(level().tile_flags(8), 1);
  frames(4);

  click("problems/kind");
  click("problems/kind_slope-half-missing");
  click("problems/fix_all");
  EXPECT_EQ(tile_at({11, 14}), 4);
  EXPECT_EQ(tile_at({15, 14}), 6);
  EXPECT_EQ(last_edit(), "Fix 2 problems: slope without its right half");
  frames(4);

  click("problems/kind");
  click("problems/kind_all");
  frames(4);
  ASSERT_EQ(codes(), (std::vector<std::string>{"seam", "seam"}));
  click("problems/fix0");
  EXPECT_EQ(tile_at({18, 14}), 33);
  frames(4);
  click("problems/fix0");
  EXPECT_EQ(level().tile_shapes[40].heights, (std::vector<double>{0, 8}));
  frames(4);

  EXPECT_EQ(codes(), std::vector<std::string>());
  EXPECT_EQ(session().history().edits().size(), 5u);
  key(ctrl('s'));
  EXPECT_FALSE(session().modified());
  for (int i = 0; i < 5; ++i) key(ctrl('z'));
  frames(8);
  EXPECT_EQ(codes().size(), 6u);
}

// From the nearest to the player on.
TEST_F(UiProblems, KeysGoFromOneToTheNextAndFixIt) {
  start_broken();
  const auto& chosen = app().ui().view.level.problems.chosen;
  const auto& marked = app().ui().view.canvas.marked_cell;
  key(kKeyF8);
  EXPECT_EQ(chosen->rule->code, "flags-conflict");
  key(kKeyF8);
  EXPECT_EQ(chosen->rule->code, "spawn-in-solid");
  key(kKeyF8);
  EXPECT_EQ(marked, (Cell{21, 14}));
  key(kKeyF8);
  EXPECT_EQ(marked, (Cell{17, 14}));
  key(kKeyF8);
  EXPECT_EQ(marked, (Cell{14, 14}));
  key(alt(kKeyF8));
  EXPECT_EQ(tile_at({15, 14}), 6);
  frames(4);
  key(kKeyF8);  // goes to the problem that took the row of the fixed one
  EXPECT_EQ(marked, (Cell{10, 14}));
  key(kKeyF8);  // wraps around to the first problem
  EXPECT_EQ(chosen->rule->code, "flags-conflict");
  key(shift(kKeyF8));
  EXPECT_EQ(marked, (Cell{10, 14}));
}

TEST_F(UiProblems, GoingToAVisibleCellKeepsTheView) {
  start_broken(2560, 1440);
  const ImVec2 before = on_map({0, 0});
  click("problems/row" + row_of("spawn-in-solid"));
  frames(2);
  EXPECT_EQ(app().ui().view.canvas.marked_cell, (Cell{25, 13}));
  EXPECT_EQ(on_map({0, 0}).x, before.x);
  EXPECT_EQ(on_map({0, 0}).y, before.y);
  for (int i = 0; i < 30; ++i) key(kKeyLeft);  // all cells are scrolled out
  key(kKeyF8);
  frames(2);
  const ImVec2 shown = on_map({21, 14}), middle = centre("map/canvas");
  EXPECT_NEAR(shown.x, middle.x, 40);
  EXPECT_NEAR(shown.y, middle.y, 40);
}

// Where the followed body is, or stopped.
TEST_F(UiProblems, TheNearestAreListedFirst) {
  start_broken();
  session().apply(action::Pause{});
  for (const auto& [x, nearest, farthest] : {std::tuple(10 * 8, "slope-half-missing", "flags-conflict"),
                                             std::tuple(21 * 8, "seam", "slope-half-missing")}) {
    Spawn spawn = level().spawns.at(0);
    spawn.position = {static_cast<double>(x), 14 * 8};
    session().apply(action::EditLevel{change_spawn(level(), 0, spawn, "Move")});
    move(centre("map/canvas"));
    frames(8);
    for (int i = 0; i < 100 && session().is_linting(); ++i) frames();
    const auto& problems = *app().ui().problems;
    std::vector<std::size_t> rows = listed_rows(app().ui());
    std::erase_if(rows, [&](std::size_t row) { return problems[row].rule->code == "spawn-in-solid"; });
    EXPECT_EQ(problems[rows.front()].rule->code, nearest) << x;
    EXPECT_EQ(problems[rows.back()].rule->code, farthest) << x;
  }
}

// A row that moved away under the mouse was not fixed.
TEST_F(UiProblems, RowsStayWhileOneIsPressed) {
  start_broken();
  session().apply(action::Pause{});
  frames(8);
  const std::vector<std::size_t> rows = listed_rows(app().ui());
  move(centre("problems/row" + std::to_string(rows.front())));
  press();
  Spawn spawn = level().spawns.at(0);
  spawn.position.x += 11 * 8;
  session().apply(action::EditLevel{change_spawn(level(), 0, spawn, "Move")});
  const auto near = app().ui().view.level.problems.near;
  frames(8);
  EXPECT_EQ(app().ui().view.level.problems.near, near);
  release();
}

TEST_F(UiProblems, FurtherFixesAreInTheMenuOfTheRow) {
  start_broken();
  key(kKeyF8);
  key(kKeyF8);  // 3 px up to the wall
  frames(2);
  click("problems/row5", kRight);
  ASSERT_NE(find("problems/choice0"), nullptr);
  click("problems/choice_kind");
  frames(2);  // the list scrolls back to its remaining rows
  EXPECT_EQ(app().ui().view.level.problems.kind->code, "seam");
  EXPECT_EQ(find("problems/row0"), nullptr);
  ASSERT_NE(find("problems/row5"), nullptr);
  click("problems/seam");  // allows jumps of up to 3 px
  key(ctrl('a'));
  type("3");
  frames(4);
  EXPECT_EQ(session().lint_options().seam, 3);
  EXPECT_EQ(codes().size(), 5u);
}

TEST_F(UiProblems, TheProgressOnALargeLevelIsShown) {
  Level level = test_level();
  level.map = TileMap(2048, 512);
  for (std::size_t i = 0; i < level.map.cells().size(); i += 30) level.map.cells().tiles()[i] = 3;
  const std::string file = path("large.talus.json");
  ASSERT_TRUE(save_level(level, *format_for_file(file), file));
  start(file);
  ASSERT_TRUE(session().is_linting());
  EXPECT_NE(problems_text(session(), app().ui()).find("looking... "), std::string::npos);
  double before = -1;
  for (int i = 0; i < 20'000 && session().is_linting(); ++i) {
    EXPECT_GE(session().lint_progress(), before);
    EXPECT_LT(session().lint_progress(), 1);
    before = session().lint_progress();
    session().advance(0);
  }
  EXPECT_GT(before, 0.5);
  EXPECT_EQ(session().lint_progress(), 1);
  frames(2);
  EXPECT_EQ(problems_text(session(), app().ui()).find("looking"), std::string::npos);
}

TEST_F(UiProblems, FarCellsAreNotCutOff) {
  Level level = test_level();
  level.map = TileMap(1 << 18, 1);
  level.map.set({200'000, 0}, 3);
  const std::string file = path("long.talus.json");
  ASSERT_TRUE(save_level(level, *format_for_file(file), file));
  start(file, 1152, 700);
  for (int i = 0; i < 100'000 && session().is_linting(); ++i) frames();
  ASSERT_FALSE(session().is_linting());
  const std::string row = "problems/row" + row_of("slope-half-missing");
  frames(2);
  const Widget* widget = find(row);
  ASSERT_NE(widget, nullptr);
  // The place takes a line of its own, and the message several.
  EXPECT_GT(widget->max.y - widget->min.y, 3 * 14);
  click(row);
  EXPECT_EQ(app().ui().view.canvas.marked_cell, (Cell{200'000, 0}));
}

TEST_F(UiProblems, ReachableCellsAreMarked) {
  start_broken();
  key(kKeyF8);
  click("problems/fix" + row_of("spawn-in-solid"));
  key(kKeyF12);
  EXPECT_TRUE(session().choices().overlays.has(overlay::reach));
  ASSERT_NE(session().reach().found(), nullptr);
  for (int i = 0; i < 2000 && session().reach().running(); ++i) frames();
  const ReachSearch& found = *session().reach().found();
  EXPECT_TRUE(found.finished());
  EXPECT_TRUE(found.reached({20, 14}));
  EXPECT_FALSE(found.reached({25, 14}));  // in the wall

  move(on_map({20, 14}));
  frames(2);
  const std::size_t way = found.way_to({20, 14}).size();
  EXPECT_GT(way, 0u);
  key('w');
  EXPECT_EQ(session().state().frame, static_cast<std::int64_t>(way));
  const Rect box = session().state().bodies.back().box;
  EXPECT_LT(box.x, 21 * 8);
  EXPECT_GT(box.right(), 20 * 8);

  key(ctrl('z'));  // the player is in the wall again
  frames(2);
  EXPECT_TRUE(session().reach().is_stale());
  EXPECT_NE(find("reach/stale"), nullptr);
}

TEST_F(UiProblems, AFixSaysWhatItWillDo) {
  start_broken();
  frames(8);
  const std::string fix = "problems/fix" + row_of("spawn-in-solid");
  move(centre("problems/row" + row_of("spawn-in-solid")));
  frames(60);
  const ImGuiWindow* tooltip = ImGui::FindWindowByName("##Tooltip_00");
  ASSERT_TRUE(tooltip != nullptr && tooltip->Active);
  const float of_row = tooltip->Size.x;
  move(centre(fix));
  frames(60);
  ASSERT_TRUE(tooltip->Active);
  EXPECT_GT(tooltip->Size.x, of_row) << "Move spawn ... is longer than the name of the rule";
  EXPECT_TRUE(session().history().edits().empty());
}

TEST_F(UiProblems, ThePanelPlaysTheInputToAMarkedCell) {
  start_broken();
  key(kKeyF8);
  click("problems/fix" + row_of("spawn-in-solid"));
  key(kKeyF12);
  for (int i = 0; i < 2000 && session().reach().running(); ++i) frames();
  app().ui().view.window.dock_open = true;
  app().ui().view.canvas.mode = CanvasMode::play;
  frames(2);
  click("tabs/reach");
  frames(2);
  EXPECT_EQ(find("reach/play_way"), nullptr);
  move(on_canvas("play", {20 * 8 + 4, 14 * 8 + 4}));
  frames(2);
  const std::size_t way = session().reach().found()->way_to({20, 14}).size();
  ASSERT_GT(way, 0u);
  ASSERT_NE(find("reach/play_way"), nullptr);
  click(on_canvas(
      "play", {20 * 8 + 4, 14 * 8 + 4}));  // so that the mouse crosses no other cell on its way to the panel
  move(on_canvas("play", {10 * 8 + 4, 14 * 8 + 4}));
  click("reach/play_way");
  EXPECT_EQ(session().state().frame, static_cast<std::int64_t>(way));
}

}  // namespace talus::problems_test
