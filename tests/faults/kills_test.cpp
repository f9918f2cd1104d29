// The program is killed at any moment while it paints, saves, exports and saves automatically. TALUS_KILLS
// says how often; ./tests/nightly kills it a thousand times.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <random>

#include "platform/autosave.h"
#include "platform/settings.h"
#include "unit/folder_test.h"

namespace talus::kills_test {

namespace fs = std::filesystem;

class Kills : public FolderTest {
 protected:
  std::string level_file() const { return path("a.talus.json"); }
  static constexpr int kWidth = 200;  // cells

  // Gives every cell of row 1 the same tile, so that half of a stroke would show.
  static Edit stroke(const Level& level, TileNumber tile) {
    Edit edit{"Paint", {}};
    for (int x = 0; x < kWidth; ++x)
      edit.changes.push_back(CellChange{{x, 1}, level.map.tile_at({x, 1}), tile});
    return edit;
  }
  static bool is_whole(const Level& level) {
    for (int x = 1; x < kWidth; ++x)
      if (level.map.tile_at({x, 1}) != level.map.tile_at({0, 1})) return false;
    return true;
  }

  // Does what the editor does, quickly, until it is killed.
  [[noreturn]] void work(int says) const {
    Session session(Level(), "", kUnnamed, ExportTools{.read_asset = {}, .record = path("state/exports")});
    Autosave autosave(path("autosave"));
    session.apply(action::OpenFile{level_file()});
    session.finish_reading();
    double now = 0;
    for (int i = 1;; ++i, now += 3) {
      session.apply(action::EditLevel{stroke(session.level(), static_cast<std::uint8_t>(i % 250 + 1))});
      if (autosave.follow(session, now)) ::_exit(2);
      if (i % 3 == 1 && !autosave.save_now(session)) ::_exit(3);
      if (i == 1 && ::write(says, "x", 1) != 1) ::_exit(4);
      if (i % 8 == 0) session.apply(action::SaveFile{});
      if (i % 8 == 2) session.apply(action::RunExports{});
      if (i % 8 == 4 && !save_settings(default_settings(), path("config/settings.json"))) ::_exit(5);
      session.advance(1.0 / 60);
      if (session.question()) session.apply(action::AnswerQuestion{action::Answer::allow});
    }
  }
  // Starts the editor, and kills it `time` µs after it has saved its first stroke automatically.
  void kill_after(useconds_t time) const {
    int pipe[2];
    ASSERT_EQ(::pipe(pipe), 0);
    const pid_t child = ::fork();
    if (child == 0) work(pipe[1]);
    ::close(pipe[1]);
    char ready = 0;
    EXPECT_EQ(::read(pipe[0], &ready, 1), 1);
    ::close(pipe[0]);
    ::usleep(time);
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << status;
  }
  int temporaries() const {
    int count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder_))
      count += entry.path().extension() == ".tmp";
    return count;
  }
};

TEST_F(Kills, LeaveWholeFilesAndOfferTheWork) {
  Level level;
  level.map = TileMap(kWidth, 40);
  level.exports = {{.name = "map", .exporter = "tmj", .path = "out/a.tmj", .extra = {}}};
  ASSERT_TRUE(save_level(level, *find_format("native"), level_file()));
  const char* kills = std::getenv("TALUS_KILLS");
  const int rounds = kills != nullptr ? std::atoi(kills) : 25;
  std::mt19937 random(static_cast<unsigned>(rounds));
  int offered = 0;
  for (int round = 0; round < rounds; ++round) {
    SCOPED_TRACE(round);
    kill_after(static_cast<useconds_t>(random() % 30'000));
    const auto saved = load_level(level_file());
    ASSERT_TRUE(saved) << saved.error().message;
    ASSERT_TRUE(is_whole(saved->level));
    const auto settings = load_settings(path("config/settings.json"));
    ASSERT_TRUE(settings) << settings.error();
    ASSERT_TRUE(!exists("out/a.tmj") || load_level(path("out/a.tmj")));
    const auto works = Autosave(path("autosave")).left_behind();
    ASSERT_LE(works.size(), 1u);
    for (const SavedWork& work : works) {  // empty if it was killed between saving and the next stroke
      ASSERT_EQ(work.problem, "");
      ASSERT_TRUE(is_whole(*work.level));
      ASSERT_TRUE(Autosave::discard(work));
      ++offered;
    }
  }
  EXPECT_GT(offered, rounds / 2);
  // There is at most one temporary file for each file that is written. The next autosave removes those of
  // autosaves.
  EXPECT_LE(temporaries(), 5);
}

}  // namespace talus::kills_test
