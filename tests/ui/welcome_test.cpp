// The welcome page: what it offers, by mouse and by keys, and when it is there.
#include <filesystem>
#include <fstream>

#include "golden_harness.h"
#include "panels/canvas/opening_area.h"
#include "panels/window/example_list.h"
#include "platform/asset_path.h"

namespace talus::welcome_test {

constexpr int kEscape = 27;

class UiWelcome : public UiGolden {
 protected:
  void SetUp() override {
    UiGolden::SetUp();
    open_as_users_do();
  }
  void start_at_welcome(int width = 1280, int height = 720) {
    start("", width, height);
    ASSERT_NE(find("welcome/page"), nullptr);
  }
  bool shows_page() {
    frames(2);
    return find("welcome/page") != nullptr;
  }
  double followed_x() { return followed_body(session().state(), 0)->box.x; }
  // What the examples look like now, between the names of the groups and the bottom of the page.
  Picture picture_of_examples() {
    const Widget *first = find("welcome/example0"), *page = find("welcome/page");
    EXPECT_TRUE(app().screenshot(path("window.png")));
    return cut(load_picture(path("window.png")), first->min, page->max);
  }
  static void push_window_event(SDL_WindowEventID what) {
    SDL_Event event{};
    event.type = SDL_WINDOWEVENT;
    event.window.event = static_cast<Uint8>(what);
    ASSERT_EQ(SDL_PushEvent(&event), 1);
  }
};

TEST_F(UiWelcome, EscapeGoesBackToTheDemoThatPlays) {
  start_at_welcome();
  EXPECT_EQ(session().file_name(), "demo (copy)");
  const std::int64_t frame = session().state().frame;
  frames(5);
  EXPECT_GT(session().state().frame, frame) << "it plays behind the page";
  key(kEscape);
  EXPECT_FALSE(shows_page());
  EXPECT_TRUE(session().playback().running);
}

TEST_F(UiWelcome, AClickBesideItGoesBackAndDoesNothingElse) {
  start_at_welcome();
  click({20, 300});
  EXPECT_FALSE(shows_page());
  EXPECT_FALSE(session().modified());
}

TEST_F(UiWelcome, KeysAreNotForTheLevelBehindIt) {
  start_at_welcome();
  const MapTool tool = session().choices().map_tool;
  key('e');
  key(kKeyF5);
  EXPECT_EQ(session().choices().map_tool, tool);
  EXPECT_TRUE(session().playback().running);
}

TEST_F(UiWelcome, IsNotThereWithAFileButComesBackByHelp) {
  start(save_test_level("level.talus.json"));
  EXPECT_FALSE(shows_page());
  click("menu/Help");
  click("menu/help/welcome");
  EXPECT_TRUE(shows_page());
  click("welcome/close");
  EXPECT_FALSE(shows_page());
  EXPECT_EQ(session().path(), path("level.talus.json")) << "the level is kept";
}

TEST_F(UiWelcome, IsThereWithTheErrorOfAFileThatCannotBeOpened) {
  std::ofstream(path("no.tmx")) << "no map";
  start(path("no.tmx"));
  frames(3);
  EXPECT_TRUE(shows_page());
  ASSERT_TRUE(session().message());
  EXPECT_NE(session().message()->text.find("no.tmx"), std::string::npos) << session().message()->text;
  EXPECT_NE(find("message/text"), nullptr);
}

TEST_F(UiWelcome, ARecentLevelIsOpenedByItsPicture) {
  start(save_test_level("first.talus.json"));
  start(save_test_level("second.talus.json"));
  start_at_welcome();
  ASSERT_NE(find("welcome/recent1"), nullptr);
  EXPECT_EQ(find("welcome/recent2"), nullptr);
  EXPECT_TRUE(app().ui().view.files.recent_pictures.contains(path("first.talus.json")));
  click("welcome/recent1");
  EXPECT_EQ(session().path(), path("first.talus.json"));
  EXPECT_FALSE(shows_page());
}

TEST_F(UiWelcome, ARecentLevelThatIsGoneKeepsThePage) {
  start(save_test_level("first.talus.json"));
  stop();
  std::filesystem::remove(path("first.talus.json"));
  start_at_welcome();
  click("welcome/recent0");
  EXPECT_TRUE(shows_page());
  ASSERT_TRUE(session().message());
  EXPECT_TRUE(session().message()->is_error);
}

TEST_F(UiWelcome, ANewLevelInTrueColourPlaysAtOnce) {
  start_at_welcome();
  click("welcome/tile24");
  click("welcome/colours/True colour");
  click("welcome/content/Playable");
  click("welcome/new");
  EXPECT_FALSE(shows_page());
  EXPECT_EQ(level().map.tile_size(), (TileSize{24, 24}));
  EXPECT_NE(level().sheet(SheetId::tiles).picture, nullptr);
  EXPECT_TRUE(session().playback().running);
  const double x = followed_x();
  hold(kKeyRight);
  frames(60);
  EXPECT_GT(followed_x(), x + 24);
}

TEST_F(UiWelcome, ANewLevelMayBeEmptyInThePalette) {
  start_at_welcome();
  click("welcome/tile16");
  click("welcome/colours/Palette");  // which has tiles of 8x8 px
  click("welcome/content/Empty");
  click("welcome/new");
  EXPECT_FALSE(shows_page());
  EXPECT_EQ(level().map.tile_size(), (TileSize{8, 8}));
  EXPECT_EQ(level().sheet(SheetId::tiles).picture, nullptr);
  EXPECT_TRUE(level().spawns.empty());
  EXPECT_EQ(level().map.tile_at({4, 13}), 0);
}

TEST_F(UiWelcome, OpensADialogOrADroppedFile) {
  start_at_welcome();
  click("welcome/open");
  frames(3);
  EXPECT_NE(find("files/name"), nullptr);
  key(kEscape);
  EXPECT_TRUE(shows_page()) << "the dialog alone is closed";
  drop(save_test_level("level.talus.json"));
  EXPECT_EQ(session().path(), path("level.talus.json"));
  EXPECT_FALSE(shows_page());
}

TEST_F(UiWelcome, ItsGroupsShowEveryExampleOnce) {
  start_at_welcome(1280, 2000);
  const auto groups = example_groups(app().ui().view.files);
  std::size_t shown = 0;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    click("welcome/group" + std::to_string(i));
    frames(2);
    for (std::size_t card = 0; card < groups[i].files.size(); ++card)
      shown += find("welcome/example" + std::to_string(card)) != nullptr ? 1 : 0;
    EXPECT_EQ(find("welcome/example" + std::to_string(groups[i].files.size())), nullptr);
  }
  EXPECT_EQ(shown, scene_paths().size() + hard_case_paths().size());
}

TEST_F(UiWelcome, AnExampleOpensAsACopy) {
  start_at_welcome();
  click("welcome/group1");
  click("welcome/example0");
  EXPECT_FALSE(shows_page());
  EXPECT_TRUE(session().path().empty()) << "saving asks for a name";
  EXPECT_TRUE(session().hard_case());
}

TEST_F(UiWelcome, ExamplesMoveWhileTheWindowIsInFront) {
  start_at_welcome();
  frames(10);
  const Picture before = picture_of_examples();
  frames(60);
  const Picture moved = picture_of_examples();
  EXPECT_NE(before.rgba, moved.rgba);
  push_window_event(SDL_WINDOWEVENT_FOCUS_LOST);
  session().apply(action::Pause{});  // nothing of the level is seen there, but its frames count
  frames(2);
  const Picture still = picture_of_examples();
  frames(60);
  EXPECT_EQ(picture_of_examples().rgba, still.rgba);
  push_window_event(SDL_WINDOWEVENT_FOCUS_GAINED);
  frames(60);
  EXPECT_NE(picture_of_examples().rgba, still.rgba);
}

TEST_F(UiWelcome, DrawsFramesOnlyWhileSomethingMoves) {
  start_at_welcome();
  session().apply(action::Pause{});
  turn_for(2);
  int drawn = app().drawn_frames();
  turn_for(1);
  EXPECT_GT(app().drawn_frames(), drawn + 30);
  push_window_event(SDL_WINDOWEVENT_FOCUS_LOST);
  turn_for(2);
  drawn = app().drawn_frames();
  turn_for(1);
  EXPECT_EQ(app().drawn_frames(), drawn);
}

TEST_F(UiWelcome, WorksByTheKeyboardAlone) {
  start_at_welcome();
  key(kKeyUp);    // from the button to what the level has
  key(kKeyDown);  // and back
  key(' ');
  EXPECT_FALSE(shows_page());
  EXPECT_EQ(session().file_name(), "untitled");
  EXPECT_FALSE(session().state().bodies.empty());
}

TEST_F(UiWelcome, IsWholeInASmallWindow) {
  start(save_test_level("level.talus.json"));
  for (const ImVec2 size : {ImVec2{900, 600}, ImVec2{1280, 720}}) {
    start_at_welcome(static_cast<int>(size.x), static_cast<int>(size.y));
    for (const double text : {14.0, kMaxFontSize}) {
      app().ui().view.preferences.font_size = text;
      frames(3);
      std::size_t count = 0;
      for (const Widget& w : app().ui().widgets.all()) {
        if (!w.name.starts_with("welcome/")) continue;
        ++count;
        EXPECT_GE(w.min.x, w.clip_min.x) << w.name;
        EXPECT_LE(w.max.x, w.clip_max.x) << w.name;
        if (w.scrolls) continue;
        EXPECT_GE(w.min.y, w.clip_min.y) << w.name;
        EXPECT_LE(w.max.y, w.clip_max.y) << w.name;
      }
      EXPECT_GE(count, 24u) << size.x;
      EXPECT_FALSE(find("welcome/start")->scrolls) << "the left column needs no scrolling";
    }
  }
}

TEST_F(UiWelcome, ASettingStartsWithTheDemo) {
  start_at_welcome();
  click("welcome/start");
  click("welcome/start/demo");
  start("");
  EXPECT_FALSE(shows_page());
  EXPECT_EQ(session().file_name(), "demo (copy)");
  EXPECT_TRUE(session().playback().running);
}

TEST_F(UiWelcome, ASettingStartsWithTheLastLevel) {
  start(save_test_level("level.talus.json"));
  key(ctrl(','));
  frames(3);
  click("settings/start");
  click("settings/start/last_level");
  start("");
  EXPECT_FALSE(shows_page());
  EXPECT_EQ(session().path(), path("level.talus.json"));
  EXPECT_TRUE(session().playback().running);
  stop();
  std::filesystem::remove(path("level.talus.json"));
  start("");
  EXPECT_EQ(session().file_name(), "demo (copy)") << "the level is gone";
}

}  // namespace talus::welcome_test
