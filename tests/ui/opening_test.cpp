// What the window shows of a file that was just opened, and what that does.
#include <filesystem>

#include <talus/formats/format.h>
#include "harness.h"
#include "panels/canvas/opening_area.h"
#include "paths.h"
#include "platform/asset_path.h"

namespace talus::opening_test {

class UiOpening : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    open_as_users_do();
  }
  // A map of several screens, whose player stands on a floor far from its first screen.
  static Level far_level() {
    Level level = test_level();
    level.tuning.solver = SolverKind::exact;
    level.map = TileMap(200, 100);
    for (int x = 0; x < 200; ++x) level.map.set({x, 90}, 1);
    Spawn& player = level.spawns.emplace_back();
    player.kind = BodyKind::player;
    player.position = {1000, 90 * 8 - 8};
    return level;
  }
  std::string save(const Level& level, const std::string& name) const {
    const std::string file = path(name);
    EXPECT_TRUE(save_level(level, *format_for_file(file), file));
    return file;
  }
  const Body& player() { return session().state().bodies.at(0); }
  bool is_in_sight(const std::string& canvas, Vec2 at) {
    const Widget* widget = find(canvas + "/canvas");
    const ImVec2 place = on_canvas(canvas, at);
    return place.x > widget->min.x && place.x < widget->max.x && place.y > widget->min.y &&
           place.y < widget->max.y;
  }
};

// Of which nothing was asked but to open it.
TEST_F(UiOpening, AMapOfTiledPlaysAndItsPlayerRuns) {
  std::filesystem::copy(source_path("assets/platformer"), path("platformer"));
  start(path("platformer/meadow.tmx"));
  ASSERT_TRUE(session().playback().running);
  const Body& player = *followed_body(session().state(), 0);
  EXPECT_TRUE(is_in_sight("play", player.box.center()));
  frames(60);
  const double x = followed_body(session().state(), 0)->box.x;
  hold(kKeyRight);
  frames(30);
  EXPECT_GT(followed_body(session().state(), 0)->box.x, x + 10);
}

TEST_F(UiOpening, PlaysHoweverItIsOpened) {
  const std::string file = save(far_level(), "far.talus.json");
  start(file);
  EXPECT_TRUE(session().playback().running) << "from the command line";
  session().apply(action::Pause{});
  drop(save_test_level("other.talus.json"));
  EXPECT_TRUE(session().playback().running) << "dropped";
  EXPECT_LT(session().state().frame, 10) << "from its start";
  session().apply(action::Pause{});
  session().apply(action::OpenFile{file});
  frames(2);
  EXPECT_TRUE(session().playback().running) << "from a dialog or a list";
}

TEST_F(UiOpening, ASettingTurnsPlayingOff) {
  start(save_test_level("level.talus.json"));
  key(ctrl(','));
  frames(3);
  click("settings/plays_opened");
  stop();
  start(path("level.talus.json"));
  EXPECT_FALSE(session().playback().running) << "it is remembered";
  EXPECT_EQ(session().state().frame, 0);
  start("");
  EXPECT_FALSE(session().playback().running) << "the demo level is no exception";
}

TEST_F(UiOpening, ALevelWithoutBodiesWaits) {
  Level level = test_level();
  level.map.set({5, 10}, 0);
  start(save(level, "ground.talus.json"));
  EXPECT_FALSE(session().playback().running);
}

TEST_F(UiOpening, OneClickGivesALevelWithoutBodiesAPlayerThatRuns) {
  Level level = test_level();
  level.tuning.solver = SolverKind::exact;
  level.map.set({5, 10}, 0);
  for (const auto& [width, height] : {std::pair{1280, 720}, {900, 600}}) {
    start(save(level, "ground.talus.json"), width, height);
    EXPECT_EQ(find("inspector/place_player") != nullptr, width == 1280)
        << "a small window has no room for it";
    click("play/place_player");
    ASSERT_EQ(session().state().bodies.size(), 1u);
    EXPECT_TRUE(session().playback().running);
    EXPECT_EQ(find("play/place_player"), nullptr);
    EXPECT_TRUE(is_in_sight("play", player().box.center()));
    frames(4);
    EXPECT_TRUE(player().gait.grounded);
    const double x = player().box.x;
    hold(kKeyRight);
    frames(20);
    let_go(kKeyRight);
    EXPECT_GT(player().box.x, x);
    key(ctrl('z'));
    EXPECT_TRUE(session().level().spawns.empty()) << "one undo";
  }
}

TEST_F(UiOpening, ARecordingWaits) {
  start(save_test_level("level.talus.json"));
  frames(20);
  session().apply(action::SaveRecording{path("level.talusrec")});
  drop(path("level.talusrec"));
  EXPECT_GT(session().timeline().last_frame(), 0);
  EXPECT_FALSE(session().playback().running);
}

TEST_F(UiOpening, EditsGoOnWhileItPlays) {
  start(save_test_level("level.talus.json"));
  const std::int64_t frame = session().state().frame;
  click(on_sheet(1));
  click(on_map({12, 9}));
  EXPECT_EQ(tile_at({12, 9}), 1);
  frames(2);
  EXPECT_TRUE(session().playback().running);
  EXPECT_GT(session().state().frame, frame);
}

TEST_F(UiOpening, ALevelThatIsReadAgainKeepsItsViewAndStaysPaused) {
  const std::string file = save(far_level(), "far.talus.json");
  start(file);
  key(kKeyF5);
  app().ui().view.requests.ask(request::Scroll{{-300, -40}});
  frames(2);
  const ImVec2 before = on_canvas("play", {1000, 700}), map_before = on_canvas("map", {1000, 700});
  const std::int64_t frame = session().state().frame;
  Level other = far_level();
  other.map.set({3, 3}, 1);
  save(other, "far.talus.json");
  session().apply(action::CheckFile{});
  session().finish_reading();
  frames(3);
  ASSERT_EQ(tile_at({3, 3}), 1);
  EXPECT_FALSE(session().playback().running);
  EXPECT_EQ(session().state().frame, frame);
  EXPECT_EQ(on_canvas("play", {1000, 700}).x, before.x);
  EXPECT_EQ(on_canvas("map", {1000, 700}).x, map_before.x);
}

TEST_F(UiOpening, ARecoveredLevelStaysPaused) {
  start(save_test_level("level.talus.json"));
  click(on_sheet(1));
  click(on_map({12, 9}));
  turn_for(6);
  stop();
  start(path("level.talus.json"));
  frames(2);
  ASSERT_NE(find("recovery/recover0"), nullptr);
  click("recovery/recover0");
  frames(2);
  ASSERT_EQ(tile_at({12, 9}), 1);
  EXPECT_FALSE(session().playback().running);
}

TEST_F(UiOpening, ShowsThePlayerHoweverItIsOpened) {
  const std::string file = save(far_level(), "far.talus.json");
  start(file);
  EXPECT_TRUE(is_in_sight("play", player().box.center())) << "from the command line";
  EXPECT_TRUE(is_in_sight("map", player().box.center()));
  start(save_test_level("other.talus.json"));
  drop(file);
  EXPECT_TRUE(is_in_sight("play", player().box.center())) << "dropped";
  start(save_test_level("other.talus.json"));
  session().apply(action::OpenFile{file});
  frames(2);
  EXPECT_TRUE(is_in_sight("play", player().box.center())) << "from a dialog or a list";
}

TEST_F(UiOpening, TheViewFollowsThePlayer) {
  start(save(far_level(), "far.talus.json"));
  const float map_before = on_canvas("map", {1000, 700}).x, play_before = on_canvas("play", {1000, 700}).x;
  hold(kKeyRight);
  frames(200);
  ASSERT_GT(player().box.x, 1200);
  EXPECT_TRUE(is_in_sight("play", player().box.center()));
  EXPECT_LT(on_canvas("play", {1000, 700}).x, play_before - 100);
  EXPECT_EQ(on_canvas("map", {1000, 700}).x, map_before) << "the map stays where one paints";
}

// A body that is chosen stays under the mouse; the view goes with it once it leaves.
TEST_F(UiOpening, ChoosingABodyDoesNotMoveTheView) {
  start(source_path("assets/demo.talus.json"));
  session().apply(action::Pause{});
  frames(5);
  const Body body = session().state().bodies.front();
  const ImVec2 before = on_canvas("play", {0, 0});
  click(on_canvas("play", body.box.center()));
  frames(4);
  ASSERT_EQ(session().choices().body, body.id);
  EXPECT_EQ(on_canvas("play", {0, 0}).x, before.x);
  EXPECT_EQ(on_canvas("play", {0, 0}).y, before.y);
  key(kKeyF5);
  frames(10);
  EXPECT_EQ(on_canvas("play", {0, 0}).x, before.x) << "it is in sight";
  EXPECT_EQ(on_canvas("play", {0, 0}).y, before.y);
}

TEST_F(UiOpening, AnEmptyLevelOffersNoPlayerThatWouldFall) {
  start();
  session().apply(action::NewLevel{});
  frames(3);
  EXPECT_EQ(find("play/place_player"), nullptr);
  click("play/new_level");
  frames(3);
  click("new_level/apply");
  frames(3);
  EXPECT_TRUE(session().playback().running) << "it has ground and a player";
}

TEST_F(UiOpening, PanningLetsGoAndTheButtonFollowsAgain) {
  start(save(far_level(), "far.talus.json"));
  const ImVec2 from = centre("play/canvas");
  drag(from, {from.x + 40, from.y}, kRight);
  const float before = on_canvas("play", {1000, 700}).x;
  hold(kKeyRight);
  frames(200);
  let_go(kKeyRight);
  EXPECT_EQ(on_canvas("play", {1000, 700}).x, before);
  EXPECT_FALSE(is_in_sight("play", player().box.center()));
  click("canvas/follow");
  frames(2);
  EXPECT_TRUE(is_in_sight("play", player().box.center()));
  drag(from, {from.x + 40, from.y}, kRight);
  drop(save_test_level("other.talus.json"));
  EXPECT_TRUE(app().ui().view.canvas.follow_body) << "another level is followed from the start";
}

TEST_F(UiOpening, AKeyGoesBackToThePlayer) {
  start(save(far_level(), "far.talus.json"));
  click(on_canvas("play", player().box.center() + Vec2{0, -40}));
  for (int i = 0; i < 30; ++i) key(shift(kKeyLeft));
  app().ui().view.requests.ask(request::Scroll{{-4000, 0}});
  frames(2);
  ASSERT_FALSE(is_in_sight("play", player().box.center()));
  key(alt(kKeyHome));
  frames(2);
  EXPECT_TRUE(is_in_sight("play", player().box.center()));
}

TEST_F(UiOpening, ALargerWindowShowsItLarger) {
  const std::string file = save(far_level(), "far.talus.json");
  const auto width_of_10_px = [&] {
    const float left = on_canvas("map", {1000, 700}).x;
    return on_canvas("map", {1010, 700}).x - left;
  };
  start(file, 900, 600);
  const float small = width_of_10_px();
  start(file, 1920, 1080);
  EXPECT_GT(width_of_10_px(), small);
}

TEST_F(UiOpening, TheDemoMovesUntilSomebodyTouchesIt) {
  open_as_users_do();
  for (const std::string& file : {std::string(), asset_path("demo.talus.json")}) {
    start(file);
    ASSERT_TRUE(frames_until([&] { return session().playback().running; }));
    for (int i = 0; i < 8; ++i) {
      const State before = session().state();
      frames(150);
      EXPECT_FALSE(session().timeline().in_past()) << "no recording is shown again";
      bool has_moved = false;
      for (std::size_t k = 0; k < before.bodies.size(); ++k)
        has_moved = has_moved || !(before.bodies[k].box == session().state().bodies[k].box);
      EXPECT_TRUE(has_moved) << file << " " << i;
    }
    EXPECT_EQ(session().timeline().branches().size(), 1u);
    key(KeyChord{27});  // for the welcome page, if it is open
    key(KeyChord{27});
    EXPECT_EQ(session().state().grabbed, 0);
    frames(600);
    const State rest = session().state();
    frames(150);
    for (std::size_t k = 0; k < rest.bodies.size(); ++k)
      EXPECT_EQ(rest.bodies[k].box, session().state().bodies[k].box) << "it is the user's now";
  }
}

TEST_F(UiOpening, TheHandOfTheDemoLeavesOtherLevelsAlone) {
  std::filesystem::copy(source_path("assets/platformer"), path("platformer"));
  open_as_users_do();
  start("");
  frames(300);
  session().apply(action::OpenFile{path("platformer/meadow.tmx")});
  ASSERT_TRUE(frames_until([&] { return !session().state().bodies.empty() && !session().path().empty(); }));
  for (int i = 0; i < 500; ++i) {
    frames(1);
    ASSERT_EQ(session().state().grabbed, 0) << i;
  }
}

}  // namespace talus::opening_test
