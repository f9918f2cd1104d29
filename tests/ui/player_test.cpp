// Bodies placed by hand, and players steered by the keys.
#include <talus/formats/format.h>
#include "harness.h"
#include "panels/commands/key_conflicts.h"

namespace talus::player_test {

class UiPlayer : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    start(save_player_level());
  }
  // The test level without its ball. A player stands on the floor at (40, 120), with the default tuning.
  std::string save_player_level() {
    Level level = test_level();
    level.map.set({5, 10}, 0);
    level.tuning.solver = SolverKind::exact;
    Spawn& player = level.spawns.emplace_back();
    player.kind = BodyKind::player;
    player.position = {40, 120};
    const std::string file = path("player.talus.json");
    EXPECT_TRUE(save_level(level, *format_for_file(file), file));
    return file;
  }
  const Body& player() { return session().state().bodies.at(0); }
  State stepped(const Input& input) { return step(session().scene(), session().state(), input); }
  static Input keys(bool left, bool right, bool jump) {
    Input input;
    input.left = left;
    input.right = right;
    input.jump = jump;
    return input;
  }
};

TEST_F(UiPlayer, KeysOfAPausedPlayerSayHowToPlay) {
  click(on_canvas("play", {84, 20}));
  EXPECT_EQ(find("play/body_note"), nullptr);
  hold(kKeyRight);
  frames(2);
  EXPECT_NE(find("play/body_note"), nullptr);
  key(kKeyF5);
  frames(2);
  EXPECT_EQ(find("play/body_note"), nullptr);
  let_go(kKeyRight);
}

TEST_F(UiPlayer, OneThatLeavesTheMapIsNotLostWithoutAWord) {
  Level level = session().level();
  level.map = TileMap(30, 17);  // without ground
  ASSERT_TRUE(save_level(level, *find_format("native"), path("fall.talus.json")));
  start(path("fall.talus.json"));
  key(kKeyF5);
  frames(3);
  EXPECT_EQ(find("play/body_note"), nullptr);
  frames(200);
  ASSERT_GT(player().box.y, level.map.px_height());
  const Widget *note = find("play/body_note"), *canvas = find("play/canvas");
  ASSERT_NE(note, nullptr);
  EXPECT_TRUE(note->min.y >= canvas->min.y && note->max.y <= canvas->max.y) << "it is in sight";
  key(ctrl('r'));
  frames(3);
  EXPECT_EQ(find("play/body_note"), nullptr);
}

TEST_F(UiPlayer, ArrowsRunAndJumpWhileItPlays) {
  const ImVec2 corner = on_map({8, 8});
  key(kKeyF5);
  frames(5);
  hold(kKeyRight);
  frames(30);
  EXPECT_GT(player().box.x, 40 + 30);
  let_go(kKeyRight);
  frames(20);
  const double x = player().box.x;
  frames(5);
  EXPECT_EQ(player().box.x, x);
  hold(kKeyLeft);
  frames(20);
  EXPECT_LT(player().box.x, x - 15);
  let_go(kKeyLeft);
  frames(20);
  EXPECT_EQ(player().box.y, 120);
  hold(kKeyUp);
  frames(5);
  EXPECT_LT(player().box.y, 112);
  let_go(kKeyUp);
  EXPECT_EQ(on_map({8, 8}).x, corner.x);  // the arrows did not scroll the map
  EXPECT_EQ(on_map({8, 8}).y, corner.y);
}

TEST_F(UiPlayer, SpaceAndZJumpToo) {
  key(kKeyF5);
  for (const int jump : {static_cast<int>(' '), static_cast<int>('z')}) {
    frames(60);
    ASSERT_EQ(player().box.y, 120);
    hold(jump);
    frames(5);
    EXPECT_LT(player().box.y, 112) << jump;
    let_go(jump);
  }
}

TEST_F(UiPlayer, OtherKeysSteerOnceTheyAreBound) {
  bind_key(find_command("player/right"_command), 0, {'k'}, app().ui().view.preferences.keys);
  key(kKeyF5);
  hold('k');
  frames(30);
  let_go('k');
  frames(20);
  const double x = player().box.x;
  EXPECT_GT(x, 40 + 30);
  hold(kKeyRight);
  frames(10);
  EXPECT_EQ(player().box.x, x);
}

TEST_F(UiPlayer, TheCommandPaletteGivesPlayersTheKeys) {
  key(kKeyF2);
  ASSERT_EQ(app().ui().view.window.focus, Focus::sprites);
  key(ctrl('p'));
  frames(2);
  type("run left");
  key('\r');
  frames(2);
  EXPECT_EQ(app().ui().view.window.focus, Focus::map);
  EXPECT_TRUE(app().ui().view.canvas.play_active);
}

TEST_F(UiPlayer, TapBetweenTwoSlowStepsCounts) {
  for (int i = 0; i < 3; ++i) key(',');
  ASSERT_EQ(session().playback().speed, 1.0 / 8);
  key(kKeyF5);
  frames(40);
  ASSERT_EQ(player().box.y, 120);
  push_stroke({'z'});
  frames(8);
  EXPECT_LT(player().velocity.y, 0);
}

TEST_F(UiPlayer, StepTakesTheKeysThatAreHeld) {
  key(kKeyF10);
  const ImVec2 corner = on_map({8, 8});
  hold(kKeyRight);
  State expected = stepped(keys(false, true, false));
  key(kKeyF10);
  EXPECT_EQ(session().state(), expected);
  EXPECT_GT(player().velocity.x, 0);
  hold(' ');
  expected = stepped(keys(false, true, true));
  key(kKeyF10);
  EXPECT_EQ(session().state(), expected);
  let_go(' ');
  let_go(kKeyRight);
  expected = stepped(Input{});
  key(kKeyF10);
  EXPECT_EQ(session().state(), expected);
  EXPECT_EQ(on_map({8, 8}).x, corner.x);
}

TEST_F(UiPlayer, ArrowsScrollThePausedMapAndMoveInTheSheet) {
  click("map/pan");
  click(on_map({20, 3}));
  const ImVec2 before = on_map({8, 8});
  key(kKeyRight);
  EXPECT_EQ(on_map({8, 8}).x, before.x - 64);
  key(kKeyF5);
  key(kKeyF2);
  const int column = session().choices().area.tiles.x;
  key(kKeyRight);
  EXPECT_EQ(session().choices().area.tiles.x, column + 1);
  EXPECT_EQ(player().box.x, 40);
}

TEST_F(UiPlayer, TypingDoesNotSteer) {
  key(kKeyF5);
  frames(3);
  click("flags/menu1");
  click("flags/name");
  push_typing("zz");
  frames(5);
  EXPECT_FALSE(session().playback().input.jump);
  EXPECT_EQ(player().box.y, 120);
}

TEST_F(UiPlayer, BodyToolPlacesMovesAndRemoves) {
  key('0');
  session().apply(action::SelectSpawn{0});
  frames(2);
  click(on_map({10, 4}));
  ASSERT_EQ(level().spawns.size(), 2u);
  EXPECT_EQ(level().spawns[1].position, (Vec2{80, 32}));
  EXPECT_EQ(level().spawns[1].kind, BodyKind::player);
  EXPECT_EQ(session().choices().body, 2);
  drag(on_canvas("map", {84, 36}), on_canvas("map", {104, 61}));
  EXPECT_EQ(level().spawns[1].position, (Vec2{100, 57}));
  key(ctrl('z'));
  EXPECT_EQ(level().spawns[1].position, (Vec2{80, 32}));
  move(on_map({20, 4}));
  key(kKeyDelete);
  EXPECT_EQ(level().spawns.size(), 1u);
  key(ctrl('z'));
  EXPECT_EQ(level().spawns.size(), 2u);
  key(ctrl('z'));
  EXPECT_EQ(level().spawns.size(), 1u);
  EXPECT_FALSE(session().modified());
}

TEST_F(UiPlayer, InspectorCopiesTheBodyWithAnyTool) {
  click(on_canvas("play", {44, 124}));
  ASSERT_EQ(session().choices().body, 1);
  ASSERT_EQ(session().choices().map_tool, MapTool::stamp);
  click("inspector/copy");
  ASSERT_EQ(level().spawns.size(), 2u);
  EXPECT_EQ(level().spawns[1].position.x, level().spawns[0].position.x + kCartTileSize);
}

TEST_F(UiPlayer, InspectorChoosesKindAndFoot) {
  click(on_canvas("play", {44, 124}));
  ASSERT_EQ(session().choices().body, 1);
  EXPECT_EQ(player().foot, Foot::centre);
  click("inspector/foot");
  click("inspector/foot_box");
  EXPECT_EQ(level().spawns[0].foot, Foot::box);
  EXPECT_EQ(player().foot, Foot::box);
  for (int i = 0; i < 3; ++i) key(kKeyF10);
  click("inspector/kind");
  click("inspector/kind_ball");
  EXPECT_EQ(level().spawns[0].kind, BodyKind::ball);
  EXPECT_EQ(player().kind, BodyKind::ball);  // the running simulation has it too
  EXPECT_EQ(session().state().frame, 3);
  key(ctrl('z'));
  key(ctrl('z'));
  EXPECT_EQ(level().spawns[0].kind, BodyKind::player);
  EXPECT_FALSE(level().spawns[0].foot);
  EXPECT_EQ(player().foot, Foot::centre);
  click("inspector/remove");
  EXPECT_TRUE(level().spawns.empty());
  EXPECT_EQ(session().choices().body, 0);
}

}  // namespace talus::player_test
