// Proofs in the panel of problems: the button, the rows, and what an edit does.
#include <imgui_internal.h>

#include "harness.h"
#include "panels/canvas/fix_preview.h"
#include "panels/commands/commands.h"
#include "panels/level/problem_list.h"
#include "session/checks/prover.h"

namespace talus::prove_ui_test {

class UiProve : public UiTest {
 protected:
  // Starts on a level with a plate of half a px on its floor, and a player.
  void start_lipped() {
    Level level = test_level();
    level.tuning.solver = SolverKind::exact;
    level.map.set({5, 10}, 0);
    level.tile_shapes[7] = {.kind = TileShape::Kind::slope, .heights = {0.5, 0.5}};
    level.map.set({20, 15}, 7);
    Spawn player;
    player.kind = BodyKind::player;
    player.position = {16, 100};
    level.spawns = {player};
    const std::string file = path("lip.talus.json");
    ASSERT_TRUE(save_level(level, *format_for_file(file), file));
    start(file, 1280, 1000);
    app().ui().view.requests.ask(request::ShowTab("problems"));
    frames(8);
  }
  bool proof_ends() {
    return frames_until([&] { return !session().prover().running(); });
  }
};

TEST_F(UiProve, AClickOnARowShowsTheCell) {
  start_lipped();
  EXPECT_EQ(find("proof/summary"), nullptr);
  click("problems/prove");
  ASSERT_TRUE(proof_ends());
  frames(2);
  ASSERT_NE(session().prover().found(), nullptr);
  ASSERT_FALSE(session().prover().found()->findings.empty());
  EXPECT_NE(find("proof/summary"), nullptr);
  EXPECT_EQ(find("proof/stale"), nullptr);
  click("proof/row0");
  EXPECT_EQ(app().ui().view.canvas.marked_cell, session().prover().found()->findings[0].cell);
  EXPECT_EQ(app().ui().view.window.focus, Focus::map);
  EXPECT_TRUE(session().history().edits().empty());
}

TEST_F(UiProve, AClickOnARowPlaysTheFinding) {
  start_lipped();
  click("problems/prove");
  ASSERT_TRUE(proof_ends());
  frames(2);
  click("proof/row0");
  frames(2);
  EXPECT_EQ(session().state().bodies.size(), 1u);
  EXPECT_EQ(session().state().frame, session().prover().found()->findings[0].frame);
  EXPECT_NE(find("problems/prove"), nullptr) << "it can be proved again";
  const std::size_t count = session().prover().found()->findings.size();
  for (std::size_t i = 1; i <= count; ++i) {  // after the last one the first
    Actions actions;
    find_command("problems/next_finding"_command).run(session(), actions, app().ui());
    session().apply(actions);
    frames(2);
    EXPECT_EQ(session().state().frame, session().prover().found()->findings[i % count].frame);
  }
}

// Ten plates on the floor, and two bodies that are inside of the ground.
TEST_F(UiProve, ARowStaysUnderTheMouse) {
  Level level = test_level();
  level.tuning.solver = SolverKind::exact;
  level.map.set({5, 10}, 0);
  level.tile_shapes[7] = {.kind = TileShape::Kind::slope, .heights = {0.5, 0.5}};
  for (int x = 3; x < 30; x += 4) level.map.set({x, 15}, 7);
  for (const Vec2 at : {Vec2{16, 100}, Vec2{200, 130}, Vec2{40, 130}}) {
    Spawn& spawn = level.spawns.emplace_back();
    spawn.kind = BodyKind::crate;
    spawn.position = at;
  }
  const std::string file = path("plates.talus.json");
  ASSERT_TRUE(save_level(level, *format_for_file(file), file));
  start(file, 1280, 720);
  app().ui().view.requests.ask(request::ShowTab("problems"));
  frames(8);
  click("problems/prove");
  ASSERT_TRUE(proof_ends());
  frames(8);
  int rows = 0;
  while (find("proof/row" + std::to_string(rows)) != nullptr) ++rows;
  EXPECT_GE(rows, 4) << "the list has room";
  frames(120);
  const ImGuiWindow* tooltip = ImGui::FindWindowByName("##Tooltip_00");
  EXPECT_TRUE(tooltip == nullptr || !tooltip->Active) << "that of the button would cover the rows";
  const ImVec2 at = centre("proof/row1");
  click(at);
  for (int i = 0; i < 10; ++i) {
    frames(6);
    ASSERT_NE(find("proof/row1"), nullptr);
    EXPECT_EQ(centre("proof/row1").y, at.y);
  }
}

TEST_F(UiProve, TheOrderOfProblemsStaysUnderTheMouse) {
  start();
  session().apply(action::SelectBody{ball().id});
  ProblemsView view;
  note_followed_body(session(), true, view);
  EXPECT_FALSE(view.near);
  note_followed_body(session(), false, view);
  EXPECT_TRUE(view.near);
  session().apply(action::SelectBody{});  // as a finding, in which it does not play
  note_followed_body(session(), true, view);
  EXPECT_TRUE(view.near);
  note_followed_body(session(), false, view);
  EXPECT_FALSE(view.near);
}

TEST_F(UiProve, AnEditIsProvedAndAfterwardsAFindingIsGone) {
  start_lipped();
  click("problems/prove");
  ASSERT_TRUE(proof_ends());
  frames(2);
  EXPECT_NE(find("proof/row0"), nullptr);
  session().apply(action::EditLevel{Edit{"Paint", {CellChange{{20, 15}, 7, 0}}}});
  frames(2);
  ASSERT_TRUE(proof_ends());
  frames(2);
  EXPECT_EQ(find("proof/stale"), nullptr);
  EXPECT_EQ(find("proof/row0"), nullptr);
}

TEST_F(UiProve, StopsFollowingEditsAfterTheProof) {
  start_lipped();
  EXPECT_EQ(find("problems/cancel_proof"), nullptr);
  click("problems/prove");
  ASSERT_TRUE(proof_ends());
  frames(2);
  click("problems/cancel_proof");
  frames(2);
  EXPECT_EQ(find("problems/cancel_proof"), nullptr);
  session().apply(action::EditLevel{Edit{"Paint", {CellChange{{20, 15}, 7, 0}}}});
  frames(4);
  EXPECT_FALSE(session().prover().running());
  EXPECT_NE(find("proof/stale"), nullptr);
}

TEST_F(UiProve, FindingsAreCountedWithTheProblems) {
  start_lipped();
  const std::size_t problems = app().ui().problems->size();
  click("problems/prove");
  ASSERT_TRUE(proof_ends());
  frames(2);
  ASSERT_EQ(session().prover().found()->findings.size(), 2u);
  const std::string text = problems_text(session(), app().ui());
  EXPECT_NE(text.find("2 findings"), std::string::npos) << text;
  EXPECT_EQ(text.find("problem") != std::string::npos, problems > 0) << text;
}

TEST_F(UiProve, AFindingOffersTheFixOfItsProblem) {
  Level level = test_level();
  level.tuning.solver = SolverKind::exact;
  level.map.set({5, 10}, 0);
  level.tile_shapes[7] = {.kind = TileShape::Kind::slope, .heights = {0, 7.5}};
  level.map.set({20, 15}, 7);
  for (int x = 21; x < 26; ++x) level.map.set({x, 15}, 1);
  const std::string file = path("seam.talus.json");
  ASSERT_TRUE(save_level(level, *format_for_file(file), file));
  start(file, 1280, 1000);
  app().ui().view.requests.ask(request::ShowTab("problems"));
  frames(8);
  click("problems/prove");
  ASSERT_TRUE(proof_ends());
  ASSERT_FALSE(session().prover().found()->findings.empty());
  ASSERT_TRUE(frames_until([&] { return find("proof/fix0") != nullptr; }));
  EXPECT_EQ(app().ui().view.canvas.fix_preview, nullptr);
  move(centre("proof/fix0"));
  frames(2);
  const auto preview = app().ui().view.canvas.fix_preview;
  ASSERT_NE(preview, nullptr);
  EXPECT_EQ(preview->cells, (std::vector<Cell>{{20, 15}}));
  EXPECT_EQ(preview->level.tile_shapes[7].heights.back(), 8);
  EXPECT_EQ(session().level().tile_shapes[7].heights.back(), 7.5) << "nothing is changed yet";
  click("proof/fix0");
  frames(2);
  ASSERT_TRUE(proof_ends());
  frames(2);
  EXPECT_TRUE(session().prover().found()->findings.empty());
}

}  // namespace talus::prove_ui_test
