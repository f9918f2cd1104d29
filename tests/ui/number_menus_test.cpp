// The menus of numbers by the right button, and what empty panels offer.
#include <talus/formats/format.h>
#include "edit/level_settings.h"
#include "edit/spawn_tools.h"
#include "harness.h"

namespace talus::number_menus_test {

class UiNumberMenus : public UiTest {
 protected:
  void SetUp() override {
    start();
    session().apply(action::SelectBody{ball().id});
    frames(2);
  }
  // Chooses a row of the menu of a number in the inspector.
  void choose(const std::string& number, const std::string& row) {
    click("inspector/" + number, kRight);
    frames(2);
    click("inspector/" + number + "/" + row);
    frames(3);
  }
};

TEST_F(UiNumberMenus, ANumberIsPlotted) {
  choose("vy", "plot");
  const auto& plots = session().debugger().plots().all();
  ASSERT_EQ(plots.size(), 1u);
  EXPECT_EQ(plots[0].plot, (PlotText{"vy", ball().id}));
  EXPECT_TRUE(app().ui().view.window.dock_open) << "and shown";
}

TEST_F(UiNumberMenus, PlayingStopsWhenANumberChanges) {
  choose("y", "stop");
  const auto& breakpoints = session().debugger().breakpoints().all();
  ASSERT_EQ(breakpoints.size(), 1u);
  EXPECT_EQ(breakpoints[0].condition, "changed(y)");
  EXPECT_EQ(breakpoints[0].body, ball().id);
  key(kKeyF5);
  frames(30);
  EXPECT_FALSE(session().playback().running);
  EXPECT_GT(session().state().frame, 0);
}

TEST_F(UiNumberMenus, ANumberIsCopied) {
  choose("x", "copy");
  EXPECT_EQ(std::string(ImGui::GetClipboardText()), "40");
}

TEST_F(UiNumberMenus, ANumberOfTheTuningGoesBackToItsDefault) {
  Tuning tuning = level().tuning;
  tuning.shared.fall_speed = 7;
  session().apply(action::EditLevel{set_tuning(level(), tuning)});
  click("tabs/tuning");
  frames(3);
  click("tuning/fall_speed", kRight);
  frames(2);
  click("tuning/menu_reset");
  frames(2);
  EXPECT_EQ(level().tuning.shared.fall_speed, SharedTuning().fall_speed);
}

TEST_F(UiNumberMenus, AStartIsCopiedOrGoesBack) {
  Spawn ball;
  ball.position = {40.25, 40};
  ball.velocity = {3, 0};
  session().apply(action::EditLevel{add_spawn(level(), ball)});
  session().apply(action::SelectSpawn{0});
  frames(3);
  click("inspector/start_x", kRight);
  frames(2);
  EXPECT_EQ(find("inspector/start_x_reset"), nullptr) << "a place has no default";
  click("inspector/start_x_copy");
  frames(2);
  EXPECT_EQ(std::string(ImGui::GetClipboardText()), "40.25");
  click("inspector/start_vx", kRight);
  frames(2);
  click("inspector/start_vx_reset");
  frames(2);
  EXPECT_EQ(level().spawns[0].velocity, Vec2{});
  key(ctrl('z'));
  EXPECT_EQ(level().spawns[0].velocity, (Vec2{3, 0}));
}

TEST_F(UiNumberMenus, AnEmptyPanelOffersThePlayer) {
  Level with_player = test_level();
  with_player.tuning.solver = SolverKind::exact;
  with_player.spawns.emplace_back().kind = BodyKind::player;
  with_player.spawns.back().position = {100, 100};
  ASSERT_TRUE(save_level(with_player, *find_format("native"), path("player.talus.json")));
  start(path("player.talus.json"));
  EXPECT_EQ(session().choices().body, 0);
  click("inspector/choose_player");
  frames(2);
  EXPECT_EQ(session().state().find(session().choices().body)->kind, BodyKind::player);
}

}  // namespace talus::number_menus_test
