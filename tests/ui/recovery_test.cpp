// Unsaved work survives a crash, and changes of the file by other programs.
#include <filesystem>
#include <fstream>

#include "harness.h"
#include "held_reading.h"
#include "platform/autosave.h"

namespace talus::recovery_test {

constexpr KeyChord kEscapeKey{kKeyEscape};
constexpr int kFiveSeconds = 5 * 60;  // frames

class UiRecovery : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    start();
  }
  void paint(Cell cell) {
    click(on_sheet(1));
    click(on_map(cell));
    ASSERT_EQ(tile_at(cell), 1);
  }
  // Ends the program without a chance to save, and starts it again on the same file.
  void crash_and_start(const std::string& file) {
    stop();
    start(file);
    frames(2);
  }
  std::string level_file() const { return path("level.talus.json"); }
};

TEST_F(UiRecovery, WorkIsOfferedAfterACrashAndRecovered) {
  paint({12, 9});
  frames(kFiveSeconds);
  crash_and_start(level_file());
  ASSERT_NE(find("recovery/recover0"), nullptr);
  EXPECT_EQ(tile_at({12, 9}), 0);
  click("recovery/recover0");
  frames(2);
  EXPECT_EQ(find("recovery/recover0"), nullptr);
  EXPECT_EQ(tile_at({12, 9}), 1);
  EXPECT_EQ(session().path(), level_file());
  EXPECT_TRUE(session().modified());
  key(ctrl('z'));
  EXPECT_EQ(tile_at({12, 9}), 0) << "as the file has it";
  key(ctrl('y'));
  key(ctrl('s'));
  EXPECT_FALSE(session().modified());
  frames(2);
  crash_and_start(level_file());
  EXPECT_EQ(find("recovery/recover0"), nullptr) << "nothing is left once it is saved";
}

TEST_F(UiRecovery, LargeWorkIsReadOnAThread) {
  paint({12, 9});
  frames(kFiveSeconds);
  stop();
  std::string work;
  for (const auto& entry : std::filesystem::directory_iterator(path("state/autosave")))
    if (entry.path().extension() == ".talus-autosave") work = entry.path().string();
  std::ofstream(work, std::ios::app) << std::string(2'000'000, ' ');
  std::optional<HeldReading> held(work);
  start(level_file());
  EXPECT_FALSE(app().ui().view.window.recovery_open) << "the window waited for it";
  held.reset();
  ASSERT_TRUE(frames_until([&] { return find("recovery/recover0") != nullptr; }));
  frames(2);
  click("recovery/recover0");
  frames(2);
  EXPECT_EQ(tile_at({12, 9}), 1);
}

// For example a script starts the program again at once.
TEST_F(UiRecovery, WorkOfAProcessThatWasStillEndingIsOfferedToo) {
  stop();
  auto ending = std::make_unique<Autosave>(path("state/autosave"));
  Session killed(test_level(), level_file(), "level.talus.json");
  killed.apply(action::EditLevel{Edit{"Paint", {CellChange{{12, 9}, 0, 5}}}});
  ASSERT_TRUE(ending->save_now(killed));
  start(level_file());
  frames(2);
  EXPECT_EQ(find("recovery/recover0"), nullptr);
  ending.reset();
  frames(3 * 60);
  ASSERT_NE(find("recovery/recover0"), nullptr);
  click("recovery/recover0");
  frames(2);
  EXPECT_EQ(tile_at({12, 9}), 5);
}

TEST_F(UiRecovery, TheDialogsOfAProjectAndOfWorkTakeTurns) {
  paint({12, 9});
  frames(kFiveSeconds);
  const std::string project = path("game.ldtk");
  const std::string cells =
      R"("pxWid":8,"pxHei":8,"layerInstances":[{"__identifier":"G","__type":"IntGrid","__cWid":1,"__cHei":1,)"
      R"("__gridSize":8,"intGridCsv":[1]}]})";
  std::ofstream(project) << R"({"defs":{"layers":[],"tilesets":[]},"levels":[{"identifier":"A",)" << cells
                         << R"(,{"identifier":"B",)" << cells << "]}";
  crash_and_start(project);
  // The project and the work are read beside the window, so either dialog may be the first one.
  int works = 0, projects = 0;
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(frames_until([&] { return find("recovery/recover0") || find("choose/cancel"); }));
    const bool is_work = find("recovery/recover0") != nullptr;
    EXPECT_FALSE(is_work && find("choose/cancel") != nullptr) << "one hides the other";
    click(is_work ? "recovery/recover0" : "choose/cancel");
    frames(4);
    ++(is_work ? works : projects);
  }
  EXPECT_EQ(works, 1);
  EXPECT_EQ(projects, 1);
  EXPECT_EQ(tile_at({12, 9}), 1);
}

TEST_F(UiRecovery, AMarkedBranchIsOfferedAfterACrash) {
  for (int i = 0; i < 12; ++i) key(kKeyF10);
  key(ctrl('m'));
  frames(kFiveSeconds);
  EXPECT_FALSE(session().modified());
  crash_and_start(level_file());
  ASSERT_NE(find("recovery/recover0"), nullptr);
  click("recovery/recover0");
  frames(10);
  EXPECT_EQ(session().timeline().last_frame(), 12);
  ASSERT_EQ(session().timeline().current().marks.size(), 1u);
  EXPECT_EQ(session().timeline().current().marks[0].frame, 12);
  key(ctrl('s'));
  frames(2);
  key(ctrl('q'));
  frames(3);
  ASSERT_TRUE(session().question());
  click("question/save");
  frames(4);
  click("files/confirm");
  frames(3);
  EXPECT_TRUE(session().wants_quit());
  EXPECT_TRUE(std::filesystem::exists(path("level.talusrec")));
}

TEST_F(UiRecovery, RecoveredWorkSurvivesTheNextCrash) {
  paint({12, 9});
  frames(kFiveSeconds);
  crash_and_start(level_file());
  click("recovery/recover0");
  crash_and_start(level_file());
  ASSERT_NE(find("recovery/recover0"), nullptr);
  click("recovery/recover0");
  frames(2);
  EXPECT_EQ(tile_at({12, 9}), 1);
}

TEST_F(UiRecovery, UnreadableWorkIsNamedAndKeptUntilDiscarded) {
  stop();
  std::filesystem::create_directories(path("state/autosave"));
  const std::string damaged = path("state/autosave/1-0.talus-autosave");
  std::ofstream(damaged) << "half a";
  start(level_file());
  frames(2);
  ASSERT_NE(find("recovery/recover0"), nullptr);
  EXPECT_FALSE(find("recovery/recover0")->enabled);
  for (int i = 0; i < 3; ++i) key(kKeyEnter);
  key(kEscapeKey);
  frames(3);
  EXPECT_TRUE(std::filesystem::exists(damaged))
      << "keys that are pressed before the dialog is seen delete nothing";
  crash_and_start(level_file());
  for (int i = 0; i < 2; ++i) {
    click("recovery/discard0");
    frames(3);
  }
  EXPECT_EQ(find("recovery/discard0"), nullptr);
  EXPECT_FALSE(std::filesystem::exists(damaged));
}

TEST_F(UiRecovery, TheKeysGoToTheFirstReadableWork) {
  paint({12, 9});
  frames(kFiveSeconds);
  stop();
  const std::string damaged = path("state/autosave/1-0.talus-autosave");
  std::ofstream(damaged) << "half a";
  std::filesystem::last_write_time(damaged,
                                   std::filesystem::file_time_type::clock::now() + std::chrono::hours(1));
  start(level_file());
  frames(2);
  ASSERT_NE(find("recovery/recover1"), nullptr);
  ASSERT_FALSE(find("recovery/recover0")->enabled);
  key(kKeyEnter);
  frames(3);
  EXPECT_EQ(tile_at({12, 9}), 1);
  EXPECT_TRUE(std::filesystem::exists(damaged));
}

TEST_F(UiRecovery, AFailedAutosaveIsReportedUntilItSucceeds) {
  std::filesystem::create_directories(path("state"));
  std::ofstream(path("state/autosave")) << "in the folder's place";
  for (int x = 3; x < 6; ++x) {
    paint({x, 9});
    frames(kFiveSeconds);
    EXPECT_NE(find("status/not-saved-by-itself"), nullptr);
    ASSERT_TRUE(x > 3 || (session().message() && session().message()->is_error));
    key(kEscapeKey);
    frames(2);
  }
  std::filesystem::remove(path("state/autosave"));
  frames(kFiveSeconds);
  EXPECT_TRUE(frames_until([&] { return find("status/not-saved-by-itself") == nullptr; }));
  EXPECT_TRUE(!session().message() || !session().message()->is_error);
  crash_and_start(level_file());
  ASSERT_NE(find("recovery/recover0"), nullptr);
  click("recovery/recover0");
  frames(2);
  for (int x = 3; x < 6; ++x) EXPECT_EQ(tile_at({x, 9}), 1);
}

TEST_F(UiRecovery, SettingsThatCannotBeSavedAreReported) {
  std::filesystem::remove_all(path("config"));
  std::ofstream(path("config")) << "in the folder's place";
  app().ui().view.preferences.font_size = kMaxFontSize;
  frames(2);
  ASSERT_TRUE(session().message());
  EXPECT_NE(session().message()->text.find("The settings cannot be saved"), std::string::npos);
}

TEST_F(UiRecovery, DiscardingAsksOnceMore) {
  paint({12, 9});
  frames(kFiveSeconds);
  crash_and_start(level_file());
  click("recovery/discard0");
  frames(2);
  ASSERT_NE(find("recovery/discard0"), nullptr);
  click("recovery/discard0");
  frames(3);
  EXPECT_EQ(find("recovery/discard0"), nullptr);
  crash_and_start(level_file());
  EXPECT_EQ(find("recovery/discard0"), nullptr);
}

TEST_F(UiRecovery, LaterKeepsTheWorkForTheNextStart) {
  paint({12, 9});
  frames(kFiveSeconds);
  crash_and_start(level_file());
  key(kEscapeKey);
  frames(3);
  EXPECT_EQ(find("recovery/recover0"), nullptr);
  click("menu/File");
  frames(2);
  click("menu/file/recover");
  frames(3);
  ASSERT_NE(find("recovery/recover0"), nullptr);
  click("recovery/recover0");
  frames(2);
  EXPECT_EQ(tile_at({12, 9}), 1);
}

TEST_F(UiRecovery, ALevelWithoutAFileIsRecoveredToo) {
  session().apply(action::NewLevel{});
  frames(2);
  paint({12, 9});
  frames(kFiveSeconds);
  crash_and_start(level_file());
  click("recovery/recover0");
  frames(2);
  EXPECT_EQ(tile_at({12, 9}), 1);
  EXPECT_TRUE(session().path().empty());
}

TEST_F(UiRecovery, AnAnsweredQuitLeavesNothing) {
  paint({12, 9});
  frames(kFiveSeconds);
  key(ctrl('q'));
  frames(3);
  click("question/discard");
  ASSERT_TRUE(session().wants_quit());
  crash_and_start(level_file());
  EXPECT_EQ(find("recovery/recover0"), nullptr);
}

TEST_F(UiRecovery, TheOpenLevelMustBeSavedFirst) {
  paint({12, 9});
  frames(kFiveSeconds);
  crash_and_start(level_file());
  key(kEscapeKey);
  frames(3);
  paint({3, 3});
  click("menu/File");
  frames(2);
  click("menu/file/recover");
  frames(3);
  ASSERT_NE(find("recovery/recover0"), nullptr);
  EXPECT_FALSE(find("recovery/recover0")->enabled);
  click("recovery/recover0");
  frames(2);
  EXPECT_EQ(tile_at({3, 3}), 1);
}

TEST_F(UiRecovery, AFileChangedOutsideIsReadAgain) {
  Level other = test_level();
  other.map.set({1, 1}, 6);
  ASSERT_TRUE(save_level(other, *find_format("native"), level_file()));
  frames(90);
  EXPECT_EQ(tile_at({1, 1}), 6);
  SDL_Event event = {};
  event.type = SDL_WINDOWEVENT;
  event.window.event = SDL_WINDOWEVENT_EXPOSED;
  SDL_PushEvent(&event);
  frames(900);
  ASSERT_TRUE(session().message()) << "it waits for the user to come back";
  move({640, 400});
  frames(900);
  EXPECT_FALSE(session().message());
  key(ctrl('z'));
  EXPECT_EQ(tile_at({1, 1}), 0);
}

TEST_F(UiRecovery, AFileChangedOutsideIsMergedWithUnsavedChanges) {
  paint({12, 9});
  Level other = test_level();
  other.map.set({1, 1}, 6);
  ASSERT_TRUE(save_level(other, *find_format("native"), level_file()));
  frames(90);
  EXPECT_EQ(find("question/keep"), nullptr);
  EXPECT_EQ(tile_at({1, 1}), 6);
  EXPECT_EQ(tile_at({12, 9}), 1);
  EXPECT_TRUE(session().modified());
  key(ctrl('z'));
  EXPECT_EQ(tile_at({1, 1}), 0);
  EXPECT_EQ(tile_at({12, 9}), 1);
}

TEST_F(UiRecovery, WhatBothChangedIsAskedAbout) {
  paint({12, 9});
  Level other = test_level();
  other.map.set({1, 1}, 6);
  other.map.set({12, 9}, 6);
  ASSERT_TRUE(save_level(other, *find_format("native"), level_file()));
  frames(90);
  ASSERT_NE(find("question/keep"), nullptr);
  EXPECT_EQ(find("question/save"), nullptr);
  click("question/reload");
  frames(3);
  EXPECT_EQ(find("question/keep"), nullptr);
  EXPECT_EQ(tile_at({1, 1}), 6);
  EXPECT_EQ(tile_at({12, 9}), 6);
  key(ctrl('z'));
  EXPECT_EQ(tile_at({12, 9}), 1);
}

TEST_F(UiRecovery, NoQuestionComesInTheMiddleOfAStroke) {
  paint({12, 9});
  Level other = test_level();
  other.map.set({12, 9}, 6);
  ASSERT_TRUE(save_level(other, *find_format("native"), level_file()));
  move(on_map({13, 9}));
  press();
  frames(90);
  EXPECT_FALSE(session().question());
  release();
  frames(90);
  EXPECT_TRUE(session().question());
}

TEST_F(UiRecovery, AnIdleWindowDrawsNothing) {
  start(level_file());
  turn_for(2.2);  // finishes the work of the start
  const int before = app().drawn_frames();
  EXPECT_GT(before, 0);
  turn_for(2.2);
  EXPECT_EQ(app().drawn_frames(), before);
  std::ofstream(level_file()) << "{ not a level";
  turn_for(3.2);
  EXPECT_GT(app().drawn_frames(), before + 5) << "a dialog reports the changed file, and is drawn";
}

}  // namespace talus::recovery_test
