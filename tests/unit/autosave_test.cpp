// What is saved by itself, also when the process is killed.
#include "platform/autosave.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "edit/map_tools.h"

namespace talus::autosave_test {

namespace fs = std::filesystem;

class AutosaveTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) / ("talus-autosave-" + std::to_string(::getpid()));
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string folder() const { return (folder_ / "state").string(); }
  static void paint(Session& session, std::uint8_t tile) {
    Edit edit{"Paint", {CellChange{{1, 1}, session.level().map.at({1, 1}), tile}}};
    session.apply(action::EditLevel{edit});
  }
  int files() const {
    std::error_code error;
    const fs::directory_iterator all(folder(), error);
    return error ? 0 : static_cast<int>(std::distance(begin(all), end(all)));
  }
  // Runs in a child that is killed, without any farewell, `wait` after it said that it had come so far.
  template <class F>
  static void killed(F run) {
    int pipe[2];
    ASSERT_EQ(::pipe(pipe), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      run();
      if (::write(pipe[1], "x", 1) != 1) ::_exit(1);
      for (;;) ::pause();
    }
    char ready = 0;
    ASSERT_EQ(::read(pipe[0], &ready, 1), 1);
    ::close(pipe[0]);
    ::close(pipe[1]);
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
  }

  fs::path folder_;
};

TEST_F(AutosaveTest, NothingIsWrittenWithoutChanges) {
  Session session;
  Autosave autosave(folder());
  for (int second = 0; second < 20; ++second) EXPECT_FALSE(autosave.follow(session, second));
  EXPECT_FALSE(autosave.due());
  EXPECT_EQ(files(), 0);
}

TEST_F(AutosaveTest, AChangeIsWrittenWithinFiveSecondsAndOnceOnly) {
  Session session(Level(), "", "my level");
  Autosave autosave(folder());
  paint(session, 5);
  EXPECT_FALSE(autosave.follow(session, 100));
  EXPECT_EQ(autosave.due(), 100 + Autosave::kDelay);
  EXPECT_LT(Autosave::kDelay, 5);
  EXPECT_FALSE(autosave.follow(session, 100 + Autosave::kDelay - 0.1));
  EXPECT_EQ(files(), 0);
  EXPECT_FALSE(autosave.follow(session, 100 + Autosave::kDelay));
  EXPECT_FALSE(autosave.due());
  EXPECT_TRUE(autosave.save_now(session)) << "waits for the thread, too";
  EXPECT_EQ(files(), 2) << "the level and the lock";
  EXPECT_TRUE(autosave.left_behind().empty()) << "its process runs";
}

TEST_F(AutosaveTest, WhatAKilledProcessLeftIsFoundWhole) {
  killed([&] {
    Session session(Level(), "/some where/le\"vel.talus.json", "level.talus.json");
    Autosave autosave(folder());
    paint(session, 5);
    if (!autosave.save_now(session)) ::_exit(1);
  });
  Autosave later(folder());
  const std::vector<SavedWork> works = later.left_behind();
  ASSERT_EQ(works.size(), 1u);
  EXPECT_EQ(works[0].path, "/some where/le\"vel.talus.json");
  EXPECT_EQ(works[0].name, "le\"vel.talus.json");
  EXPECT_EQ(works[0].level->map.at({1, 1}), 5);
  const std::int64_t now =
      std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch())
          .count();
  EXPECT_NEAR(static_cast<double>(works[0].time), static_cast<double>(now), 60);
  Autosave::discard(works[0]);
  EXPECT_TRUE(later.left_behind().empty());
  EXPECT_EQ(files(), 0);
}

TEST_F(AutosaveTest, AKillWhileItIsWritingLeavesTheWorkBeforeWhole) {
  for (int round = 0; round < 12; ++round) {
    fs::remove_all(folder_);
    int pipe[2];
    ASSERT_EQ(::pipe(pipe), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      Session session;
      Autosave autosave(folder());
      for (int tile = 1;; tile = tile % 255 + 1) {
        paint(session, static_cast<std::uint8_t>(tile));
        if (!autosave.save_now(session) || ::write(pipe[1], "x", 1) != 1) ::_exit(1);
      }
    }
    char ready = 0;
    ASSERT_EQ(::read(pipe[0], &ready, 1), 1);
    ::usleep(static_cast<useconds_t>(700 * round));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ::close(pipe[0]);
    ::close(pipe[1]);
    const std::vector<SavedWork> works = Autosave(folder()).left_behind();
    ASSERT_EQ(works.size(), 1u);
    EXPECT_NE(works[0].level->map.at({1, 1}), 0);
  }
}

TEST_F(AutosaveTest, WhatARunningProcessHasIsNotOffered) {
  int pipe[2];
  ASSERT_EQ(::pipe(pipe), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    Session session;
    Autosave autosave(folder());
    paint(session, 5);
    if (!autosave.save_now(session) || ::write(pipe[1], "x", 1) != 1) ::_exit(1);
    for (;;) ::pause();
  }
  char ready = 0;
  ASSERT_EQ(::read(pipe[0], &ready, 1), 1);
  EXPECT_EQ(files(), 2);
  EXPECT_TRUE(Autosave(folder()).left_behind().empty());
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(Autosave(folder()).left_behind().size(), 1u);
  ::close(pipe[0]);
  ::close(pipe[1]);
}

TEST_F(AutosaveTest, SavingAndUndoRemoveIt) {
  Session session;
  Autosave autosave(folder());
  paint(session, 5);
  ASSERT_TRUE(autosave.save_now(session));
  session.apply(action::Undo{});
  EXPECT_FALSE(autosave.follow(session, 1));
  EXPECT_EQ(files(), 0);
  paint(session, 6);
  ASSERT_TRUE(autosave.save_now(session));
  session.apply(action::SaveFileAs{(folder_ / "level.talus.json").string()});
  EXPECT_FALSE(autosave.follow(session, 2));
  EXPECT_EQ(files(), 0);
}

TEST_F(AutosaveTest, DamagedFilesAreLeftAlone) {
  fs::create_directories(folder());
  const std::string file = (fs::path(folder()) / "1-0.talus-autosave").string();
  for (const char* bytes :
       {"", "{}", "{}\n", "[]\n{\"talus\":1}", "\xff\n{\"talus\":1}", "{}\n{\"talus\":"}) {
    std::ofstream(file, std::ios::binary) << bytes;
    EXPECT_FALSE(read_saved_work(file)) << bytes;
    EXPECT_TRUE(Autosave(folder()).left_behind().empty()) << bytes;
  }
  EXPECT_EQ(files(), 1);
}

TEST_F(AutosaveTest, AFolderThatCannotBeWrittenIsToldOnce) {
  std::ofstream(folder_) << "a file in the folder's place";
  Session session;
  Autosave autosave(folder());
  paint(session, 5);
  EXPECT_FALSE(autosave.follow(session, 0));
  EXPECT_TRUE(autosave.follow(session, 10));
  EXPECT_FALSE(autosave.follow(session, 20));
  fs::remove(folder_);
}

TEST(Recovery, ComesAsAChangeOfTheFileThatCanBeUndone) {
  const fs::path file =
      fs::path(::testing::TempDir()) / ("talus-recover-" + std::to_string(::getpid()) + ".talus.json");
  Level on_disk;
  on_disk.map.set({2, 2}, 1);
  ASSERT_TRUE(save_level(on_disk, *find_format("native"), file.string()));
  Level unsaved = on_disk;
  unsaved.map.set({2, 2}, 9);
  Session session;
  session.apply(
      action::RecoverLevel{std::make_shared<const Level>(unsaved), file.string(), file.filename().string()});
  EXPECT_EQ(session.level(), unsaved);
  EXPECT_EQ(session.path(), file.string());
  EXPECT_TRUE(session.modified());
  session.apply(action::Undo{});
  EXPECT_EQ(session.level(), on_disk);
  fs::remove(file);
}

TEST(Recovery, WorksWithoutAFile) {
  Level unsaved;
  unsaved.map.set({2, 2}, 9);
  Session session;
  session.apply(action::RecoverLevel{std::make_shared<const Level>(unsaved), "", "demo (copy)"});
  EXPECT_EQ(session.level(), unsaved);
  EXPECT_EQ(session.file_name(), "demo (copy)");
  EXPECT_TRUE(session.path().empty());
  EXPECT_TRUE(session.modified());
}

}  // namespace talus::autosave_test
