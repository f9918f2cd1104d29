// What the window shows of a file that was just opened, and what that does.
#include <filesystem>

#include <talus/formats/format.h>
#include "harness.h"
#include "paths.h"

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

}  // namespace talus::opening_test
