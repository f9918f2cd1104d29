// Automatic saving, also when the process is killed.
#include "platform/autosave.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "folder_test.h"
#include "waiting.h"

namespace talus::autosave_test {

namespace fs = std::filesystem;

class AutosaveTest : public FolderTest {
 protected:
  std::string folder() const { return path("state"); }
  static void paint(Session& session, TileNumber tile) {
    Edit edit{"Paint", {CellChange{{1, 1}, session.level().map.tile_at({1, 1}), tile}}};
    session.apply(action::EditLevel{edit});
  }
  int files() const {
    std::error_code error;
    const fs::directory_iterator all(folder(), error);
    return error ? 0 : static_cast<int>(std::distance(begin(all), end(all)));
  }
  // A child process that calls run(say) and ends by being killed. Waits until the child has said something.
  template <class F>
  static pid_t child_of(F run) {
    int pipe[2];
    EXPECT_EQ(::pipe(pipe), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      const auto say = [&] {
        if (::write(pipe[1], "x", 1) != 1) ::_exit(1);
      };
      run(say);
      ::_exit(1);
    }
    ::close(pipe[1]);
    char ready = 0;
    EXPECT_EQ(::read(pipe[0], &ready, 1), 1);
    ::close(pipe[0]);
    return child;
  }
  // Kills the child without giving it a chance to save.
  static void kill_child(pid_t child) {
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status));
  }
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

TEST_F(AutosaveTest, NobodyElseCanReadIt) {
  fs::create_directories(folder());
  fs::permissions(folder(), fs::perms{0755});  // as earlier versions made it
  Session session;
  Autosave autosave(folder());
  paint(session, 5);
  ASSERT_TRUE(autosave.save_now(session));
  EXPECT_EQ(fs::status(folder()).permissions(), fs::perms{0700});
  ASSERT_EQ(files(), 2);
  for (const auto& entry : fs::directory_iterator(folder()))
    EXPECT_EQ(entry.status().permissions(), fs::perms{0600}) << entry.path();
}

TEST_F(AutosaveTest, TheWorkOfAKilledProcessIsFound) {
  const auto now = [] {
    return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now())
        .time_since_epoch()
        .count();
  };
  const std::int64_t before = now();
  kill_child(child_of([&](auto say) {
    Session session(Level(), "/some where/le\"vel.talus.json", "level.talus.json");
    Autosave autosave(folder());
    paint(session, 5);
    if (!autosave.save_now(session)) ::_exit(1);
    say();
    ::pause();
  }));
  Autosave later(folder());
  const std::vector<SavedWork> works = later.left_behind();
  ASSERT_EQ(works.size(), 1u);
  EXPECT_EQ(works[0].path, "/some where/le\"vel.talus.json");
  EXPECT_EQ(works[0].name, "le\"vel.talus.json");
  EXPECT_EQ(works[0].level->map.at({1, 1}), 5);
  EXPECT_GE(works[0].time, before);
  EXPECT_LE(works[0].time, now());
  EXPECT_TRUE(Autosave::discard(works[0]));
  EXPECT_TRUE(later.left_behind().empty());
  EXPECT_EQ(files(), 0);
}

TEST_F(AutosaveTest, AKillDuringAWriteLeavesTheOlderAutosave) {
  for (int round = 0; round < 12; ++round) {
    fs::remove_all(folder());
    const pid_t child = child_of([&](auto say) {
      Session session;
      Autosave autosave(folder());
      for (int tile = 1;; tile = tile % 255 + 1) {
        paint(session, static_cast<TileNumber>(tile));
        if (!autosave.save_now(session)) ::_exit(1);
        say();
      }
    });
    ::usleep(static_cast<useconds_t>(700 * round));
    kill_child(child);
    const std::vector<SavedWork> works = Autosave(folder()).left_behind();
    ASSERT_EQ(works.size(), 1u);
    EXPECT_NE(works[0].level->map.at({1, 1}), 0);
  }
}

TEST_F(AutosaveTest, AutosavesOfARunningProcessAreNotOffered) {
  const pid_t child = child_of([&](auto say) {
    Session session;
    Autosave autosave(folder());
    paint(session, 5);
    if (!autosave.save_now(session)) ::_exit(1);
    say();
    ::pause();
  });
  EXPECT_EQ(files(), 2);
  EXPECT_TRUE(Autosave(folder()).left_behind().empty());
  kill_child(child);
  EXPECT_EQ(Autosave(folder()).left_behind().size(), 1u);
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
  session.apply(action::SaveFileAs{path("level.talus.json")});
  EXPECT_FALSE(autosave.follow(session, 2));
  EXPECT_EQ(files(), 0);
}

TEST_F(AutosaveTest, DamagedFilesAreLeftAlone) {
  fs::create_directories(folder());
  const std::string file = path("state/1-0.talus-autosave");
  for (const char* bytes :
       {"", "{}", "{}\n", "[]\n{\"talus\":1}", "\xff\n{\"talus\":1}", "{}\n{\"talus\":"}) {
    std::ofstream(file, std::ios::binary) << bytes;
    EXPECT_FALSE(read_saved_work(file)) << bytes;
    const std::vector<SavedWork> works = Autosave(folder()).left_behind();
    ASSERT_EQ(works.size(), 1u) << bytes;
    EXPECT_EQ(works[0].level, nullptr);
    EXPECT_EQ(works[0].name, "1-0.talus-autosave");
    EXPECT_TRUE(works[0].problem.starts_with("is damaged: ")) << works[0].problem;
  }
  EXPECT_EQ(files(), 1);
  ASSERT_TRUE(Autosave::discard(Autosave(folder()).left_behind()[0]));
  EXPECT_EQ(files(), 0);
}

TEST_F(AutosaveTest, AnUnreadableFolderIsReported) {
  put("state", "a file in the folder's place");
  const std::vector<SavedWork> works = Autosave(folder()).left_behind();
  ASSERT_EQ(works.size(), 1u);
  EXPECT_EQ(works[0].problem, "cannot be read: Not a directory");
}

TEST_F(AutosaveTest, AnAutosaveLargerThanALevelFileIsOffered) {
  fs::create_directories(folder());
  const SavedWork work{path("state/1-0.talus-autosave"), "", "large", 5, std::make_shared<const Level>()};
  ASSERT_TRUE(write_saved_work(work));
  std::ofstream(work.file, std::ios::app) << std::string(kMaxFileBytes, ' ');  // as a level's text may have
  ASSERT_GT(fs::file_size(work.file), kMaxFileBytes);
  const std::vector<SavedWork> works = Autosave(folder()).left_behind();
  ASSERT_EQ(works.size(), 1u);
  EXPECT_EQ(works[0].problem, "");
  EXPECT_EQ(works[0].name, "large");
}

TEST_F(AutosaveTest, AFailedWriteIsRetriedUntilItSucceeds) {
  put("state", "a file in the folder's place");
  Session session;
  {
    Autosave autosave(folder());
    paint(session, 5);
    for (int second = 0; second < 20; ++second) autosave.follow(session, second);
    ASSERT_TRUE(autosave.problem());
    EXPECT_EQ(autosave.problem()->substr(0, 29), "the folder cannot be created:");
    EXPECT_TRUE(autosave.due());
    fs::remove(folder());
    for (int second = 20; autosave.problem() && second < 60; ++second) {
      autosave.follow(session, second);
      ASSERT_TRUE(comes_true([&] { return !autosave.is_writing(); }));
    }
    EXPECT_FALSE(autosave.problem());
  }
  const std::vector<SavedWork> works = Autosave(folder()).left_behind();
  ASSERT_EQ(works.size(), 1u);
  EXPECT_EQ(works[0].level->map.at({1, 1}), 5);
}

TEST_F(AutosaveTest, ARemovedFolderIsMadeAgain) {
  Session session;
  {
    Autosave autosave(folder());
    paint(session, 5);
    ASSERT_TRUE(autosave.save_now(session));
    fs::remove_all(folder());
    paint(session, 6);
    ASSERT_TRUE(autosave.save_now(session));
    EXPECT_TRUE(Autosave(folder()).left_behind().empty()) << "its process runs";
  }
  const std::vector<SavedWork> works = Autosave(folder()).left_behind();
  ASSERT_EQ(works.size(), 1u);
  EXPECT_EQ(works[0].level->map.at({1, 1}), 6);
}

TEST_F(AutosaveTest, HalfWrittenFilesOfKilledProcessesAreRemoved) {
  fs::create_directories(folder());
  put("state/.1-0.talus-autosave.0.tmp", "half");
  put("state/1-0.talus-autosave.lock", "");
  put("state/2-0.talus-autosave.lock", "");
  put("state/2-0.talus-autosave", "of the lock");
  Session session;
  Autosave autosave(folder());
  paint(session, 5);
  ASSERT_TRUE(autosave.save_now(session));
  EXPECT_FALSE(exists("state/.1-0.talus-autosave.0.tmp"));
  EXPECT_FALSE(exists("state/1-0.talus-autosave.lock"));
  EXPECT_TRUE(exists("state/2-0.talus-autosave.lock"));
}

TEST_F(AutosaveTest, AnUnwritableFolderIsReportedOnce) {
  put("state", "a file in the folder's place");
  Session session;
  Autosave autosave(folder());
  paint(session, 5);
  EXPECT_FALSE(autosave.follow(session, 0));
  EXPECT_TRUE(autosave.follow(session, 10));
  for (int second = 20; second < 60; ++second) EXPECT_FALSE(autosave.follow(session, second));
}

class Recovery : public FolderTest {};

TEST_F(Recovery, IsAChangeOfTheFileThatCanBeUndone) {
  const std::string file = path("level.talus.json");
  Level on_disk;
  on_disk.map.set({2, 2}, 1);
  ASSERT_TRUE(save_level(on_disk, *find_format("native"), file));
  Level unsaved = on_disk;
  unsaved.map.set({2, 2}, 9);
  Session session;
  session.apply(action::RecoverLevel{std::make_shared<const Level>(unsaved), file, "level.talus.json"});
  EXPECT_EQ(session.level(), unsaved);
  EXPECT_EQ(session.path(), file);
  EXPECT_TRUE(session.modified());
  session.apply(action::Undo{});
  EXPECT_EQ(session.level(), on_disk);
}

TEST_F(Recovery, WorksWithoutAFile) {
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
