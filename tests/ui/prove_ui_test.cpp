// Proofs in the panel of problems: the button, the rows, and what an edit does.
#include "harness.h"

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

TEST_F(UiProve, AnEditIsToldAndTheLevelCanBeProvedAgain) {
  start_lipped();
  click("problems/prove");
  ASSERT_TRUE(proof_ends());
  session().apply(action::EditLevel{Edit{"Paint", {CellChange{{20, 15}, 7, 0}}}});
  frames(2);
  EXPECT_NE(find("proof/stale"), nullptr);
  click("problems/prove");
  ASSERT_TRUE(proof_ends());
  frames(2);
  EXPECT_EQ(find("proof/stale"), nullptr);
  EXPECT_EQ(find("proof/row0"), nullptr);
}

}  // namespace talus::prove_ui_test
