// Opening, saving, dropping, questions, errors and settings.
#include <fstream>

#include "harness.h"
#include "platform/file_request.h"

namespace talus::file_test {

class UiFile : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    start();
  }
  void change_the_level() {
    click(on_sheet(1));
    click(on_map({12, 9}));
    ASSERT_TRUE(session().modified());
  }
  static Level read(const std::string& file) {
    auto loaded = load_level(file);
    EXPECT_TRUE(loaded) << to_string(loaded.error(), file);
    return loaded ? loaded->level : Level();
  }
};

constexpr KeyChord kEnter{'\r'}, kEscape{27};

TEST_F(UiFile, SavesToItsOwnFile) {
  change_the_level();
  key(ctrl('s'));
  EXPECT_FALSE(session().modified());
  EXPECT_EQ(read(path("level.talus.json")).map.at({12, 9}), 1);
}

TEST_F(UiFile, SavesUnderAnotherNameThroughTheDialog) {
  change_the_level();
  key(ctrl_shift('s'));
  frames(2);
  click("files/name");
  key(ctrl('a'));
  type("other.talus.json");
  click("files/confirm");
  frames(2);
  EXPECT_EQ(session().path(), path("other.talus.json"));
  EXPECT_EQ(read(path("other.talus.json")).map.at({12, 9}), 1);
  EXPECT_EQ(read(path("level.talus.json")).map.at({12, 9}), 0);
  EXPECT_EQ(find("files/name"), nullptr);
}

TEST_F(UiFile, AsksBeforeItReplacesAFile) {
  save_test_level("other.talus.json");
  change_the_level();
  key(ctrl_shift('s'));
  frames(2);
  click("files/entry/other.talus.json");
  click("files/confirm");
  EXPECT_EQ(read(path("other.talus.json")).map.at({12, 9}), 0);
  ASSERT_NE(find("files/confirm"), nullptr);
  click("files/confirm");
  EXPECT_EQ(read(path("other.talus.json")).map.at({12, 9}), 1);
}

TEST_F(UiFile, DemoIsACopyThatAsksForAPlace) {
  start("");
  EXPECT_EQ(session().file_name(), "demo (copy)");
  key(ctrl('s'));
  frames(3);
  EXPECT_NE(find("files/name"), nullptr);
  const auto wanted = wanted_file(session(), app().ui().view, FileDialog::save_as);
  EXPECT_EQ(wanted->near, "demo (copy).talus.json") << "a cart alone cannot hold its tuning";
  EXPECT_TRUE(session().path().empty());
  key(kEscape);
  frames(3);
  session().apply(action::NewLevel{});
  EXPECT_EQ(session().file_name(), "untitled");
}

TEST_F(UiFile, SaveAsErrorStaysInTheDialog) {
  key(ctrl_shift('s'));
  frames(2);
  click("files/name");
  key(ctrl('a'));
  type("level.xyz");
  click("files/confirm");
  frames(2);
  EXPECT_NE(find("files/confirm"), nullptr);
  EXPECT_EQ(session().path(), path("level.talus.json"));
  key(kEscape);
  frames(2);
  EXPECT_EQ(find("files/confirm"), nullptr);
}

TEST_F(UiFile, OpensThroughTheDialogWithTheKeyboard) {
  Level other = test_level();
  other.map.set({1, 1}, 6);
  ASSERT_TRUE(save_level(other, *find_format("native"), path("second.talus.json")));
  key(ctrl('o'));
  frames(2);
  type("second.talus.json");
  key(kEnter);
  frames(2);
  EXPECT_EQ(session().path(), path("second.talus.json"));
  EXPECT_EQ(tile_at({1, 1}), 6);
  EXPECT_EQ(find("files/name"), nullptr);
}

TEST_F(UiFile, DialogEntersFoldersAndOpensByDoubleClick) {
  std::filesystem::create_directories(path("inner"));
  Level other = test_level();
  other.map.set({1, 1}, 6);
  ASSERT_TRUE(save_level(other, *find_format("native"), path("inner/deep.talus.json")));
  click("menu/File");
  frames(2);
  click("menu/file/open");
  frames(2);
  click("files/entry/inner");
  frames(2);
  click("files/entry/deep.talus.json");
  click("files/entry/deep.talus.json");
  frames(2);
  EXPECT_EQ(session().path(), path("inner/deep.talus.json"));
}

TEST_F(UiFile, TypedTextFiltersTheList) {
  for (const char* name : {"cave.talus.json", "caves.talus.json", "hill.talus.json"}) save_test_level(name);
  key(ctrl('o'));
  frames(2);
  type("CAVE");
  frames(2);
  EXPECT_NE(find("files/entry/cave.talus.json"), nullptr);
  EXPECT_NE(find("files/entry/caves.talus.json"), nullptr);
  EXPECT_EQ(find("files/entry/hill.talus.json"), nullptr);
  key(kKeyDown);
  key(kKeyDown);
  key(kKeyEnter);
  frames(2);
  EXPECT_EQ(session().path(), path("caves.talus.json"));
  key(ctrl('o'));
  frames(2);
  type("hil");
  frames(2);
  key(kKeyEnter);
  frames(2);
  EXPECT_EQ(session().path(), path("hill.talus.json")) << "the only one with this text";
}

TEST_F(UiFile, DialogKeepsFoldersAndShowsPictures) {
  std::filesystem::create_directories(path("inner"));
  save_test_level("inner/deep.talus.json");
  key(ctrl('o'));
  frames(2);
  click("files/entry/inner");
  frames(2);
  click("files/keep_folder");
  frames(2);
  EXPECT_EQ(app().ui().view.files.kept_folders, std::vector<std::string>{path("inner")});
  EXPECT_NE(find("files/recent0"), nullptr) << "the folder of the open level";
  click("files/recent0");
  frames(2);
  EXPECT_NE(find("files/entry/inner"), nullptr);
  type("nothing");
  frames(2);
  EXPECT_EQ(find("files/entry/inner"), nullptr) << "letters still go to the name";
  click("files/kept0");
  frames(2);
  click("files/entry/deep.talus.json");
  frames(2);
  EXPECT_NE(find("files/picture"), nullptr) << "though it was never open";
  click("files/confirm");
  frames(4);
  EXPECT_EQ(session().path(), path("inner/deep.talus.json"));
  key(ctrl('o'));
  frames(2);
  click("files/keep_folder");
  EXPECT_TRUE(app().ui().view.files.kept_folders.empty());
}

TEST_F(UiFile, DroppedFileOpens) {
  Level other = test_level();
  other.map.set({1, 1}, 6);
  ASSERT_TRUE(save_level(other, *find_format("native"), path("dropped.talus.json")));
  drop(path("dropped.talus.json"));
  EXPECT_EQ(session().path(), path("dropped.talus.json"));
  EXPECT_EQ(tile_at({1, 1}), 6);
}

TEST_F(UiFile, WrongFileShowsAnErrorAndKeepsTheLevel) {
  std::ofstream(path("wrong.talus.json")) << "{ this is no level";
  change_the_level();
  key(ctrl('s'));
  const Level before = level();
  drop(path("wrong.talus.json"));
  ASSERT_TRUE(session().message());
  EXPECT_TRUE(session().message()->is_error);
  EXPECT_NE(session().message()->text.find("wrong.talus.json"), std::string::npos);
  EXPECT_EQ(level(), before);
  EXPECT_EQ(session().path(), path("level.talus.json"));
  frames(600);
  ASSERT_TRUE(session().message()) << "an error stays until it is dismissed";
  click("message/dismiss");
  EXPECT_FALSE(session().message());
}

TEST_F(UiFile, MessagesOfSuccessDisappear) {
  change_the_level();
  key(ctrl('s'));
  EXPECT_TRUE(session().message());
  frames(600);
  EXPECT_FALSE(session().message());
}

TEST_F(UiFile, QuestionAnsweredWithSave) {
  change_the_level();
  key(ctrl('q'));
  frames(2);
  ASSERT_TRUE(session().question());
  EXPECT_FALSE(session().wants_quit());
  click("question/save");
  EXPECT_TRUE(session().wants_quit());
  EXPECT_EQ(read(path("level.talus.json")).map.at({12, 9}), 1);
}

TEST_F(UiFile, QuestionAnsweredWithDiscard) {
  change_the_level();
  key(ctrl('q'));
  frames(2);
  click("question/discard");
  EXPECT_TRUE(session().wants_quit());
  EXPECT_EQ(read(path("level.talus.json")).map.at({12, 9}), 0);
}

TEST_F(UiFile, QuestionAnsweredWithCancel) {
  change_the_level();
  SDL_Event quit{};
  quit.type = SDL_QUIT;  // the window's close button
  SDL_PushEvent(&quit);
  frames(3);
  ASSERT_TRUE(session().question());
  key(kEscape);
  frames(2);
  EXPECT_FALSE(session().question());
  EXPECT_FALSE(session().wants_quit());
  EXPECT_TRUE(session().modified());
  click(on_map({13, 9}));
  EXPECT_EQ(tile_at({13, 9}), 1) << "the window works on";
}

TEST_F(UiFile, NewLevelSavedThroughTheQuestionAsksForAName) {
  session().apply(action::NewLevel{});
  frames(2);
  EXPECT_TRUE(session().path().empty());
  change_the_level();
  key(ctrl('q'));
  frames(2);
  click("question/save");
  frames(2);
  ASSERT_NE(find("files/name"), nullptr);
  click("files/name");
  key(ctrl('a'));
  type(path("fresh.talus.json"));
  click("files/confirm");
  EXPECT_TRUE(session().wants_quit());
  EXPECT_EQ(read(path("fresh.talus.json")).map.at({12, 9}), 1);
}

TEST_F(UiFile, SettingsAreRememberedBetweenStarts) {
  key('`');
  key(alt('1'));
  key(ctrl('2'));
  const ImVec2 splitter = centre("layout/left");
  drag(splitter, {splitter.x + 60, splitter.y});
  const float moved = centre("layout/left").x;
  EXPECT_NEAR(moved, splitter.x + 60, 2);
  click("tabs/tuning");
  click("tabs/history");
  frames(2);
  const bool boxes = session().choices().overlays.has(overlay::boxes);
  save_test_level("second.talus.json");
  drop(path("second.talus.json"));
  stop();
  start(path("level.talus.json"), 0, 0);
  EXPECT_EQ(ImGui::GetIO().DisplaySize.x, 1280);
  EXPECT_FALSE(session().choices().grid);
  EXPECT_EQ(session().choices().overlays.has(overlay::boxes), boxes);
  EXPECT_EQ(app().ui().view.canvas.mode, CanvasMode::play);
  EXPECT_NEAR(centre("layout/left").x, moved, 1);
  EXPECT_NE(find("tuning/fall_speed"), nullptr) << "the chosen tab is shown again";
  EXPECT_EQ(app().ui().view.window.tabs, (std::vector<std::string>{"flags", "tuning", "history"}));
  EXPECT_EQ(app().ui().view.files.recent_files,
            (std::vector<std::string>{path("level.talus.json"), path("second.talus.json")}));
  EXPECT_EQ(app().ui().view.files.recent_pictures.size(), 2u) << "of both levels";
  click("menu/File");
  frames(2);
  click("menu/recent");
  frames(2);
  click("menu/recent1");
  frames(2);
  EXPECT_EQ(session().path(), path("second.talus.json"));
}

TEST_F(UiFile, HardCasesAreOpenedAsCopiesWithTheirAnswer) {
  click("menu/File");
  frames(2);
  click("menu/hard_cases");
  frames(2);
  click("menu/hard_case2");
  frames(2);
  ASSERT_TRUE(session().hard_case());
  EXPECT_EQ(session().hard_case()->number, 3);
  EXPECT_EQ(session().path(), "") << "what comes with the program is not written over";
  EXPECT_EQ(session().file_name(), "03-step-with-a-slope (copy)");
  EXPECT_TRUE(session().choices().overlays.has(overlay::answer));
  frames(2);
  EXPECT_NE(find("inspector/answer"), nullptr) << "and says in words what it shows";
}

TEST_F(UiFile, HardCasePlaysWithItsOwnKeys) {
  click("menu/File");
  frames(2);
  click("menu/hard_cases");
  frames(2);
  click("menu/hard_case8");
  frames(2);
  ASSERT_TRUE(session().hard_case());
  ASSERT_EQ(session().hard_case()->number, 9);
  click("transport/play");
  frames(130);
  EXPECT_NEAR(session().state().bodies.at(0).box.right(), 96, 1e-9) << "it ran up the ramp, to the wall";
}

TEST_F(UiFile, DamagedSettingsAreIgnoredWithAMessage) {
  stop();
  std::ofstream(path("config/settings.json")) << "{\"width\": 12";
  start(path("level.talus.json"));
  ASSERT_TRUE(session().message());
  EXPECT_NE(session().message()->text.find("settings"), std::string::npos);
  EXPECT_EQ(app().ui().view.window.layout, Layout{});
  EXPECT_EQ(tile_at({5, 10}), 2) << "the level is open all the same";
}

TEST_F(UiFile, TypingReplacesTheNameThatSaveAsProposes) {
  change_the_level();
  key(ctrl_shift('s'));
  push_typing("first");
  key(kEnter);
  frames(3);
  EXPECT_EQ(session().file_name(), "first.talus.json");
  EXPECT_EQ(read(path("first.talus.json")).map.at({12, 9}), 1);
}

TEST_F(UiFile, TheFirstClickSelectsTheProposedName) {
  change_the_level();
  key(ctrl_shift('s'));
  frames(3);
  click("files/name");
  type("first");
  click(ImVec2{find("files/name")->min.x + 4,
               find("files/name")->centre().y});  // far from the last click, so that it is no double click
  type("2");
  key(kEnter);
  frames(3);
  EXPECT_EQ(session().file_name(), "2first.talus.json") << "the next click chooses a place in it";
}

TEST_F(UiFile, ANameWithoutAnEndingKeepsTheLevelsFormat) {
  start(save_test_level("game.tic"));
  change_the_level();
  key(ctrl_shift('s'));
  push_typing("other");
  key(kEnter);
  frames(3);
  EXPECT_EQ(session().file_name(), "other.tic");
}

}  // namespace talus::file_test
